"""What each command does."""

from __future__ import annotations

import json
import sys
from argparse import Namespace
from pathlib import Path

from app.cli.expression import asked_expression
from app.cli.figures import figures, figures_text
from app.cli.progress import ProgressLine
from app.cli.screen import Screen
from facemodel.cache import cached_solution, keep_solution, solve_cached
from facemodel.errors import ProjectError
from facemodel.faces import DEFAULT_FACE
from facemodel.folders import cache_folder
from facemodel.io.disk import checked_target
from facemodel.io.project_file import load_project, save_project
from facemodel.project import Project
from facemodel.projects import new_project
from facemodel.sculpted import sculpted_solution
from facemodel.sculpting.corrected import Corrector
from facemodel.solve import Solution, solve_project


def new(asked: Namespace) -> int:
    """Begin a project."""
    out: Path = asked.out
    project = new_project(asked.face or DEFAULT_FACE)
    if checked_target(out).exists() and not asked.replace:
        raise ProjectError(f"“{out}” exists already; choose another name, or add --replace to write over it.")
    save_project(project, out)
    print(f"Wrote {out} with the face {project.face.title}")
    return 0


def solve(asked: Namespace) -> int:
    """Solve all fields and keep them."""
    project = load_project(asked.project)
    kept = cached_solution(project)
    if kept is not None:
        print(f"{asked.project} is solved already: {len(kept.basis.names)} fields, {kept.unknowns:,} unknowns")
        return 0
    line = ProgressLine(sys.stderr)
    try:
        solution = solve_project(project, line)
    finally:
        line.clear()
    if not keep_solution(project, solution):
        raise ProjectError(
            f"“{asked.project}” is solved, but the solution cannot be kept in “{cache_folder()}”: "
            "free some space there, or name another folder in the variable RISORIUS_CACHE."
        )
    seconds = sum(solution.seconds.values())
    print(f"Solved {len(solution.basis.names)} fields with {solution.unknowns:,} unknowns in {seconds:.1f} s")
    return 0


def info(asked: Namespace) -> int:
    """Show the figures."""
    project = load_project(asked.project)
    kept = cached_solution(project)
    known = figures(asked.project, project, None if kept is None else Corrector()(kept, project))
    print(json.dumps(known, indent=1, ensure_ascii=False) if asked.json else figures_text(known))
    return 0


def render(asked: Namespace, screen: Screen) -> int:
    """Draw one picture."""
    _check_picture(asked.out)
    project = load_project(asked.project)
    expression = asked_expression(project, asked.emotion, asked.au)
    solution = solved(project, asked.basis)
    screen.render(project, solution, expression, asked.out, asked.view, asked.size, asked.show, asked.linear)
    print(f"Wrote {asked.out}")
    return 0


def gallery(asked: Namespace, screen: Screen) -> int:
    """Draw the sheet."""
    _check_picture(asked.out)
    project = load_project(asked.project)
    screen.gallery(project, solved(project, asked.basis), asked.out)
    print(f"Wrote {asked.out}")
    return 0


def edit(asked: Namespace, screen: Screen) -> int:
    """Open the editor."""
    return screen.edit(asked.project)


def _check_picture(out: Path) -> None:
    """Find out before the work, not after it, that a picture cannot be written."""
    if out.suffix.lower() != ".png":
        raise ProjectError(f"“{out}” cannot be saved: pictures are PNG files; let the name end in .png.")
    checked_target(out)


def solved(project: Project, basis: str) -> Solution:
    """The solution of a project from the cache, or a new one, with what is sculpted on it."""
    line = ProgressLine(sys.stderr)
    try:
        solution = solve_cached(project, line)
    finally:
        line.clear()
    return sculpted_solution(project, solution) if basis == "sculpted" else Corrector()(solution, project)

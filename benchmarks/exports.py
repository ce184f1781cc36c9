"""What it takes to film the demo at 1280 x 720, and to write it in the formats of other programs."""

from __future__ import annotations

import tempfile
from collections.abc import Iterator
from dataclasses import replace
from functools import partial
from pathlib import Path

import numpy as np

from app.film import ANTIALIAS, Film, shoot
from app.film.order import KINDS, Order, fulfil
from benchmarks.figure import Figure, alone, interleaved
from facemodel.animation.demo import demo_animation
from facemodel.cache import solve_cached
from facemodel.io.export import Asked
from facemodel.project import Project
from facemodel.projects import new_project
from facemodel.solution import Solution
from ui.launch import frames

FILMED = (3.0, 4.0)
"""Seconds of the piece that are filmed; every frame costs about the same."""

FEW = 8
"""Shapes that viewers on phones take."""

MEGABYTE = 1e6


def figures() -> Iterator[Figure]:
    """Measure films, then models, meshes and weights."""
    project = new_project()
    solution = solve_cached(project)
    animated = replace(project, animation=demo_animation(project.units))
    with tempfile.TemporaryDirectory() as folder:
        yield from _films(animated, solution, Path(folder))
        yield from _files(animated, solution, Path(folder))


def _films(project: Project, solution: Solution, folder: Path) -> Iterator[Figure]:
    for antialias, title in ANTIALIAS.items():
        film = Film(span=FILMED, antialias=antialias, audible=False)
        take = film.take(project)
        path = folder / "film.mp4"
        taken = interleaved({"film": partial(shoot, take, solution, film, path, frames)}, 1)["film"] / len(take)
        size = path.stat().st_size / MEGABYTE / take.duration
        yield alone(f"a frame of {film.size[0]} x {film.size[1]}, MP4 ({title.lower()}), {size:.2f} MB a second", taken)


def _files(project: Project, solution: Solution, folder: Path) -> Iterator[Figure]:
    few = Asked(shaping="clip", most=FEW)
    for key, asked, words in (
        (".glb", Asked(), "action units"),
        (".glb", few, f"{FEW} shapes"),
        (".usdc", Asked(), "action units"),
        (".usdc", few, f"{FEW} shapes"),
        (".ply", Asked(span=FILMED), "one second"),
        ("live-link", Asked(), "all of it"),
        ("fap", Asked(), "all of it"),
    ):
        kind = KINDS[key]
        out = folder / f"demo{kind.suffix}"
        order = Order(out, key, Film(), asked)
        taken = interleaved({"write": partial(fulfil, order, project, lambda: solution, frames)}, 1)["write"]
        size = np.sum([path.stat().st_size for path in folder.glob(f"demo*{kind.suffix}")]) / MEGABYTE
        yield alone(f"the demo as {kind.title} ({words}), {size:.2f} MB", taken)

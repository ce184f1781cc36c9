"""``risorius export``: the face, or its animation, for other programs."""

from __future__ import annotations

import sys
from argparse import Namespace
from pathlib import Path

from app.cli.commands import solved
from app.cli.expression import asked_expression
from app.cli.ordering import asked_span
from app.cli.progress import ProgressLine
from app.film.ending import told_to_end
from app.film.order import counted
from facemodel.io.disk import checked_target
from facemodel.io.export import Asked, export_of, export_project, export_sequence
from facemodel.io.project_file import load_project


def export(asked: Namespace) -> int:
    """Write the face for other programs."""
    out: Path = asked.out
    export_of(out)
    checked_target(out)
    project = load_project(asked.project)
    posed = project.posed(asked_expression(project, asked.emotion, asked.au))
    span = asked_span(asked.range, asked.fps or project.animation.rate)
    wanted = Asked(not asked.still, asked.fps, span, asked.shapes, asked.most)
    solution = solved(project, asked.basis)
    line = ProgressLine(sys.stderr)
    try:
        with told_to_end():
            if asked.sequence:
                said = counted(export_sequence(posed, solution, out, wanted, line), "numbered file")
            else:
                said = export_project(posed, solution, out, wanted, line)
    finally:
        line.clear()
    print(f"Wrote {out}: {said}")
    return 0

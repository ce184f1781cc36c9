"""The figures of a face and of its solution, as pairs of words."""

from __future__ import annotations

from facemodel.actions import skin_fields
from facemodel.project import Project
from facemodel.solve import Solution

Figures = tuple[tuple[str, tuple[tuple[str, str], ...]], ...]
"""Sections of (name, value)."""


def face_figures(project: Project, solution: Solution | None) -> Figures:
    """What can be said of a face: its size, its chart, its solution, where it comes from."""
    face = project.face
    solved = int(face.solved.sum())
    sections = [
        (
            "Face",
            (
                ("Individual", face.title),
                ("Vertices", _whole(len(face.skin.positions))),
                ("Elements solved", f"{_whole(solved)} of {_whole(len(face.skin.triangles))}"),
                ("Element", project.settings.element.upper().replace("HCT", "HCT-")),
                ("Muscles", _whole(len(project.muscles))),
                ("Action units", f"{len(project.units)} ({len(skin_fields(project.units))} fields)"),
            ),
        )
    ]
    if solution is not None:
        sections += [("Chart", _chart_lines(solution)), ("Solution", _solution_lines(solution))]
    return tuple(sections)


def _chart_lines(solution: Solution) -> tuple[tuple[str, str], ...]:
    chart = solution.chart
    return (
        ("Flipped triangles", _whole(chart.flips)),
        ("Stretch, worst", f"{chart.worst:.2f}"),
        ("Stretch, 95 % below", f"{chart.p95:.2f}"),
    )


def _solution_lines(solution: Solution) -> tuple[tuple[str, str], ...]:
    display = solution.basis.display
    steps = tuple((f"{step.capitalize()}", f"{took:.2f} s") for step, took in solution.seconds.items())
    return (
        ("Unknowns", _whole(solution.unknowns)),
        ("Fields", _whole(len(solution.basis.names))),
        ("Points drawn", _whole(len(display.points))),
        *steps,
        ("Together", f"{sum(solution.seconds.values()):.2f} s"),
    )


def _whole(number: int) -> str:
    return f"{number:,}".replace(",", " ")

"""The figures of a project, as ``risorius info`` shows them."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np

from facemodel.chart import chart_figures
from facemodel.io.export.targets import target_field, targets
from facemodel.mesh import Mesh
from facemodel.project import Project
from facemodel.solve import Solution


def figures(path: Path, project: Project, solution: Solution | None) -> dict[str, Any]:
    """All figures as JSON; what only a solution knows is null without one."""
    face = project.face
    chart = chart_figures(Mesh(face.skin.positions, face.skin.triangles[face.solved]), face.chart)
    return {
        "file": str(path),
        "face": {
            "key": face.key,
            "title": face.title,
            "vertices": len(face.skin.positions),
            "triangles": len(face.skin.triangles),
            "solved_triangles": int(face.solved.sum()),
            "boundary_loops": sorted(len(loop) for loop in face.skin.boundary_loops),
            "parts": {part.name: len(part.mesh.positions) for part in face.parts},
            "provenance": face.provenance,
        },
        "chart": {"flips": chart.flips, "worst_stretch": chart.worst, "p95_stretch": chart.p95},
        "element": project.settings.element,
        "density": project.settings.density,
        "solved": solution is not None,
        "unknowns": None if solution is None else solution.unknowns,
        "drawn_points": None if solution is None else len(solution.basis.display.points),
        "seconds": None if solution is None else dict(solution.seconds),
        "muscles": [muscle.key for muscle in project.muscles],
        "units": _units(project, solution),
        "emotions": [emotion.name for emotion in project.emotions],
        "expression": dict(project.expression),
        "landmarks": {name: face.skin.positions[vertex].tolist() for name, vertex in face.landmarks.items()},
    }


def _units(project: Project, solution: Solution | None) -> list[dict[str, Any]]:
    """Every action unit with its peak in millimetres, both sides together."""
    peaks: dict[str, float] = {}
    if solution is not None:
        for shape in targets(project.units, solution.basis):
            moved = np.linalg.norm(target_field(shape, solution.basis), axis=1)
            peaks[shape.name] = float(moved.max(initial=0.0))
    return [
        {
            "number": unit.number,
            "name": unit.name,
            "paired": unit.paired,
            "wanted_mm": unit.amplitude,
            "peak_mm": peaks.get(str(unit.number)),
        }
        for unit in project.units
    ]


def figures_text(known: dict[str, Any]) -> str:
    """The figures for people."""
    face, chart = known["face"], known["chart"]
    solved = known["solved"]
    rows = [
        ("file", known["file"]),
        ("face", f"{face['title']}, {face['vertices']:,} vertices, {face['triangles']:,} triangles"),
        ("solved part", f"{face['solved_triangles']:,} triangles, {known['element'].upper()}"),
        ("boundary loops", ", ".join(f"{count} edges" for count in face["boundary_loops"])),
        ("chart", f"{chart['flips']} flipped triangles"),
        ("stretch", f"{chart['worst_stretch']:.2f} at worst, {chart['p95_stretch']:.2f} in the 95th percentile"),
        ("unknowns", f"{known['unknowns']:,}" if solved else "not known before it is solved"),
        ("drawn", f"{known['drawn_points']:,} points" if solved else f"{known['density']} segments per edge"),
        ("cache", _cache_text(known)),
        ("muscles", str(len(known["muscles"]))),
        ("landmarks", str(len(known["landmarks"]))),
        ("emotions", ", ".join(known["emotions"])),
        ("expression", ", ".join(f"{k} {v:g}" for k, v in known["expression"].items()) or "neutral"),
        ("action units", "peak motion of the skin" if solved else "run “risorius solve” to see how far they move"),
    ]
    lines = [f"{name:<16}{text}".rstrip() for name, text in rows]
    return "\n".join(lines + [_unit_text(unit) for unit in sorted(known["units"], key=lambda unit: unit["number"])])


def _cache_text(known: dict[str, Any]) -> str:
    if not known["solved"]:
        return "not solved yet"
    return f"solved in {sum(known['seconds'].values()):.1f} s and kept"


def _unit_text(unit: dict[str, Any]) -> str:
    sides = "left and right" if unit["paired"] else ""
    peak = "" if unit["peak_mm"] is None else f"{unit['peak_mm']:5.1f} mm"
    return f"  {unit['number']:>3}  {unit['name']:<28}{sides:<16}{peak}".rstrip()

"""How the time and the memory of a solve grow with the number of the face's vertices.

    python -m benchmarks.growth VERTICES

solves the default face refined to so many vertices in a process of its own, so that its memory is its own.
"""

from __future__ import annotations

import json
import sys
import time
from collections.abc import Iterator
from dataclasses import replace
from typing import Any

import numpy as np

from benchmarks.figure import Figure, readable, told_by
from benchmarks.shapes import refined
from facemodel.project import Settings
from facemodel.projects import new_project
from facemodel.solve import solve_project

SIZES = (3_420, 6_500, 12_000, 20_000)
STEPS = ("surface", "assembly", "factorisation", "solve")


def figures() -> Iterator[Figure]:
    """Solve from 3 to 20 thousand vertices and fit how it grows."""
    found = [_measured(size) for size in SIZES]
    for one in found:
        steps = ", ".join(f"{name} {one['steps'][name]:.1f}" for name in STEPS)
        what = f"solve of {one['vertices']:,} vertices, {one['unknowns']:,} unknowns ({steps} s)"
        yield Figure(what, *readable(np.array([one["seconds"]])))
        if one["peak_mb"] is not None:
            yield Figure(
                f"its memory at most, {one['peak_mb'] - one['before_mb']:.0f} MB of it for the solve",
                one["peak_mb"],
                "MB",
            )
    unknowns = np.log([one["unknowns"] for one in found])
    seconds = np.polyfit(unknowns, np.log([one["seconds"] for one in found]), 1)[0]
    yield Figure("time grows with the unknowns to the power of", float(seconds), "")
    if all(one["peak_mb"] is not None for one in found):
        used = [one["peak_mb"] - one["before_mb"] for one in found]
        yield Figure(
            "memory grows with the unknowns to the power of", float(np.polyfit(unknowns, np.log(used), 1)[0]), ""
        )


def _measured(size: int) -> dict[str, Any]:
    command = [sys.executable, "-m", "benchmarks.growth", str(size)]
    return json.loads(told_by(command))


def solved(size: int) -> dict[str, Any]:
    """Solve the default face with so many vertices."""
    project = new_project()
    face = project.face
    if size > len(face.skin.positions):
        face = refined(face, size)
    project = replace(project, face=face, settings=Settings(density=1))
    before = peak_megabytes()
    start = time.perf_counter()
    solution = solve_project(project)
    return {
        "vertices": len(face.skin.positions),
        "unknowns": solution.unknowns,
        "seconds": time.perf_counter() - start,
        "steps": dict(solution.seconds),
        "before_mb": before,
        "peak_mb": peak_megabytes(),
    }


def peak_megabytes() -> float | None:
    """The most memory this process ever had, or None where the system does not tell."""
    if sys.platform == "win32":
        return None
    import resource

    unit = 1e6 if sys.platform == "darwin" else 1e3
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / unit


if __name__ == "__main__":
    print(json.dumps(solved(int(sys.argv[1]))))

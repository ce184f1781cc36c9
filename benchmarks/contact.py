"""Jaw, lids and lips against what they may be off at most, and what it costs to keep them so; lips of all faces."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from benchmarks.figure import Figure, compared, interleaved
from benchmarks.mouths import PosedMouth
from benchmarks.opening import folded, incisors_apart
from benchmarks.touching import MouthDepths, in_eyeball, random_mixes, seen_of_eyeball
from facemodel.cache import solve_cached
from facemodel.comparison import compared as against_full
from facemodel.comparison import in_full
from facemodel.faces import face_keys
from facemodel.kinematics import rig_of
from facemodel.project import Project
from facemodel.projects import new_project
from facemodel.solution import Solution
from facemodel.superposition import Superposition

MIXES = 10_000
REPEATS = 41
ANGLES = (0.1, 0.25, 0.5, 0.75, 1.0)
"""Weights of the mouth's widest opening at which it is compared with a full solution."""

OFF_THE_ARC, OPEN, GAP, DEEPEST, COST = 0.5, 40.0, 0.3, 0.3, 1.0
"""Millimetres, and share of the superposition, that are good enough."""

BLINKS = ({"43": 1.0}, {"43": 1.0, "7": 1.0, "6": 1.0}, {"43": 1.0, "4": 1.0, "9": 1.0}, {"43": 1.0, "12": 1.0})


def figures() -> Iterator[Figure]:
    """Measure jaw, lids, cost and lips, which take some minutes for each face, last."""
    project = new_project()
    solution = solve_cached(project)
    yield from _jaw(project, solution)
    yield from _lids(project, solution)
    yield _cost(project, solution)
    for key in face_keys():
        yield from _lips(key)


def _within(what: str, value: float, limit: float, against: str) -> Figure:
    return Figure(what, value, "mm", against, value / limit, 1.0)


def _jaw(project: Project, solution: Solution) -> Iterator[Figure]:
    posed, basis = Superposition(project.face, solution.basis), solution.basis
    mixes = [{"27": angle} for angle in ANGLES] + [{"26": 0.8, "27": 0.6, "12L": 0.7}]
    solved = [(mix, in_full(project, mix)) for mix in mixes]
    off, kept = (
        max(against_full(project, mix, basis, whole, contact=contact).largest for mix, whole in solved)
        for contact in (False, True)
    )
    yield _within("jaw off a full solution at most", off, OFF_THE_ARC, f"{OFF_THE_ARC} mm")
    yield Figure("the same with lids and lips kept out of what they meet, which no solution does", kept, "mm")
    posed.pose({"27": 1.0})
    apart = incisors_apart(project.face, posed)
    yield Figure("between the incisors at full opening", apart, "mm", f"at least {OPEN:g} mm", OPEN / apart, 1.0)
    yield Figure(f"triangles folded over at full opening: {folded(posed)}")


def _lids(project: Project, solution: Solution) -> Iterator[Figure]:
    posed = Superposition(project.face, solution.basis, rig_of(project.units))
    gap, inside = 0.0, -np.inf
    for eye in project.face.eyes:
        for blink in BLINKS:
            posed.pose({f"{number}{eye.side}": weight for number, weight in blink.items()})
            gap, inside = max(gap, seen_of_eyeball(eye, posed)), max(inside, in_eyeball(eye, posed))
    yield _within("eyeball seen between closed lids", gap, GAP, f"{GAP} mm")
    yield Figure("lids within the eyeball", max(inside, 0.0), "mm")


def _cost(project: Project, solution: Solution) -> Figure:
    kept, straight = (Superposition(project.face, solution.basis, linear=linear) for linear in (False, True))
    random = np.random.default_rng(0)
    mixes = [
        dict(zip(solution.basis.names, random.uniform(0.1, 1.0, len(solution.basis.names)).tolist(), strict=True))
        for _ in range(REPEATS + 1)
    ]
    first, second = iter(mixes), iter(mixes)
    steps = {"linear": lambda: straight.pose(next(first)), "kept": lambda: kept.pose(next(second))}
    taken = interleaved(steps, REPEATS)
    more = np.maximum(taken["kept"] - taken["linear"], 0.0)
    what = f"arc, lids and lips, {solution.basis.display.moving} points, all sliders changed"
    return compared(what, more, "superposition", taken["linear"], COST)


def _lips(key: str) -> Iterator[Figure]:
    project = new_project(key)
    basis = solve_cached(project).basis
    depths, posed = MouthDepths(project.face, basis), PosedMouth(project.face, basis)
    each = [
        (depths.in_each_other(posed), depths.in_teeth(posed)) for _ in posed.poses(random_mixes(basis.names, MIXES))
    ]
    for what, found in zip(("in each other", "in the teeth"), np.array(each).T, strict=True):
        yield _within(
            f"lips of {key} {what} at most, {MIXES} random mixes", float(found.max()), DEEPEST, f"{DEEPEST} mm"
        )
        yield Figure(f"mixes in which lips of {key} are {what} deeper than that: {(found > DEEPEST).sum()}")

"""Lips see every tooth, its bulge and the gap beside it, and stay before it while they are pressed on each other."""

from collections.abc import Callable

import numpy as np
import pytest

from benchmarks.touching import MouthDepths
from facemodel.actions import Expression
from facemodel.cache import solve_cached
from facemodel.contact.arch import FAR, depth_in
from facemodel.contact.teeth import CLEARANCE, rows_of_teeth
from facemodel.face import Face
from facemodel.faces import face_keys
from facemodel.projects import new_project
from facemodel.superposition import Superposition

SEEN = 0.85
"""Share of the directions of an arch in which its teeth show their front: at its ends they show their backs."""

ROLLED_IN: tuple[Expression, ...] = (
    {"28": 0.97, "23": 0.81, "6R": 0.73, "44L": 0.59, "19": 0.24},
    {"28": 0.94, "12R": 0.88, "38L": 0.69, "1L": 0.65, "19": 0.25, "42L": 0.18},
)
"""Lips between the teeth, which being kept apart once took back into these."""


@pytest.mark.parametrize("key", face_keys())
def test_no_vertex_of_a_tooth_stands_out_of_the_front_that_lips_see(shipped: Callable[[str], Face], key: str) -> None:
    face = shipped(key)
    rows, meshes = rows_of_teeth(face), [part.mesh for part in face.parts if part.kind == "teeth"]
    assert len(rows) == len(meshes) == 2
    for row, mesh in zip(rows, meshes, strict=True):
        arch = row.arch
        right, front = mesh.positions[:, 0] - arch.axis[0], mesh.positions[:, 2] - arch.axis[1]
        half = right / np.maximum(np.hypot(right, front) + front, 1 / FAR)
        inside = mesh.positions[np.abs(half) < SEEN * abs(arch.half)]
        depths = np.array([depth_in(arch, *place)[0] for place in inside])
        assert len(inside) > 40
        assert depths.min() > -CLEARANCE


def test_lips_that_are_rolled_in_and_pressed_end_before_the_teeth() -> None:
    project = new_project("ben")
    basis = solve_cached(project).basis
    depths, posed = MouthDepths(project.face, basis), Superposition(project.face, basis)
    for mix in ROLLED_IN:
        posed.pose(mix)
        assert depths.in_teeth(posed) < 0.1
        assert depths.in_each_other(posed) < 0.2

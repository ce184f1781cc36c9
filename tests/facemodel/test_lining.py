"""The lining of a mouth goes with the lips at its rim, and with the jaw under the teeth and the tongue."""

import numpy as np
import pytest

from facemodel.basis import Basis
from facemodel.cache import solve_cached
from facemodel.face import Face, Part
from facemodel.faces import face_keys
from facemodel.jaw.lining import lining_of
from facemodel.jaw.modes import JawMode, mode_motion
from facemodel.jaw.opening import incisal_edge
from facemodel.projects import new_project
from facemodel.superposition import Superposition
from tests.facemodel.places import vertex_fields
from tests.facemodel.skin import sizes

ABOUT = 14.0
"""Millimetres about the edge of the lower incisors in which the floor of the mouth is looked at."""


def lining_part(face: Face) -> Part:
    return next(part for part in face.parts if part.kind == "lining")


@pytest.mark.parametrize("key", face_keys())
def test_the_lower_teeth_stand_out_of_the_floor_of_a_mouth_that_opens_wide(key: str) -> None:
    """As far as at rest, to two millimetres: a floor that went the lip's way came up to their edges and beyond."""
    project = new_project(key)
    posed = Superposition(project.face, solve_cached(project).basis)
    row = next(part for part in project.face.parts if part.kind == "teeth" and part.carrier == "jaw")
    edge, part, lining = incisal_edge(row), lining_part(project.face), lining_of(project.face)
    assert lining is not None
    rest = part.mesh.positions
    away = sizes(rest - row.mesh.positions[edge])
    floor = (lining.of_jaw > 0.9) & (lining.of_skin < 0.1) & (away < ABOUT)
    assert floor.any()
    posed.pose({"27": 1.0})
    after = sizes(posed.parts[part.name][floor] - posed.parts[row.name][edge])
    assert np.abs(after - away[floor]).max() < 2.0


def test_its_rim_goes_with_the_skin_and_its_depth_with_the_bone_of_either_jaw(face: Face) -> None:
    lining = lining_of(face)
    assert lining is not None
    skin, mode = np.random.default_rng(0).normal(size=face.skin.positions.shape), JawMode(0)
    carried = np.einsum("pk,pkc->pc", lining.part.shares, skin[lining.part.anchors])
    gone = carried + lining.beyond_rim(mode, skin)
    bone = mode_motion(face.skull.jaw, mode, lining.part.mesh.positions)
    rim, deep = lining.part.shares.max(axis=1) > 1 - 1e-9, lining.of_skin == 0
    below, above = deep & (lining.of_jaw == 1), deep & (lining.of_jaw == 0)
    assert min(below.sum(), above.sum(), rim.sum()) > 20
    assert gone[rim] == pytest.approx(carried[rim], abs=1e-9)
    assert gone[below] == pytest.approx(bone[below], abs=1e-9)
    assert gone[above] == pytest.approx(0.0, abs=1e-9)


def test_where_no_jaw_turns_it_is_carried_by_its_rim_alone(face: Face, basis: Basis) -> None:
    part, skin = lining_part(face), vertex_fields(face, basis)["12L"]
    carried = np.einsum("pk,pkc->pc", part.shares, skin[part.anchors])
    assert basis.carried_field("12L", part.name) == pytest.approx(carried, abs=1e-4)

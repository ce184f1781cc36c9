"""What pushes the lips does on every face that ships what it does on the first one, however far lips stand out."""

from functools import cache

import pytest

from facemodel.basis import Basis
from facemodel.face import Face
from facemodel.faces import face_keys
from facemodel.project import Project, Settings
from facemodel.projects import new_project
from facemodel.solve import solve_project
from fem.types import FloatArray
from tests.facemodel.places import vertex_fields

EVERY_FACE = pytest.mark.parametrize("key", face_keys())

PURSING = (17, 18, 22, 34)

TOGETHER = 0.5
"""Millimetres that lips may come apart by in the middle of the sum: less than they lie on each other at rest."""

PARTED = 10.5
"""Millimetres beyond which a funnel would be a gape: that which an artist sculpted parts the lips by ten."""

FORWARD, INWARD = 3.5, 5.0
"""Millimetres that pushed lips come forward at least, and corners of a pursed mouth inward; of some 12 in all."""


@cache
def moves(key: str) -> tuple[Face, dict[str, FloatArray]]:
    """A face, and by their numbers what its pursing units move each vertex of its skin by."""
    shipped = new_project(key)
    units = tuple(unit for unit in shipped.units if unit.number in PURSING)
    basis: Basis = solve_project(Project(shipped.face, shipped.muscles, units, (), settings=Settings(density=1))).basis
    fields = vertex_fields(shipped.face, basis)
    return shipped.face, {str(unit.number): sum(fields[name] for name in unit.fields) for unit in units}


def moved(key: str, unit: str, landmark: str) -> FloatArray:
    face, fields = moves(key)
    return fields[unit][face.landmarks[landmark]]


def parted(key: str, unit: str) -> float:
    """How far the lips come apart in the middle, millimetres; less than nothing where they press on each other."""
    return float(moved(key, unit, "upper_lip_mid")[1] - moved(key, unit, "lower_lip_mid")[1])


@EVERY_FACE
@pytest.mark.parametrize("unit", ["17", "18", "34"])
def test_a_raised_chin_a_pucker_and_a_puff_keep_lips_together(key: str, unit: str) -> None:
    assert parted(key, unit) < TOGETHER


@EVERY_FACE
def test_a_funnel_parts_lips_without_a_gape(key: str) -> None:
    assert 0.0 < parted(key, "22") < PARTED


@EVERY_FACE
@pytest.mark.parametrize("unit", ["18", "22"])
def test_pushed_lips_come_forward_and_the_mouth_narrows(key: str, unit: str) -> None:
    for lip in ("upper_lip_mid", "lower_lip_mid", "upper_vermilion", "lower_vermilion"):
        assert moved(key, unit, lip)[2] > FORWARD
    assert moved(key, unit, "mouth_corner_L")[0] < -INWARD


@EVERY_FACE
def test_a_raised_chin_pushes_the_lower_lip_up_as_a_whole(key: str) -> None:
    face, fields = moves(key)
    rises = [float(fields["17"][face.landmarks[name]][1]) for name in ("lower_lip_mid", "lower_vermilion")]
    assert min(rises) > 2.0
    assert float(fields["17"][face.landmarks["chin"]][1]) > 2.0

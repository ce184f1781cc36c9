"""A skull is snapped to where bone lies as deep under the landmarks as the tables say."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from facemodel.errors import SkullError
from facemodel.face import Face, Pose
from facemodel.faces import load_face
from facemodel.skull.placement import placed
from facemodel.skull.snapping import snapped
from facemodel.skull.tissue_depths import landmark_depths, table
from tests.app.conftest import small_face

FACE = load_face("ada")

OWN_MISS = 1.2
"""Millimetres rms by which the modelled bone of the shipped face misses the tables: crowns and rounded edges."""

way = st.tuples(*[st.floats(-25, 25)] * 3)
turn = st.tuples(*[st.floats(-6, 6)] * 3)
scale = st.tuples(*[st.floats(0.88, 1.12)] * 3)


def posed(pose: Pose) -> Face:
    return replace(FACE, skull=placed(FACE, pose))


def miss(face: Face) -> float:
    """Return by how much the depths miss the tables, rms."""
    return float(np.sqrt(np.mean([each.off**2 for each in landmark_depths(face)])))


def test_the_depths_of_a_shipped_face_are_those_of_the_tables() -> None:
    found = landmark_depths(FACE)
    assert {each.name: each.wanted for each in found} == table()
    assert miss(FACE) < OWN_MISS
    assert {each.title for each in found} >= {"nasion", "zygion, left", "chin lip fold"}


@settings(max_examples=8)
@given(way, turn, scale)
def test_wherever_a_skull_lies_it_is_snapped_back_to_the_tables(shift, turn, scale) -> None:
    pose = snapped(posed(Pose(shift, turn, scale)))
    assert miss(posed(pose)) < OWN_MISS
    assert np.abs(pose.shift).max() < 4
    assert np.abs(np.array(pose.scale) - 1).max() < 0.06


@settings(max_examples=4)
@given(way, turn)
def test_a_skull_that_may_not_be_scaled_is_moved_and_turned_alone(shift, turn) -> None:
    before = Pose(shift, turn, (0.97, 1.02, 1.0))
    pose = snapped(posed(before), scales=False)
    assert pose.scale == before.scale
    assert miss(posed(pose)) < 2 * OWN_MISS


def test_bone_that_comes_through_the_skin_is_drawn_in() -> None:
    proud = posed(Pose((0, 0, 15)))
    assert min(each.measured for each in landmark_depths(proud)) < 0
    home = posed(snapped(proud))
    assert min(each.measured for each in landmark_depths(home)) > 1


def test_a_face_without_landmarks_is_refused_in_a_sentence() -> None:
    with pytest.raises(SkullError, match="has 0 landmarks whose depth is known and at least 6 are needed"):
        snapped(small_face())

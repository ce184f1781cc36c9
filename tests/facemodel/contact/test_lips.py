"""Lips never pass through each other or through the teeth, whatever the sliders do."""

import numpy as np
import pytest

from benchmarks.touching import MouthDepths, random_mixes, worst_mix
from facemodel.basis import Basis
from facemodel.face import Face
from facemodel.superposition import Superposition

DEEPEST = 0.3
"""Millimetres that lips may be in each other or in the teeth; `python -m benchmarks contact` tries 10,000 mixes."""
MIXES = 150
OF_MIXES = 0.95
"""Share of them that has to: the rest contracts several of the rings of the mouth that work against each other."""
PRESSING = ("17", "23", "24")


@pytest.fixture(scope="module")
def depths(face: Face, basis: Basis) -> MouthDepths:
    return MouthDepths(face, basis)


def test_random_mixes_of_sliders_keep_the_lips_apart(face: Face, basis: Basis, depths: MouthDepths) -> None:
    posed = Superposition(face, basis)
    deep = [worst_mix(depths, posed, iter([mix]))[:2] for mix in random_mixes(basis.names, MIXES)]
    assert np.quantile(np.max(deep, axis=1), OF_MIXES) < DEEPEST


@pytest.mark.parametrize("name", PRESSING)
def test_a_unit_that_presses_would_take_them_through_each_other(
    face: Face, basis: Basis, depths: MouthDepths, name: str
) -> None:
    kept, straight = Superposition(face, basis), Superposition(face, basis, linear=True)
    for posed in (kept, straight):
        posed.pose({name: 1.0})
    assert depths.in_each_other(straight) > 1.0
    assert depths.in_each_other(kept) < 0.2


def test_lips_that_meet_nothing_are_left_to_the_sum(face: Face, basis: Basis) -> None:
    kept, straight = Superposition(face, basis), Superposition(face, basis, linear=True)
    for posed in (kept, straight):
        posed.pose({"25": 1.0})
    assert np.abs(kept.points - straight.points).max() < 0.2


def test_the_correction_can_be_switched_off_and_on_while_a_face_is_posed(face: Face, basis: Basis) -> None:
    posed = Superposition(face, basis)
    straight, kept = Superposition(face, basis, linear=True), Superposition(face, basis)
    mix = {"24": 0.8, "17": 0.7, "43L": 1.0, "27": 0.2}
    for each in (posed, straight, kept):
        each.pose(mix)
    posed.straighten(True)
    assert np.abs(posed.points - straight.points).max() < 1e-4
    posed.straighten(False)
    assert np.abs(posed.points - kept.points).max() < 1e-4
    assert np.abs(kept.points - straight.points).max() > 0.5

"""Lips never pass through each other or through the teeth, whatever the sliders do."""

from itertools import islice

import numpy as np
import pytest

from benchmarks.mouths import PosedMouth
from benchmarks.touching import MouthDepths, random_mixes
from facemodel.basis import Basis
from facemodel.cache import solve_cached
from facemodel.face import Face
from facemodel.project import Project
from facemodel.projects import new_project
from facemodel.superposition import Superposition

DEEPEST = 0.3
"""Millimetres that lips may be in each other or in the teeth; `python -m benchmarks contact` tries 10,000 mixes."""
NOTHING_SEEN = 0.15
MIXES = 300
OF_OTHERS = 60
HAIR = 1e-4
"""Share by which sliders are moved to see that the face does not jump."""
PRESSING = ("17", "23", "24")
CRUMPLED = "dayo", (839, 4077)
"""Random mixes that purse the full lips of a face until their corners crumple into ridges thinner than the grid."""

UPRIGHT = "dayo", (7509, 5057, 8643)
"""Random mixes that put the lower lip of that face behind skin of the upper one that stands upright in its corners."""

TURNED_OUT = "ben", (237,)
"""A random mix that turns a lower lip out so far that its inner side stands upright before the teeth, in the middle."""


@pytest.fixture(scope="module")
def depths(face: Face, basis: Basis) -> MouthDepths:
    return MouthDepths(face, basis)


def depths_in(project: Project, basis: Basis, mixes: int) -> np.ndarray:
    """How deep (n,) lips are in each other or in the teeth in each of many mixes."""
    depths, posed = MouthDepths(project.face, basis), PosedMouth(project.face, basis)
    poses = posed.poses(random_mixes(basis.names, mixes))
    return np.array([max(depths.in_each_other(posed), depths.in_teeth(posed)) for _ in poses])


def test_random_mixes_of_sliders_keep_lips_out_of_each_other_and_the_teeth(project: Project, basis: Basis) -> None:
    deep = depths_in(project, basis, MIXES)
    assert np.median(deep) < NOTHING_SEEN
    assert deep.max() < DEEPEST


@pytest.mark.parametrize("key", ["chen", "dayo"])
def test_so_they_do_on_faces_with_thin_and_with_full_lips(key: str) -> None:
    project = new_project(key)
    assert depths_in(project, solve_cached(project).basis, OF_OTHERS).max() < DEEPEST


@pytest.mark.parametrize(("known", "limit"), [(CRUMPLED, NOTHING_SEEN), (UPRIGHT, DEEPEST), (TURNED_OUT, NOTHING_SEEN)])
def test_crumpled_and_upright_skin_stays_out_of_the_other_lip(known: tuple[str, tuple[int, ...]], limit: float) -> None:
    key, numbers = known
    project = new_project(key)
    basis = solve_cached(project).basis
    depths, posed = MouthDepths(project.face, basis), Superposition(project.face, basis)
    for number in numbers:
        posed.pose(next(islice(random_mixes(basis.names, number + 1), number, None)))
        assert depths.in_each_other(posed) < limit


def test_lips_and_lids_never_jump_while_sliders_are_dragged(face: Face, basis: Basis) -> None:
    kept, straight = ([Superposition(face, basis, contact=contact) for _ in range(2)] for contact in (True, False))
    for mix in random_mixes(basis.names, 15, seed=5):
        ways = []
        for before, after in (kept, straight):
            before.pose(mix)
            after.pose({name: (1 - HAIR) * weight for name, weight in mix.items()})
            ways.append(np.linalg.norm(after.points - before.points, axis=1).max())
        assert ways[0] < 3 * ways[1] + 1e-3


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
    assert np.abs(kept.points - straight.points).max() < 0.3


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

"""Folds: the skin goes in along a line and stands up beside it, on the cheek's side, whichever way it is drawn."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from facemodel.actions import ActionUnit
from facemodel.laying.fitting import fitted
from facemodel.laying.handles import dragged, handles
from facemodel.laying.influence import side_by_side
from facemodel.laying.places import nearest
from facemodel.laying.warp import control_points, landmark_warp
from facemodel.mesh import Mesh
from facemodel.muscles import Fibre, Muscle
from facemodel.muscles.fold import BESIDE, fold_forces
from facemodel.muscles.models import muscle_action
from facemodel.project import Project, Settings
from facemodel.projects import new_project
from facemodel.solve import solve_project
from tests.facemodel.places import vertex_fields
from tests.facemodel.skin import sizes

WIDTH = 4.0


def sheet() -> Mesh:
    """A flat square of skin on the left side of a face, 80 mm wide, that looks forward."""
    side = np.arange(0.0, 81.0, 2.0)
    x, y = np.meshgrid(side + 10.0, side - 40.0, indexing="ij")
    number = np.arange(x.size).reshape(x.shape)
    a, b, c, d = number[:-1, :-1].ravel(), number[1:, :-1].ravel(), number[1:, 1:].ravel(), number[:-1, 1:].ravel()
    triangles = np.concatenate([np.stack([a, b, c], axis=1), np.stack([a, c, d], axis=1)])
    return Mesh(np.stack([x.ravel(), y.ravel(), np.zeros(x.size)], axis=1), triangles)


def fold(*points: tuple[float, float, float], side: str = "L") -> Muscle:
    first, *between, last = (np.array(point) for point in points)
    fibre = Fibre(first, last, tuple(between))
    return Muscle("fold", side, "Fold", "cheek", "fold", (fibre,), None, WIDTH, 1.0, 0.05, 1)  # type: ignore[arg-type]


def named(project: Project, key: str) -> Muscle:
    return next(muscle for muscle in project.muscles if muscle.key == key)


@given(st.booleans(), st.sampled_from("LRM"))
def test_skin_is_drawn_in_on_the_line_and_stands_up_on_the_side_away_from_the_middle(up: bool, side: str) -> None:
    """Whichever way it was drawn and whatever side it is listed under."""
    ends = [(45.0, -20.0, 0.0), (47.0, 0.0, 0.0), (45.0, 20.0, 0.0)]
    skin = sheet()
    push = fold_forces(fold(*(ends if up else ends[::-1]), side=side), skin)[:, 2]
    x, y, _ = skin.positions.T
    middle = np.abs(y) < 3.0
    assert push[middle & (np.abs(x - 46.5) < 1.5)].max() < 0
    assert push[middle & (x > 51.5) & (x < 57.0)].min() > 0
    assert push[middle & (x < 41.0)].max() <= 0
    assert not push[(x > 47.0 + BESIDE * WIDTH + 1.0) | (np.abs(y) > 25.0)].any()


def test_below_a_line_across_the_middle_the_flesh_stands_up() -> None:
    skin = sheet()
    centred = Mesh(skin.positions - [50.0, 0.0, 0.0], skin.triangles)
    push = fold_forces(fold((-20.0, 0.0, 0.0), (20.0, 0.0, 0.0), side="M"), centred)[:, 2]
    x, y, _ = centred.positions.T
    assert push[(np.abs(x) < 3) & (y < -5) & (y > -9)].min() > 0 >= push[(np.abs(x) < 3) & (y > 3)].max()


def test_a_fold_presses_on_nothing_as_a_whole(project: Project) -> None:
    """Of the skin's own normal: what the crease takes the flesh beside it gives."""
    skin = project.face.skin
    for key in ("nasolabial_fold_superior_L", "nasolabial_fold_inferior_R"):
        along = np.einsum("nc,nc->n", muscle_action(named(project, key), project.face), skin.normals)
        taken = skin.vertex_areas @ np.minimum(along, 0.0)
        assert taken < 0
        assert skin.vertex_areas @ along == pytest.approx(0.0, abs=1e-9 * abs(taken))


def test_folds_are_alike_on_both_sides(project: Project) -> None:
    left, right = (muscle_action(named(project, f"nasolabial_fold_superior_{side}"), project.face) for side in "LR")
    assert right[project.face.mirror] * [-1, 1, 1] == pytest.approx(left, abs=1e-3 * np.abs(left).max())


def test_a_smile_folds_the_cheek_beside_the_mouth(project: Project) -> None:
    """The crease is a millimetre and a half and more behind the flesh beside it, against a smile without a fold."""
    unit = next(unit for unit in project.units if unit.number == 12)
    plain = {name: share for name, share in unit.muscles.items() if "fold" not in name}
    without = ActionUnit(112, "plain smile", "diagonal", True, plain, unit.amplitude)
    asked = replace(project, units=(unit, without), emotions=(), expression={}, settings=Settings(density=1))
    fields = vertex_fields(project.face, solve_project(asked).basis)
    change = np.einsum("nc,nc->n", fields["12L"] - fields["112L"], project.face.skin.normals)
    crease, flesh = change.argmin(), change.argmax()
    assert change[crease] < -1.0
    assert change[flesh] > 0.5
    assert change[flesh] - change[crease] > 1.5
    corner = project.face.landmarks["mouth_corner_L"]
    assert sizes(project.face.skin.positions[[crease, flesh]] - project.face.skin.positions[corner]).max() < 25.0
    assert project.face.skin.positions[flesh, 0] > project.face.skin.positions[crease, 0]


def test_every_point_of_a_fold_that_is_dragged_stays_on_the_skin(project: Project) -> None:
    muscle = named(project, "nasolabial_fold_superior_L")
    for handle in handles(muscle, project.face):
        if handle.part in ("origin", "via", "attachment"):
            moved = dragged(muscle, handle, handle.point + np.array([3.0, -2.0, 8.0]), project.face)
            assert nearest(project.face.skin, moved.fibres[0].points)[2].max() < 1e-6


def test_a_fold_is_carried_to_another_head_along_its_skin(project: Project) -> None:
    other = new_project("dayo").face
    warp = landmark_warp(control_points(project.face), control_points(other))
    for source in (None, project.face):
        carried = fitted(named(project, "nasolabial_fold_inferior_L"), warp, other, source)
        assert nearest(other.skin, carried.fibres[0].points)[2].max() < 1e-6


def test_a_fold_is_compared_with_nothing_that_arises_from_bone(project: Project) -> None:
    assert list(side_by_side(named(project, "nasolabial_fold_superior_L"))) == ["fold"]
    assert "fold" not in side_by_side(named(project, "zygomaticus_major_L"))

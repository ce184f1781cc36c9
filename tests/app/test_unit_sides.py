"""Sides of a unit: apart and as one it does the same, and its mirror image does the same on the other side."""

from dataclasses import replace

import numpy as np
import pytest

from app.authoring import parting, units
from app.authoring.merging import merged
from app.authoring.mirroring import mirrored_unit
from app.errors import UnitError
from app.sides import both_sides
from facemodel.actions import ActionUnit, Emotion, JawMotion, expand
from facemodel.fields import jaw_table
from facemodel.io.project_file import project_bytes, project_of
from facemodel.io.records import unit_json, unit_of
from facemodel.io.unit_schema import UnitRecord
from facemodel.project import Project
from facemodel.sculpting.correction import correction_of

SWAY = ActionUnit(30, "jaw sideways", "jaw", False, {}, 8.0, JawMotion(2.0, 1.0, -6.0))


@pytest.fixture
def swaying(project: Project) -> Project:
    emotions = (*project.emotions, Emotion("sly", {"30": 0.5, "17": 0.2}))
    return replace(project, units=(*project.units, SWAY), emotions=emotions).posed({"30": 0.5})


def jaw_now(project: Project, weights: dict[str, float]) -> np.ndarray:
    """Return opening, slide and shift of an expression."""
    names = [field for unit in project.units for field in unit.fields]
    return np.array([weights.get(name, 0.0) for name in names]) @ jaw_table(project.units)


def test_a_jaw_that_opens_opens_as_far_with_its_sides_apart(project: Project) -> None:
    posed = project.posed({"26": 0.8})
    apart = parting.split(posed, 26)
    assert jaw_now(apart, dict(apart.expression)) == pytest.approx(jaw_now(posed, {"26": 0.8}))
    again = parting.joined(apart, 26)
    assert units.unit_of(again, 26).jaw == units.unit_of(project, 26).jaw
    assert again.expression == posed.expression


def test_a_jaw_that_goes_right_becomes_the_right_side_of_a_pair(swaying: Project) -> None:
    before = jaw_now(swaying, dict(swaying.expression))
    apart = parting.split(swaying, 30)
    assert apart.expression == {"30R": 0.5}
    assert jaw_now(apart, dict(apart.expression)) == pytest.approx(before)
    assert jaw_now(apart, {"30L": 0.5}) == pytest.approx(before * [1, 1, -1])
    sly = expand(apart.emotions[-1].weights, apart.units)
    assert sly == {"30R": 0.5, "17": 0.2}
    assert project_of(project_bytes(apart)).units == apart.units


def test_a_mirrored_unit_turns_jaw_and_sculpt_over_and_twice_is_the_same(swaying: Project) -> None:
    rough = np.random.default_rng(3).uniform(-1, 1, swaying.face.skin.positions.shape)
    sculpted = replace(swaying, corrections={"30": correction_of(rough)})
    turned = mirrored_unit(sculpted, 30, swaying.face.mirror)
    assert units.unit_of(turned, 30).jaw == JawMotion(2.0, 1.0, 6.0)
    moved = turned.corrections["30"].everywhere(len(rough))
    np.testing.assert_allclose(moved, rough[swaying.face.mirror] * [-1, 1, 1], atol=1e-6)
    back = mirrored_unit(turned, 30, swaying.face.mirror)
    assert back.units == sculpted.units
    assert np.array_equal(back.corrections["30"].moved, sculpted.corrections["30"].moved)


def test_what_is_sculpted_on_one_side_of_a_pair_goes_to_the_other(project: Project) -> None:
    count = len(project.face.skin.positions)
    rough = np.random.default_rng(4).uniform(-1, 1, (count, 3))
    turned = mirrored_unit(replace(project, corrections={"12L": correction_of(rough)}), 12, project.face.mirror)
    assert list(turned.corrections) == ["12R"]
    assert turned.units == project.units


def test_a_unit_that_is_its_own_mirror_image_is_left_alone(project: Project) -> None:
    with pytest.raises(UnitError, match="own mirror image"):
        mirrored_unit(project, 12, project.face.mirror)
    one = replace(project, muscles=project.muscles[:1])
    with pytest.raises(UnitError, match="left alone"):
        mirrored_unit(one, 12, project.face.mirror)


def test_a_shift_of_the_jaw_is_kept_in_files_and_old_files_do_not_know_it(swaying: Project) -> None:
    assert project_of(project_bytes(swaying)).units == swaying.units
    middle = unit_json(units.unit_of(units.with_jaw(swaying, 30, 2.0, 1.0), 30))
    assert middle["jaw"] == {"degrees": 2.0, "slide": 1.0}
    assert unit_of(UnitRecord(**middle)).jaw == JawMotion(2.0, 1.0)
    with pytest.raises(UnitError, match="shift"):
        units.with_jaw(swaying, 30, 0.0, 0.0, 99.0)


def test_merging_adds_up_where_the_jaw_goes(swaying: Project) -> None:
    made = merged(swaying, 26, 30, 1.0, 0.5)
    assert units.unit_of(made, 26).jaw == JawMotion(16.0, 3.5, -3.0)


def test_sides_that_undo_each_other_are_neither_linked_nor_shown_together(swaying: Project) -> None:
    apart = parting.split(swaying, 30)
    sway, smile = units.unit_of(apart, 30), units.unit_of(apart, 12)
    assert sway.opposed
    assert not smile.opposed
    assert sway.full == {"30L": 1.0}
    assert smile.full == {"12L": 1.0, "12R": 1.0}
    assert both_sides({"30L": 0.5, "12L": 0.5}, apart.units, linked=True) == {"30L": 0.5, "12L": 0.5, "12R": 0.5}

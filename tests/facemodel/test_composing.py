"""Composing units and emotions: names stay unique, fields follow, and what sums must be what is solved in full."""

from dataclasses import replace

import pytest

from facemodel.actions import ActionUnit, Emotion, JawMotion, expand
from facemodel.composing.check import compared, summed
from facemodel.composing.emotions import deleted_emotion, placed, renamed_emotion, replaced, saved
from facemodel.composing.table import completed, filled, missing
from facemodel.composing.units import (
    deleted,
    duplicated,
    new_unit,
    paired,
    renamed,
    unit_of,
    with_jaw,
    with_unit,
    with_weight,
)
from facemodel.errors import ActionError
from facemodel.projects import new_project
from facemodel.solve import solve_project
from tests.app.conftest import small_project


@pytest.fixture(scope="module")
def project():
    return new_project()


def fields(project, name):
    emotion = next(each for each in project.emotions if each.name == name)
    return expand(emotion.weights, project.units)


def test_a_new_unit_has_a_number_beyond_facs_and_a_name_of_its_own(project):
    once, first = new_unit(project, "lip corner puller")
    twice, second = new_unit(once, "lip corner puller")
    assert (first, second) == (101, 102)
    assert [unit.name for unit in twice.units[-2:]] == ["lip corner puller 2", "lip corner puller 3"]


def test_a_copy_stands_behind_its_unit_and_contracts_the_same(project):
    with_copy, number = duplicated(project, 12)
    numbers = [unit.number for unit in with_copy.units]
    assert numbers.index(number) == numbers.index(12) + 1
    assert unit_of(with_copy, number).muscles == unit_of(project, 12).muscles


@pytest.mark.parametrize("name", ["", "  ", "12", "AU 7", "lip l", "Lip Corner Puller", "x" * 101])
def test_names_that_could_mean_something_else_are_refused(project, name):
    with pytest.raises(ActionError):
        renamed(project, 4, name)


def test_renaming_a_unit_keeps_what_emotions_made_of_it(project):
    by_name = replace(project, emotions=(Emotion("sly", {"lip corner puller L": 0.5, "4": 1.0}),))
    after = renamed(by_name, 12, "smirk")
    assert fields(after, "sly") == fields(by_name, "sly")


def test_splitting_and_joining_keep_expression_and_emotions(project):
    smiling = project.posed({"17": 0.4})
    apart = paired(smiling, 17, True)
    assert apart.expression == {"17L": 0.4, "17R": 0.4}
    together = paired(apart.posed({"17L": 0.1, "17R": 0.4}), 17, False)
    assert together.expression == {"17": 0.4}
    for emotion in project.emotions:
        for name, weight in fields(paired(project, 12, False), emotion.name).items():
            before = fields(project, emotion.name)
            assert weight == (max(before.get("12L", 0.0), before.get("12R", 0.0)) if name == "12" else before[name])


def test_a_deleted_unit_leaves_emotions_and_expression_and_names_them(project):
    gone = deleted(project.posed({"12L": 1.0, "6L": 0.5}), 12)
    assert "happiness" in gone.users
    assert gone.project.expression == {"6L": 0.5}
    for emotion in gone.project.emotions:
        expand(emotion.weights, gone.project.units)


def test_impossible_numbers_are_refused(project):
    unit = unit_of(project, 12)
    with pytest.raises(ActionError):
        with_unit(project, with_weight(unit, "risorius", 11.0))
    with pytest.raises(ActionError):
        with_unit(project, with_jaw(unit, 90.0, 0.0))


def test_the_table_brings_back_every_weight_and_every_missing_unit(project):
    emptied = with_unit(project, replace(unit_of(project, 4), muscles={}))
    assert filled(emptied, 4).units == project.units
    bare = deleted(emptied, 12).project
    assert [unit.number for unit in missing(bare)] == [12]
    assert completed(bare).units == project.units


def test_a_bare_head_has_nothing_but_its_jaw(project):
    bare = replace(project, muscles=(), units=())
    assert [unit.number for unit in completed(bare).units] == [26, 27]
    with pytest.raises(ActionError):
        filled(replace(bare, units=project.units), 12)


def test_sliders_become_an_emotion_as_a_person_would_write_it(project):
    after = saved(project, "  wry   smile ", {"12L": 0.5, "12R": 0.5, "4L": 0.2, "17": 0.1, "1L": 0.0})
    assert after.emotions[-1] == Emotion("wry smile", {"4L": 0.2, "12": 0.5, "17": 0.1})
    with pytest.raises(ActionError):
        saved(after, "Wry Smile", {"17": 1.0})
    with pytest.raises(ActionError):
        saved(project, "rest", {"17": 0.0})


def test_emotions_are_renamed_replaced_ordered_and_deleted(project):
    names = [emotion.name for emotion in project.emotions]
    assert [e.name for e in placed(project, names[0], 2).emotions[:3]] == [names[1], names[2], names[0]]
    assert [e.name for e in deleted_emotion(project, names[0]).emotions] == names[1:]
    assert renamed_emotion(project, names[0], "joy").emotions[0].weights == project.emotions[0].weights
    assert replaced(project, names[0], {"17": 0.3}).emotions[0] == Emotion(names[0], {"17": 0.3})
    with pytest.raises(ActionError):
        renamed_emotion(project, names[0], names[1].upper())


def test_summed_loads_give_the_sum_of_fields_but_for_the_arc_of_the_jaw():
    project = small_project()
    basis = solve_project(project).basis
    posed = {name: 0.3 + 0.1 * k for k, name in enumerate(basis.names)}
    jawless = {unit.number for unit in project.units if unit.jaw is None}
    linear = {f: w for u in project.units if u.number in jawless for f, w in posed.items() if f in u.fields}
    same = compared(project, linear, basis, solve_project(summed(project, linear)))
    assert same.moved > 1e-3
    assert same.largest < 2e-5 * max(1.0, same.moved)
    turning = ActionUnit(200, "gape", "jaw", False, {}, 10.0, JawMotion(30.0))
    gaping = with_unit(project, turning)
    arc = compared(gaping, {"200": 0.5}, solve_project(gaping).basis, solve_project(summed(gaping, {"200": 0.5})))
    assert arc.largest > 10 * same.largest

"""Action units and emotions are made and changed with everything that hangs on them, and nothing else."""

from dataclasses import replace

import numpy as np
import pytest

from app.authoring import emotions, parting, units
from app.authoring.bare import bare_project
from app.authoring.facs_table import filled_from_facs
from app.authoring.merging import merged
from app.document import Document
from app.errors import UnitError
from facemodel.actions import Emotion, JawMotion, resolve
from facemodel.errors import UnknownNameError
from facemodel.facs import action_units
from facemodel.io.project_file import project_bytes, project_of
from facemodel.painting.layers import PAINT_LAYERS
from facemodel.project import Project
from facemodel.projects import new_project
from facemodel.solve import solve_project


def savable(project: Project) -> Project:
    """Return the project as it comes back from a file, which refuses names that hang in the air."""
    return project_of(project_bytes(project))


def test_a_new_unit_moves_nothing_until_it_contracts_a_muscle(project: Project) -> None:
    made, number = units.with_new_unit(project, "smirk")
    assert number == 101
    assert units.unit_of(made, number).fields == ("101L", "101R")
    assert solve_project(made).basis.peak("101L") == 0
    weighed = units.with_activation(made, number, "zygomaticus_major", 0.5)
    basis = solve_project(weighed).basis
    assert basis.peak("101L") == pytest.approx(basis.peak("12L") / 2, rel=1e-5)
    assert units.with_activation(weighed, number, "zygomaticus_major", 0.0).units == made.units
    savable(weighed)


def test_a_copy_does_what_its_original_does_under_another_name(project: Project) -> None:
    made, number = units.with_duplicate(project, 12)
    assert [unit.number for unit in made.units] == [12, number, 20, 17, 26]
    copy = units.unit_of(made, number)
    assert copy.muscles == units.unit_of(made, 12).muscles
    assert copy.name == "lip corner puller copy"
    assert units.unit_of(*units.with_duplicate(made, 12)).name == "lip corner puller copy 2"


@pytest.mark.parametrize("name", ["", "  ", "Jaw Drop", "x" * 101, "AU 17", "4l", "smile R"])
def test_a_name_that_is_empty_long_or_taken_is_refused(project: Project, name: str) -> None:
    with pytest.raises(UnitError, match=r"name|called"):
        units.renamed(project, 12, name)
    if name:
        with pytest.raises(UnitError, match=r"name|called"):
            units.with_new_unit(project, name)


def test_a_unit_may_keep_its_own_name_in_another_case(project: Project) -> None:
    assert units.unit_of(units.renamed(project, 26, "Jaw drop"), 26).name == "Jaw drop"


def test_emotions_that_call_a_unit_by_its_name_follow_a_new_name(project: Project) -> None:
    spoken = replace(project, emotions=(Emotion("glee", {"lip corner puller L": 0.5, "Chin raiser": 0.1, "26": 1.0}),))
    made = units.renamed(spoken, 12, "smile")
    assert dict(made.emotions[0].weights) == {"12L": 0.5, "17": 0.1, "26": 1.0}
    savable(made)


def test_a_new_unit_with_a_number_of_facs_takes_group_and_amplitude_from_its_table(project: Project) -> None:
    made, number = units.with_new_unit(project, "brow raise")
    brow = units.unit_of(units.renumbered(made, number, 1), 1)
    assert brow.group == "upper"
    assert brow.amplitude == pytest.approx(8, abs=4)
    known = units.with_unit(made, replace(units.unit_of(made, number), amplitude=2.0))
    assert units.unit_of(units.renumbered(known, number, 1), 1).amplitude == 2.0


def test_another_number_goes_with_its_weights(project: Project) -> None:
    posed = project.posed({"12L": 0.5, "17": 0.2})
    made = units.renumbered(posed, 12, 14)
    assert made.expression == {"14L": 0.5, "17": 0.2}
    assert dict(made.emotions[0].weights) == {"14L": 0.9, "14R": 0.9}
    assert made.emotions[1] is project.emotions[1]
    savable(made)
    for taken in (17, 0, 1000):
        with pytest.raises(UnitError, match=str(taken)):
            units.renumbered(project, 12, taken)


def test_splitting_keeps_what_is_shown_and_joining_takes_the_larger_side(project: Project) -> None:
    posed = project.posed({"17": 0.5})
    both = parting.split(posed, 17)
    assert both.expression == {"17L": 0.5, "17R": 0.5}
    lopsided = both.posed({"17L": 0.1, "17R": 0.7})
    assert parting.joined(lopsided, 17).expression == {"17": 0.7}
    assert parting.joined(both, 17).units == project.units
    with pytest.raises(UnitError, match="left and right"):
        parting.split(both, 17)
    with pytest.raises(UnitError, match="left and right"):
        parting.joined(project, 17)


def test_joining_renames_sides_in_emotions(project: Project) -> None:
    made = parting.joined(project, 20)
    assert dict(made.emotions[1].weights) == {"26": 0.8, "20": 0.1}
    assert made.emotions[0] is project.emotions[0]
    savable(made)


def test_a_split_unit_moves_as_before_when_both_sides_move(project: Project) -> None:
    whole = solve_project(project).basis
    halves = solve_project(parting.split(project, 17)).basis
    assert halves.field("17L") + halves.field("17R") == pytest.approx(whole.field("17"), abs=1e-5)


def test_a_merged_unit_does_what_both_did(project: Project) -> None:
    posed = project.posed({"12L": 0.3, "20L": 0.6, "20R": 0.2})
    made = merged(posed, 12, 20)
    assert [unit.number for unit in made.units] == [12, 17, 26]
    assert made.expression == {"12L": 0.6, "12R": 0.2}
    assert dict(made.emotions[1].weights) == {"26": 0.8, "12L": 0.1}
    before, after = solve_project(project).basis, solve_project(made).basis
    assert after.field("12L") == pytest.approx(before.field("12L") + before.field("20L"), abs=1e-5)
    savable(made)


def test_merging_adds_up_the_jaw(project: Project) -> None:
    made = merged(units.with_jaw(project, 17, 5.0, 1.0), 26, 17)
    assert units.unit_of(made, 26).jaw == JawMotion(20.0, 4.0)
    with pytest.raises(UnitError, match="itself"):
        merged(project, 12, 12)
    with pytest.raises(UnitError, match="left and right"):
        merged(project, 12, 17)


def test_a_deleted_unit_leaves_expression_and_emotions(project: Project) -> None:
    made = units.without_units(project.posed({"12L": 0.5, "17": 0.5}), [12])
    assert made.expression == {"17": 0.5}
    assert [dict(emotion.weights) for emotion in made.emotions] == [{}, {"26": 0.8, "20L": 0.1}]
    savable(made)
    with pytest.raises(UnknownNameError, match="99"):
        units.without_units(project, [99])


def test_units_can_be_put_in_another_order(project: Project) -> None:
    assert [unit.number for unit in units.moved_unit(project, 26, 0).units] == [26, 12, 20, 17]
    assert [unit.number for unit in units.moved_unit(project, 12, 99).units] == [20, 17, 26, 12]


@pytest.mark.parametrize("value", [float("nan"), -1.0, 1e6])
def test_impossible_numbers_are_refused(project: Project, value: float) -> None:
    with pytest.raises(UnitError, match="zygomaticus_major"):
        units.with_activation(project, 12, "zygomaticus_major", value)
    if value != -1.0:
        with pytest.raises(UnitError, match="jaw"):
            units.with_jaw(project, 26, value)
        with pytest.raises(UnitError, match="jaw"):
            units.with_jaw(project, 26, 0.0, value)


def test_a_muscle_that_is_not_there_cannot_be_contracted(project: Project) -> None:
    with pytest.raises(UnknownNameError, match="risorius"):
        units.with_activation(project, 12, "risorius", 1.0)


def test_a_note_and_a_group(project: Project) -> None:
    made = units.with_group(units.with_note(project, 12, " the smile "), 12, "upper")
    assert (made.units[0].note, made.units[0].group) == ("the smile", "upper")
    with pytest.raises(UnitError, match="middle"):
        units.with_group(project, 12, "middle")  # type: ignore[arg-type]
    with pytest.raises(UnitError, match="note"):
        units.with_note(project, 12, "x" * 30_000)


def test_the_sliders_of_a_unit_stop_at_its_limit(document: Document) -> None:
    document.set_weights({"12L": 1.5, "12R": 0.3, "17": 1.5})
    document.edit(units.with_limit(document.project, 12, 0.8), "Limit")
    assert document.shown == {"12L": 0.8, "12R": 0.3, "17": 1.5}
    document.preview({"12": 1.9, "17": 1.9})
    assert document.shown == {"12L": 0.8, "12R": 0.8, "17": 1.9}
    document.apply_emotion("happiness", 1.5)
    assert document.shown == {"12L": 0.8, "12R": 0.8}
    assert savable(document.project).units == document.project.units
    for _ in range(4):
        document.undo()
    assert units.unit_of(document.project, 12).limit == 2.0
    for limit in (0.0, 2.1, float("nan")):
        with pytest.raises(UnitError, match="limit"):
            units.with_limit(document.project, 12, limit)


def test_the_sliders_are_kept_as_an_expression_and_shown_again(document: Document) -> None:
    document.set_weights({"12L": 0.4, "20": 0.3, "17": 0.2})
    document.edit(emotions.with_expression(document.project, "Half a smile", document.shown), "Save expression")
    document.reset_expression()
    document.apply_emotion("half a smile")
    assert document.shown == {"12L": 0.4, "17": 0.2, "20L": 0.3, "20R": 0.3}
    assert dict(document.project.emotions[-1].weights) == {"12L": 0.4, "20": 0.3, "17": 0.2}
    document.set_weights({"12L": 0.1, "20": 0.0})
    document.edit(emotions.with_expression(document.project, "half A smile", document.shown), "Save expression")
    assert [emotion.name for emotion in document.project.emotions] == ["happiness", "surprise", "Half a smile"]
    assert dict(document.project.emotions[-1].weights) == {"12L": 0.1, "17": 0.2}
    savable(document.project)


def test_expressions_are_renamed_ordered_and_deleted(project: Project) -> None:
    named = emotions.renamed(project, "Happiness", "joy")
    assert [each.name for each in emotions.moved(named, "joy", 5).emotions] == ["surprise", "joy"]
    assert [each.name for each in emotions.without(named, ["joy"]).emotions] == ["surprise"]
    with pytest.raises(UnitError, match="Surprise"):
        emotions.renamed(project, "happiness", "Surprise")
    with pytest.raises(UnitError, match="name"):
        emotions.renamed(project, "happiness", " ")
    with pytest.raises(UnitError, match="zero"):
        emotions.with_expression(project, "nothing", {"17": 0.0})
    assert emotions.free_name(project, "surprise") == "surprise 2"


def test_the_table_fills_every_unit_as_far_as_its_muscles_are_there(project: Project) -> None:
    filling = filled_from_facs(project)
    numbers = [unit.number for unit in filling.project.units]
    assert numbers[:4] == [12, 20, 17, 26]
    assert len(numbers) == len(set(numbers)) == len(action_units())
    assert units.unit_of(filling.project, 12).muscles.keys() == {"zygomaticus_major"}
    assert "frontalis_medialis" in filling.missing[1]
    assert not units.unit_of(filling.project, 1).muscles
    savable(filling.project)


def test_on_a_shipped_face_the_table_gives_back_what_it_ships_with() -> None:
    ada = new_project()
    emptied = replace(ada, units=tuple(replace(unit, muscles={}, jaw=None, eyes=None, head=None) for unit in ada.units))
    filling = filled_from_facs(emptied)
    assert filling.project.units == ada.units
    assert not filling.missing


def test_a_bare_copy_has_the_head_and_nothing_else() -> None:
    bare, ada = bare_project("ada"), new_project("ada")
    assert (bare.muscles, bare.units, bare.emotions) == ((), (), ())
    assert bare.face.skin is ada.face.skin or np.array_equal(bare.face.skin.positions, ada.face.skin.positions)
    for layer in PAINT_LAYERS:
        assert layer.values(bare.face) == pytest.approx(layer.unpainted(bare.face))
    assert savable(bare).units == ()


def test_every_emotion_still_names_what_there_is_after_all_of_it(project: Project) -> None:
    made = merged(parting.joined(parting.split(project, 17), 12), 26, 12)
    for emotion in made.emotions:
        for name in emotion.weights:
            resolve(name, made.units)
    savable(made)

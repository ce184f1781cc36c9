"""Differences lead from one state to the other and back, joined ones over both, and hold nothing that is the same."""

from dataclasses import dataclass, replace

import numpy as np
from hypothesis import given
from hypothesis import strategies as st

from app.authoring import units
from app.commands import Several, edit_content, paint_layers
from app.commands.edit import edit
from app.commands.keyed import keyed_delta
from app.differences import changes, same_content
from app.document import Document
from facemodel.face import Face, Jaw
from facemodel.project import Project
from facemodel.solve import solve_project
from fem import Support


@dataclass(frozen=True, eq=False)
class Thing:
    """A value with a name that is the same only as itself."""

    name: str


POOL = tuple(Thing(name) for name in "aabbccdde")


def name_of(thing: Thing) -> str:
    return thing.name


COLLECTIONS = st.lists(st.sampled_from(POOL), unique_by=name_of, max_size=5).map(tuple)


@given(COLLECTIONS, COLLECTIONS)
def test_a_difference_leads_there_and_back(before: tuple[Thing, ...], after: tuple[Thing, ...]) -> None:
    delta = keyed_delta(before, after, name_of)
    assert delta.do(before, name_of) == after
    assert delta.undo(after, name_of) == before
    assert delta.changes == (before != after)
    assert not any(delta.before.get(name) is delta.after.get(name) for name in delta.touched)


@given(COLLECTIONS, COLLECTIONS, COLLECTIONS)
def test_two_differences_are_one(first: tuple[Thing, ...], second: tuple[Thing, ...], third: tuple[Thing, ...]) -> None:
    both = keyed_delta(first, second, name_of).then(keyed_delta(second, third, name_of))
    assert both.do(first, name_of) == third
    assert both.undo(third, name_of) == first
    assert both.changes == (first != third)


def painted(face: Face, vertices: list[int], value: float) -> Face:
    stiffness, supports = face.layers.stiffness.copy(), face.layers.supports.copy()
    stiffness[vertices] = value
    supports[vertices[:2]] = Support.SLIDING
    return replace(face, layers=replace(face.layers, stiffness=stiffness, supports=supports))


VERTICES = st.lists(st.integers(0, 80), max_size=20, unique=True)
VALUES = st.sampled_from([0.002, 0.0, -0.0, 0.5])


@given(VERTICES, VALUES, VERTICES, VALUES)
def test_strokes_of_one_gesture_are_one_step_and_undone_to_the_bit(
    project: Project, first: list[int], one: float, second: list[int], other: float
) -> None:
    middle = painted(project.face, first, one)
    last = painted(middle, second, other)
    step = paint_layers(project.face, middle, "paint", "drag")
    joined = step.joined(paint_layers(middle, last, "paint", "drag"))
    assert joined is not None
    done = joined.do(project)
    undone = joined.undo(done)
    for name in ("stiffness", "supports"):
        assert getattr(done.face.layers, name).tobytes() == getattr(last.layers, name).tobytes()
        assert getattr(undone.face.layers, name).tobytes() == getattr(project.face.layers, name).tobytes()
    assert step.joined(paint_layers(middle, last, "paint", "another")) is None


def test_an_edit_is_the_smallest_step_that_does_it(project: Project) -> None:
    noted = units.with_note(project, 12, "smile")
    content = edit(project, noted, "note")
    assert isinstance(content, type(edit_content(project, noted, "")))
    assert content.units.touched == {"12"}  # type: ignore[attr-defined]
    both = edit(project, replace(noted, face=painted(project.face, [3], 0.5)), "both")
    assert isinstance(both, Several)
    assert same_content(both.undo(both.do(project)), project)


def with_hinge(project: Project, height: float) -> Project:
    skull = project.face.skull
    hinge = Jaw(skull.jaw.axis + np.array([0.0, height, 0]), skull.jaw.teeth)
    return replace(project, face=replace(project.face, skull=replace(skull, jaw=hinge)))


def test_a_moved_hinge_of_the_jaw_is_told_and_undone(document: Document, project: Project) -> None:
    told: list[str] = []
    document.accept(solve_project(project), project)
    document.skull_changed.connect(lambda: told.append("skull"))
    document.project_changed.connect(lambda _: told.append("project"))
    for height in (1.0, 2.0, 5.0):
        document.edit(with_hinge(project, height), "Place the jaw’s axis", "drag")
    assert told == ["skull"] * 3
    assert document.stale_fields == {"26"}
    assert len(document.history.done) == 1
    assert document.history.cost < 1000
    document.undo()
    assert same_content(document.project, project)


def test_several_kinds_of_steps_join_kind_by_kind_within_a_gesture(document: Document, project: Project) -> None:
    for height, weight in ((1.0, 0.2), (2.0, 0.4), (3.0, 0.6)):
        made = units.with_activation(with_hinge(project, height), 12, "zygomaticus_major", weight)
        document.edit(made, "Both", "drag")
    document.edit(with_hinge(document.project, 1.0), "One", "drag")
    assert len(document.history.done) == 1
    last = document.project
    document.undo()
    assert same_content(document.project, project)
    document.redo()
    assert same_content(document.project, last)
    document.retract("drag")
    assert same_content(document.project, project)


def test_tissue_thickness_is_painted_like_a_layer(document: Document, project: Project) -> None:
    told: list[tuple[str, int]] = []
    document.layers_changed.connect(lambda name, vertices: told.append((name, len(vertices))))
    anchors = project.face.skull.anchors.copy()
    anchors[7:10] -= [0.0, 0, 2]
    thicker = replace(project.face, skull=replace(project.face.skull, anchors=anchors))
    document.edit(replace(project, face=thicker), "Thicken")
    assert told == [("anchors", 3)]
    document.undo()
    assert document.project.face.skull.anchors.tobytes() == project.face.skull.anchors.tobytes()


def test_what_changed_is_told_apart(project: Project) -> None:
    assert not changes(project, project.posed({"17": 1.0}))
    renamed = units.renamed(project, 20, "grimace")
    assert changes(project, renamed).units == {20}
    assert changes(project, units.moved_unit(project, 26, 0)).units == {12, 20, 17, 26}
    assert changes(project, replace(project, muscles=project.muscles[:1])).muscles == {"zygomaticus_major_R"}
    assert changes(project, replace(project, emotions=())).emotions == {"happiness", "surprise"}
    assert changes(project, replace(project, face=painted(project.face, [], 0.0))).layers == {}
    assert changes(project, replace(project, settings=replace(project.settings, density=2))).whole
    assert np.array_equal(
        changes(project, replace(project, face=painted(project.face, [5, 3], 0.9))).layers["stiffness"], [3, 5]
    )


def test_a_gesture_is_taken_back_as_if_it_had_never_begun(document: Document, project: Project) -> None:
    document.set_weights({"17": 0.5})
    document.set_weights({"26": 0.5})
    document.undo()
    for weight in (0.2, 0.4, 0.6):
        document.edit(units.with_activation(document.project, 12, "zygomaticus_major", weight), "Weigh", "drag 1")
    assert len(document.history.done) == 2
    document.retract("drag 1")
    assert document.history.done == ("Chin raiser",)
    assert document.project.units == project.units
    document.redo()
    assert document.project.expression == {"17": 0.5, "26": 0.5}
    document.retract("drag 1")
    assert document.history.done == ("Chin raiser", "Jaw drop")

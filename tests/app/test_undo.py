"""Whatever was done can be undone, and done again, to the last bit."""

from collections.abc import Callable
from dataclasses import dataclass, replace
from pathlib import Path

import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.commands import Command, ReplaceProject, SetWeights, set_weights
from app.differences import same_content
from app.document import Document
from app.history import History
from facemodel.project import Project

FIELDS = ("12L", "12R", "20L", "20R", "17", "26")
WEIGHTS = st.dictionaries(st.sampled_from(FIELDS), st.floats(0, 2), min_size=1, max_size=4)
Step = Callable[[Document], None]


def setting(weights: dict[str, float], gesture: str) -> Step:
    return lambda document: document.set_weights(weights, gesture=gesture)


def dragging(previews: list[dict[str, float]]) -> Step:
    def drag(document: Document) -> None:
        for weights in previews:
            document.preview(weights)
        document.commit()

    return drag


def replacing(other: Project) -> Step:
    def swap(document: Document) -> None:
        after = other if document.project.face is not other.face else other.posed({"17": 0.5})
        document.run(ReplaceProject("Other face", document.project, after))

    return swap


def steps(other: Project) -> st.SearchStrategy[list[Step]]:
    one = st.one_of(
        st.builds(setting, WEIGHTS, st.sampled_from(["", "nudge", "wheel"])),
        st.builds(dragging, st.lists(WEIGHTS, min_size=1, max_size=4)),
        st.builds(
            lambda name, strength: lambda document: document.apply_emotion(name, strength),
            st.sampled_from(["happiness", "surprise"]),
            st.floats(0, 2),
        ),
        st.just(Document.reset_expression),
        st.just(replacing(other)),
    )
    return st.lists(one, max_size=12)


@given(st.data(), WEIGHTS)
def test_undoing_and_redoing_everything_walks_through_the_same_states(
    project: Project, other_project: Project, data: st.DataObject, start: dict[str, float]
) -> None:
    document = Document(project.posed(start))
    states = [document.project]
    for step in data.draw(steps(other_project)):
        step(document)
        states[len(document.history.done) :] = [document.project]
    for expected in reversed(states[:-1]):
        document.undo()
        assert same_content(document.project, expected)
        assert document.shown == expected.expression
    assert document.history.to_undo is None
    assert not document.dirty
    for expected in states[1:]:
        document.redo()
        assert same_content(document.project, expected)
    assert document.history.to_redo is None


def test_undo_with_nothing_to_undo_changes_nothing(document: Document, project: Project) -> None:
    document.undo()
    document.redo()
    assert document.project is project


def test_a_new_step_forgets_what_was_undone(document: Document) -> None:
    document.set_weights({"17": 0.5})
    document.undo()
    document.set_weights({"26": 0.5})
    document.redo()
    assert document.project.expression == {"26": 0.5}
    assert document.history.done == ("Jaw drop",)


def test_nudges_of_one_gesture_are_one_step(document: Document) -> None:
    for weight in (0.1, 0.2, 0.3):
        document.set_weights({"12L": weight}, gesture="keys 1")
    document.set_weights({"12L": 0.4}, gesture="keys 2")
    assert len(document.history.done) == 2
    document.undo()
    assert document.project.expression == {"12L": 0.3}
    document.undo()
    assert document.project.expression == {}


def test_nudges_that_return_leave_no_step(document: Document) -> None:
    document.set_weights({"17": 1.0})
    for weight in (0.1, 0.0):
        document.set_weights({"12L": weight}, gesture="keys")
    assert document.history.done == ("Chin raiser",)


def test_steps_without_a_gesture_stay_apart(document: Document) -> None:
    document.set_weights({"12L": 0.1})
    document.set_weights({"12L": 0.2})
    assert len(document.history.done) == 2


def test_a_gesture_does_not_reach_back_over_a_save(document: Document) -> None:
    document.set_weights({"12L": 0.1}, gesture="keys")
    document.history.mark_saved()
    document.set_weights({"12L": 0.2}, gesture="keys")
    document.undo()
    assert document.project.expression == {"12L": 0.1}
    assert document.history.at_saved


@pytest.mark.parametrize(
    ("weights", "label"),
    [
        ({"12L": 0.5}, "Lip corner puller L"),
        ({"12": 0.5}, "Lip corner puller"),
        ({"17": 0.5}, "Chin raiser"),
        ({"17": 0.5, "26": 0.5}, "Expression"),
    ],
)
def test_a_step_is_called_after_what_it_moved(document: Document, weights: dict[str, float], label: str) -> None:
    document.set_weights(weights)
    assert document.history.done == (label,)


def test_a_step_holds_only_what_changed(project: Project) -> None:
    posed = project.posed({"12L": 0.5, "12R": 0.5, "17": 0.25})
    step = set_weights(posed, {"12L": 0.5, "12R": 0.75, "17": 0.0})
    assert (step.before, step.after) == ({"12R": 0.5, "17": 0.25}, {"12R": 0.75, "17": None})


@dataclass(frozen=True)
class Stiffen:
    """A command that keeps only a factor, so that undoing it makes an equal face, but not the same one."""

    factor: float
    label: str = "Stiffen"
    gesture: str = ""
    cost: int = 8
    changes: bool = True

    def do(self, project: Project) -> Project:
        layers = replace(project.face.layers, stiffness=project.face.layers.stiffness * self.factor)
        return replace(project, face=replace(project.face, layers=layers))

    def undo(self, project: Project) -> Project:
        return Stiffen(1 / self.factor).do(project)

    def joined(self, later: Command) -> Command | None:
        return None


def test_undoing_back_to_what_was_saved_is_clean_even_if_its_arrays_were_made_anew(
    document: Document, file: Path
) -> None:
    document.run(Stiffen(2.0))
    document.save(file)
    document.run(Stiffen(4.0))
    assert document.dirty
    document.undo()
    assert not document.dirty
    document.undo()
    assert document.dirty


def filled(history: History, count: int) -> None:
    for number in range(count):
        history.push(SetWeights(str(number), {"17": None}, {"17": number + 1.0}))


def test_the_oldest_steps_are_forgotten_and_the_saved_state_with_them() -> None:
    history = History(most_steps=3)
    filled(history, 3)
    assert not history.at_saved
    filled(history, 1)
    assert history.done == ("1", "2", "0")
    for _ in range(3):
        history.step_back()
    assert not history.at_saved


def test_the_saved_state_stays_where_it_is_when_older_steps_are_forgotten() -> None:
    history = History(most_steps=3)
    filled(history, 2)
    history.mark_saved()
    filled(history, 2)
    assert history.done == ("1", "0", "1")
    history.step_back()
    history.step_back()
    assert history.at_saved


def test_a_saved_state_that_can_no_longer_be_reached_is_not_found_by_chance() -> None:
    history = History()
    filled(history, 2)
    history.mark_saved()
    history.step_back()
    filled(history, 1)
    assert not history.at_saved


def test_faces_that_were_replaced_count_towards_the_memory(project: Project, other_project: Project) -> None:
    swap, back = ReplaceProject("a", project, other_project), ReplaceProject("b", other_project, project)
    assert swap.cost > project.face.skin.positions.nbytes
    history = History(most_bytes=3 * swap.cost)
    for command in (swap, back, swap, back, swap):
        history.push(command)
    assert history.cost <= 3 * swap.cost
    assert history.done == ("a", "b", "a")


def test_a_step_too_large_for_the_memory_can_still_be_undone(project: Project, other_project: Project) -> None:
    history = History(most_bytes=0)
    history.push(ReplaceProject("a", project, other_project))
    assert history.to_undo is not None

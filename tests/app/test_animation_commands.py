"""What happens over time is changed in steps that can be undone, cost what is different, and are told apart."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from app.authoring import parting, units
from app.commands import EditAnimation, edit_animation
from app.document import Document
from facemodel.animation.clip import Animation, Marker
from facemodel.animation.curve import Key, curve_of
from facemodel.animation.event import Event
from facemodel.animation.samples import Samples
from facemodel.animation.speech import Phoneme, Speech
from facemodel.animation.track import Track
from facemodel.io.project_file import project_bytes
from facemodel.project import Project
from tests.animation.strategies import animations


def keyed(value: float, channel: str = "12L") -> Track:
    return Track(channel, curve_of([Key(0.0, value), Key(1.0, 0.0)]))


@settings(max_examples=30)
@given(st.lists(animations(), min_size=2, max_size=4))
def test_any_change_is_undone_to_the_bit_and_done_again(project: Project, states: list[Animation]) -> None:
    document = Document(project)
    files = [project_bytes(project)]
    for animation in states:
        steps = len(document.history.done)
        document.edit(replace(document.project, animation=animation), "Animate")
        if len(document.history.done) > steps:
            files.append(project_bytes(document.project))
    for data in reversed(files[:-1]):
        document.undo()
        assert project_bytes(document.project) == data
    for data in files[1:]:
        document.redo()
        assert project_bytes(document.project) == data


@settings(max_examples=40)
@given(animations(), animations(), animations())
def test_two_steps_of_a_gesture_are_one_from_the_first_state_to_the_last(
    project: Project, first: Animation, second: Animation, third: Animation
) -> None:
    one, two = edit_animation(first, second, "Move", "drag"), edit_animation(second, third, "Move", "drag")
    both = one.joined(two)
    assert isinstance(both, EditAnimation)
    before, after = (project_bytes(replace(project, animation=each)) for each in (first, third))
    assert project_bytes(both.do(replace(project, animation=first))) == after
    assert project_bytes(both.undo(replace(project, animation=third))) == before
    assert one.joined(replace(two, gesture="other")) is None


def test_a_key_in_a_long_captured_curve_costs_a_key_and_not_the_curve(document: Document) -> None:
    captured = Samples(np.zeros(1_000_000, dtype=np.float32), 60.0)
    track = Track("12L", captured=captured)
    document.edit(replace(document.project, animation=Animation((track,))), "Import")
    imported = document.history.cost
    for value in range(10):
        keyed_track = replace(track, curve=curve_of([Key(value, 0.5)]))
        document.edit(replace(document.project, animation=Animation((keyed_track,))), "Key")
    assert imported > 4_000_000
    assert document.history.cost - imported < 40_000


def test_everyone_is_told_what_changed_and_nothing_else(document: Document) -> None:
    told: list[frozenset[str]] = []
    document.animation_changed.connect(told.append)
    changed = Animation((keyed(0.5), keyed(0.6, "12R")))
    for animation in (
        changed,
        replace(changed, tracks=(changed.tracks[0], keyed(0.7, "12R"))),
        replace(changed, markers=(Marker(1.0, "here"),)),
        replace(changed, events=(Event("a", ("12L",), 0.0),), speech=Speech((Phoneme("M", 0.0, 0.1),))),
    ):
        document.edit(replace(document.project, animation=animation), "Animate")
    assert told == [{"12L", "12R"}, {"12R"}, {"12R", "markers"}, {"markers", "events", "speech"}]
    document.set_weights({"12": 0.3})
    assert len(told) == 4


def test_animating_makes_no_solution_stale(document: Document) -> None:
    stale = document.stale_fields
    document.edit(replace(document.project, animation=Animation((keyed(0.5),))), "Animate")
    assert document.stale_fields == stale


def test_what_is_played_is_shown_over_the_sliders_and_is_no_step(document: Document) -> None:
    document.set_weights({"17": 0.4, "12L": 0.2})
    document.play({"12L": 0.9, "17": 0.0})
    assert document.shown == {"12L": 0.9}
    assert document.history.done == ("Expression",)
    document.play({})
    assert document.shown == {"17": 0.4, "12L": 0.2}


def test_a_slider_that_is_moved_while_something_plays_shows_its_own_weight(document: Document) -> None:
    document.play({"12L": 0.9, "12R": 0.9})
    document.preview({"12L": 0.3})
    assert document.shown == {"12L": 0.3, "12R": 0.9}
    document.commit()
    assert document.shown == {"12L": 0.3, "12R": 0.9}
    document.play({"12L": 0.8, "12R": 0.8})
    document.cancel_preview()
    assert document.shown == {"12L": 0.8, "12R": 0.8}
    document.reset_expression()
    assert document.shown == {}


def test_weights_become_keys_while_the_document_is_keying(document: Document) -> None:
    def keying(project: Project, weights: dict[str, float]) -> Project:
        tracks = tuple(keyed(value, name) for name, value in weights.items())
        return replace(project, animation=Animation(tracks))

    document.keying = keying
    document.preview({"12": 0.5})
    document.commit()
    assert document.project.expression == {}
    assert [track.channel for track in document.project.animation.tracks] == ["12L", "12R"]
    document.undo()
    assert document.project.animation.tracks == ()


def test_another_head_keeps_what_happens_over_time(document: Document) -> None:
    document.edit(replace(document.project, animation=Animation((keyed(0.5),))), "Animate")
    document.switch_face("ben")
    assert document.project.animation.track("12L") is not None


@pytest.mark.parametrize(
    ("change", "tracks", "events"),
    [
        (lambda p: units.renumbered(p, 12, 112), ["112L", "112R", "17"], [("112L", "112R"), ("17",)]),
        (lambda p: parting.joined(p, 12), ["12", "17"], [("12",), ("17",)]),
        (lambda p: parting.split(p, 17), ["12L", "12R", "17L", "17R"], [("12L", "12R"), ("17L", "17R")]),
        (lambda p: units.without_units(p, [17]), ["12L", "12R"], [("12L", "12R")]),
        (lambda p: units.renamed(p, 12, "grin"), ["12L", "12R", "17"], [("12L", "12R"), ("17",)]),
    ],
)
def test_tracks_and_events_go_with_the_units_that_they_move(
    project: Project, change: object, tracks: list[str], events: list[tuple[str, ...]]
) -> None:
    animation = Animation(
        (keyed(0.5), keyed(0.6, "12R"), keyed(0.7, "17")),
        (Event("smile", ("12L", "12R"), 0.0), Event("chin", ("17",), 0.0)),
    )
    found = change(replace(project, animation=animation)).animation  # type: ignore[operator]
    assert [track.channel for track in found.tracks] == tracks
    assert [event.channels for event in found.events] == events

"""Everything in the timeline's menu can be done, and does it in one step."""

import pytest

from app.actions import Context
from app.actions.action import perform
from app.document import Document
from app.timeline.actions import timeline_actions
from app.timeline.chosen import Chosen
from app.timeline.deeds import copy
from app.timeline.timeline import Timeline
from facemodel.animation.clip import STILL
from facemodel.sameness import same

PLACES = ("timeline.start", "timeline.end", "timeline.frame", "timeline.key-back", "timeline.key-on")


def ids(timeline: Timeline) -> list[str]:
    return [action.id for action in timeline_actions(timeline)]


def test_every_action_has_a_name_of_its_own(timeline: Timeline) -> None:
    assert len(ids(timeline)) == len(set(ids(timeline)))
    assert all(action.hint and action.menu[0] == "Animation" for action in timeline_actions(timeline))


def test_every_deed_is_one_step_at_most_and_undone_without_a_trace(
    timeline: Timeline, document: Document, context: Context
) -> None:
    before = document.project.animation
    timeline.choose(Chosen({("12L", 0): (1,)}))
    copy(timeline)
    for action in timeline_actions(timeline):
        timeline.choose(Chosen({("12L", 0): (1,)}, frozenset(("smirk 1",))))
        timeline.change(lines=frozenset(("track 26",)) if "layer" in action.id else frozenset(), page="")
        timeline.playhead.go(2.5)
        perform(action, context)
        timeline.playhead.pause()
        timeline.playhead.auto_key = False
        assert len(document.history.done) <= 1, action.id
        document.undo()
        assert same(document.project.animation, before), action.id


def test_nothing_can_be_done_to_nothing(timeline: Timeline, document: Document, context: Context, project) -> None:
    document.restore(project, None)
    possible = {action.id for action in timeline_actions(timeline) if action.enabled(context)}
    assert not {key for key in possible if key.startswith(("timeline.shape", "timeline.ease", "timeline.curves"))}
    assert not possible & {"timeline.cut", "timeline.copy", "timeline.paste", "timeline.delete", "timeline.mirror"}
    assert {"timeline.play", "timeline.key", "timeline.drop.blink"} <= possible
    assert same(timeline.animation, STILL)


@pytest.mark.parametrize("key", PLACES)
def test_going_about_makes_no_step(timeline: Timeline, document: Document, context: Context, key: str) -> None:
    timeline.playhead.go(1.2)
    for action in timeline_actions(timeline):
        if action.id.startswith(key):
            perform(action, context)
    if key not in ("timeline.start", "timeline.end"):
        assert document.history.done == ()


def test_auto_key_turns_what_hands_do_into_keys(timeline: Timeline, document: Document, context: Context) -> None:
    (auto,) = (action for action in timeline_actions(timeline) if action.id == "timeline.auto-key")
    timeline.playhead.go(3.5)
    perform(auto, context)
    assert auto.checked(context)
    document.set_weights({"17": 0.7})
    assert timeline.animation.track("17").curve.near(3.5) is not None
    assert document.project.expression == {}
    perform(auto, context)
    document.set_weights({"17": 0.2})
    assert document.project.expression == {"17": 0.2}

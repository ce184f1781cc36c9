"""The lines of the timeline: what is listed, in which order, found, folded, and what their switches do."""

from dataclasses import replace

import pytest

from app.timeline.lines import HEAD_AND_EYES, channel_line, lines_of, rows_of
from app.timeline.state import TimelineState
from app.timeline.switches import flip_clips, flip_fold, flip_switch, switches_of
from app.timeline.timeline import Timeline
from facemodel.animation.event import Event
from facemodel.animation.track import Track


def listed(timeline: Timeline, **state) -> list[str]:
    project = timeline.document.project
    return [line.key for line in lines_of(project.animation, project.units, replace(timeline.state, **state))]


def line(timeline: Timeline, key: str):
    project = timeline.document.project
    return next(each for each in lines_of(project.animation, project.units, timeline.state) if each.key == key)


def test_all_that_happens_is_listed_from_marks_to_tracks(timeline: Timeline) -> None:
    keys = listed(timeline)
    assert keys[:5] == ["expressions", "audio", "speech", "life", "lane 0"]
    assert keys.index("track 12L") == keys.index("track 12R") - 1
    assert keys[-2:] == [f"group {HEAD_AND_EYES}", "track head.yaw"]
    assert keys[keys.index("track 26") + 1] == "layer 26 1"


def test_a_still_face_has_one_line(timeline: Timeline, project) -> None:
    timeline.document.restore(project, None)
    assert listed(timeline) == ["expressions"]


@pytest.mark.parametrize(
    ("sought", "found"),
    [
        ("12", ["track 12L", "track 12R"]),
        ("12 left", ["track 12L"]),
        ("lip corner", ["track 12L", "track 12R"]),
        ("head", ["track head.yaw"]),
        ("jaw", ["track 26", "layer 26 1"]),
        ("nobody", []),
    ],
)
def test_tracks_are_found_by_number_name_and_side(timeline: Timeline, sought: str, found: list[str]) -> None:
    keys = [key for key in listed(timeline, sought=sought) if key.startswith(("track", "layer"))]
    assert keys == found


def test_events_are_found_by_what_they_move(timeline: Timeline) -> None:
    assert "lane 0" in listed(timeline, sought="smirk")
    assert "lane 0" in listed(timeline, sought="stretcher")
    assert "lane 0" not in listed(timeline, sought="chin")


def test_folds_hide_what_is_inside_and_a_search_opens_them(timeline: Timeline) -> None:
    group = line(timeline, f"group {HEAD_AND_EYES}")
    flip_fold(timeline, group)
    assert "track head.yaw" not in listed(timeline)
    assert "track head.yaw" in listed(timeline, sought="turn")
    flip_fold(timeline, group)
    assert "track head.yaw" in listed(timeline)


def test_clips_share_a_lane_until_they_overlap(timeline: Timeline) -> None:
    assert [key for key in listed(timeline) if key.startswith("lane")] == ["lane 0"]
    animation = timeline.animation
    over = Event("wince 1", ("17",), 0.5)
    timeline.edit(replace(animation, events=(*animation.events, over)), "Add")
    assert [key for key in listed(timeline) if key.startswith("lane")] == ["lane 0", "lane 1"]


def test_a_clip_opens_line_by_line(timeline: Timeline) -> None:
    flip_clips(timeline, frozenset(("smirk 1",)))
    inner = [key for key in listed(timeline) if key.startswith("event")]
    assert inner == ["event Smirk 12L", "event Smirk head.roll"]
    flip_fold(timeline, line(timeline, "lane 0"))
    assert not [key for key in listed(timeline) if key.startswith("event")]
    flip_fold(timeline, line(timeline, "lane 0"))
    assert len([key for key in listed(timeline) if key.startswith("event")]) == 3


def test_a_group_of_ones_own_comes_first_in_the_order_of_the_tracks(timeline: Timeline) -> None:
    animation = timeline.animation
    tracks = [replace(track, group="Mine") if track.channel in ("26", "17") else track for track in animation.tracks]
    timeline.edit(replace(animation, tracks=tuple(reversed(tracks))), "Group")
    keys = listed(timeline)
    first = keys.index("group Mine")
    assert keys[first + 1 : first + 4] == ["track 26", "layer 26 1", "track 17"]


def test_a_line_that_sums_up_has_all_rows_of_its_tracks(timeline: Timeline) -> None:
    group = line(timeline, f"group {HEAD_AND_EYES}")
    assert rows_of(group, timeline.animation) == (("head.yaw", 0),)
    assert set(rows_of(line(timeline, "expressions"), timeline.animation)) == {
        *((track.channel, 0) for track in timeline.animation.tracks),
        ("26", 1),
    }


@pytest.mark.parametrize("key", ["track 17", "layer 26 1", "lane 0", "speech", "life", "audio"])
def test_every_line_can_be_muted_in_one_step(timeline: Timeline, key: str) -> None:
    flip_switch(timeline, line(timeline, key), "muted")
    assert switches_of(line(timeline, key), timeline.animation)["muted"]
    assert len(timeline.document.history.done) == 1
    timeline.document.undo()
    assert not switches_of(line(timeline, key), timeline.animation)["muted"]


def test_a_muted_track_stands_still_and_a_soloed_one_moves_alone(timeline: Timeline) -> None:
    timeline.playhead.go(3.0)
    assert timeline.document.shown["17"] == pytest.approx(0.5)
    flip_switch(timeline, line(timeline, "track 17"), "muted")
    assert not timeline.document.shown.get("17")
    flip_switch(timeline, line(timeline, "track 12R"), "solo")
    assert {name for name, weight in timeline.document.shown.items() if weight} == {"12R"}


def test_a_switch_of_one_chosen_track_is_that_of_all(timeline: Timeline) -> None:
    timeline.change(lines=frozenset(("track 17", "track 12L", "track 12R")))
    flip_switch(timeline, line(timeline, "track 17"), "locked")
    locked = {track.channel for track in timeline.animation.tracks if track.locked}
    assert locked == {"17", "12L", "12R", "20L"}


def test_channels_are_named_for_people(project) -> None:
    assert (channel_line("12L", project.units).number, channel_line("12L", project.units).side) == ("12", "left")
    assert channel_line("17", project.units).side == "both"
    assert channel_line("eyeR.pitch", project.units).side == "right"
    assert channel_line("head.yaw", project.units).title == "Head turn"
    assert channel_line("999", project.units).title == "999"


def test_a_track_without_a_group_has_the_one_of_its_unit(project) -> None:
    lines = lines_of(replace(project.animation, tracks=(Track("12L"), Track("head.x"))), project.units, TimelineState())
    assert [each.title for each in lines if each.kind == "group"] == ["Lower face · diagonal", HEAD_AND_EYES]

"""Setting keys from what is seen, and going from key to key."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

import numpy as np

from app.timeline.chosen import Chosen
from app.timeline.timeline import Timeline
from app.timeline.values import refuse_locked
from facemodel.animation.channels import RIGID
from facemodel.animation.clip import Animation
from facemodel.animation.curve import SAME_TIME
from facemodel.animation.editing.expressions import expression_keys, keyed, with_expression
from facemodel.animation.editing.keys import with_key
from facemodel.animation.editing.selection import Row, curve_of_row, rows, selected
from facemodel.animation.editing.tracks import with_track
from facemodel.animation.keyed import values_of
from facemodel.animation.timecode import snapped
from fem.types import FloatArray


def key_expression(timeline: Timeline, name: str = "") -> None:
    """Make what is shown now a key expression under the playhead: a key in every channel that takes part."""
    timeline.document.commit()
    time, state = _now(timeline), timeline.state
    known = next((e.name for e in timeline.animation.expressions if abs(e.time - time) <= SAME_TIME), "")
    shown = {name: weight for name, weight in timeline.document.shown.items() if weight}
    rigid = {name: timeline.playhead.pose.rigid[name] for name in _turned(timeline)}
    units = timeline.document.project.units
    made = with_expression(timeline.animation, time, {**shown, **rigid}, name or known, units, state.spacing)
    chosen = Chosen(expression_keys(made, time), expressions=frozenset((time,)))
    timeline.edit(made, "Key expression", chosen=chosen)


def key_channels(timeline: Timeline, channels: Iterable[str]) -> None:
    """Key what some channels show now, under the playhead."""
    timeline.document.commit()
    time, state = _now(timeline), timeline.state
    shown, rigid = timeline.document.shown, timeline.playhead.pose.rigid
    wanted = {name: rigid.get(name, 0.0) if name in RIGID else shown.get(name, 0.0) for name in channels}
    units = timeline.document.project.units
    made = keyed(timeline.animation, time, wanted, units, state.spacing, state.shape)
    among = [row for row in rows(made) if row[0] in wanted]
    timeline.edit(made, "Set keys", chosen=Chosen(selected(made, time, time, among)))


def insert_key(timeline: Timeline, channel: str, time: float) -> None:
    """A key on the curve of a channel as it runs, so that nothing is seen to change.

    Raises
    ------
    AnimationError
        If the track is locked.
    """
    track = timeline.animation.track(channel)
    if track is None:
        return
    refuse_locked(timeline, channel)
    at = max(snapped(time, timeline.rate) if "frames" in timeline.state.snaps else time, 0.0)
    made = with_key(track.curve, at, float(values_of(track.curve, np.array([at]))[0]))
    after = with_track(timeline.animation, replace(track, curve=made))
    timeline.edit(after, "Insert key", chosen=Chosen(selected(after, at, at, [(channel, 0)])))


def chosen_channels(timeline: Timeline) -> tuple[str, ...]:
    """Channels of the chosen lines, in their order; groups stand for all of theirs."""
    lines = timeline.state.lines
    found = [track.channel for track in timeline.animation.tracks if f"track {track.channel}" in lines]
    found += [key.split(" ")[1] for key in lines if key.startswith("layer ")]
    return tuple(dict.fromkeys(found))


def go_to_key(timeline: Timeline, way: int) -> None:
    """Go to the next key of the chosen lines, or of all, or back to the one before."""
    channels = chosen_channels(timeline)
    among = [row for row in rows(timeline.animation) if not channels or row[0] in channels]
    times = key_times(timeline.animation, among)
    here = timeline.playhead.time
    there = times[times > here + SAME_TIME] if way > 0 else times[times < here - SAME_TIME]
    if len(there):
        timeline.playhead.go(float(there[0] if way > 0 else there[-1]))


def key_times(animation: Animation, among: Iterable[Row]) -> FloatArray:
    """Times at which some rows have a key, in order, each once."""
    times = [curve_of_row(animation, row).times for row in among]
    return np.unique(np.concatenate(times)) if times else np.zeros(0)


def _now(timeline: Timeline) -> float:
    """The time that keys are set at: that of the playhead, on a frame where things snap to frames."""
    time = timeline.playhead.time
    return snapped(time, timeline.rate) if "frames" in timeline.state.snaps else time


def _turned(timeline: Timeline) -> tuple[str, ...]:
    """Rigid channels that have a track of their own; events and idle life move heads without one."""
    rigid = timeline.playhead.pose.rigid
    return tuple(track.channel for track in timeline.animation.tracks if track.channel in rigid)

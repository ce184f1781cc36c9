"""Turning over what stands before a line: folds, mute, solo, lock."""

from __future__ import annotations

from dataclasses import replace
from typing import Literal

from app.timeline.lines import Line, clips_of
from app.timeline.timeline import Timeline
from facemodel.animation.clip import Animation
from facemodel.animation.editing.events import changed_events
from facemodel.animation.editing.layers import with_layer_changed
from facemodel.animation.editing.tracks import flagged

Switch = Literal["muted", "solo", "locked"]

TITLES: dict[Switch, tuple[str, str]] = {
    "muted": ("Mute", "Unmute"),
    "solo": ("Solo", "Unsolo"),
    "locked": ("Lock", "Unlock"),
}


def flip_fold(timeline: Timeline, line: Line) -> None:
    """Hide the inner lines of a line, or show them."""
    if line.kind != "events":
        timeline.change(flipped=timeline.state.flipped ^ {line.key})
        return
    events = [event for event in timeline.animation.events if event.key in line.members]
    clips = {f"clip {name}" for name in clips_of(events)}
    flipped = timeline.state.flipped
    timeline.change(flipped=flipped | clips if line.folded else flipped - clips)


def flip_clips(timeline: Timeline, keys: frozenset[str]) -> None:
    """Show what the clips of some events do, line by line, or hide it."""
    events = [event for event in timeline.animation.events if event.key in keys]
    timeline.change(flipped=timeline.state.flipped ^ {f"clip {name}" for name in clips_of(events)})


def switches_of(line: Line, animation: Animation) -> dict[Switch, bool]:
    """The switches of a line, and whether they are on."""
    track = animation.track(line.channel)
    if line.kind == "track" and track is not None:
        return {"muted": track.muted, "solo": track.solo, "locked": track.locked}
    if line.kind == "group":
        tracks = [track for track in animation.tracks if track.channel in line.members]
        return {name: all(getattr(each, name) for each in tracks) for name in TITLES}
    if line.kind == "layer" and track is not None:
        return {"muted": track.layers[line.layer - 1].muted}
    if line.kind in ("event", "events"):
        return {"muted": all(event.muted for event in animation.events if event.key in line.members)}
    part = {"speech": animation.speech, "life": animation.idle, "audio": animation.audio}.get(line.kind)
    return {} if part is None else {"muted": part.muted}


def flip_switch(timeline: Timeline, line: Line, switch: Switch) -> None:
    """Turn a switch of a line over, in one step; if the line is among several chosen ones, of all of these."""
    on = not switches_of(line, timeline.animation).get(switch, False)
    made = with_switch(timeline.animation, line, switch, on, timeline.state.lines)
    timeline.edit(made, f"{TITLES[switch][0 if on else 1]} {line.title}")


def with_switch(animation: Animation, line: Line, switch: Switch, on: bool, chosen: frozenset[str]) -> Animation:
    """An animation in which a line, and the other chosen tracks if it is one of them, is muted, soloed or locked."""
    if line.kind in ("track", "group"):
        channels = {line.channel} if line.kind == "track" else set(line.members)
        if line.key in chosen:
            channels |= {key.removeprefix("track ") for key in chosen if key.startswith("track ")}
        given: dict[str, bool | None] = {switch: on}
        return flagged(
            animation, channels, muted=given.get("muted"), solo=given.get("solo"), locked=given.get("locked")
        )
    if line.kind == "layer":
        return with_layer_changed(animation, line.channel, line.layer, muted=on)
    if line.kind in ("event", "events"):
        return changed_events(animation, line.members, lambda event: replace(event, muted=on))
    if line.kind == "speech":
        return replace(animation, speech=replace(animation.speech, muted=on))
    if line.kind == "life" and animation.idle is not None:
        return replace(animation, idle=replace(animation.idle, muted=on))
    if line.kind == "audio" and animation.audio is not None:
        return replace(animation, audio=replace(animation.audio, muted=on))
    return animation

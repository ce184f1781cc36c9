"""What the inspector is about."""

from __future__ import annotations

from app.timeline.timeline import Timeline

KINDS = ("layer", "life", "speech", "audio", "track")
"""Kinds of lines that have a page of their own."""


def subject_of(timeline: Timeline) -> str:
    """The name of a page, and behind it what a page of that name has to be made anew for."""
    state, chosen = timeline.state, timeline.chosen
    if state.page:
        return f"curves {state.page}"
    if chosen.expressions and not chosen.events:
        return f"expression {sorted(chosen.expressions)}"
    if chosen.keys:
        channels = sorted({channel for channel, _ in chosen.keys})
        return f"keys {state.style} {channels} {chosen.key_count == 1}"
    if chosen.events:
        return f"event {state.style} {sorted(chosen.events)}"
    if chosen.sounds:
        return f"sound {state.style} {sorted(chosen.sounds)}"
    if chosen.markers:
        return f"marker {state.style} {sorted(chosen.markers)}"
    if chosen.ranges:
        return f"range {state.style} {sorted(chosen.ranges)}"
    if len(state.lines) > 1 and all(line.startswith("track ") for line in state.lines):
        return f"track {state.style} {sorted(state.lines)}"
    if len(state.lines) == 1:
        (line,) = state.lines
        kind = line.partition(" ")[0]
        if kind in KINDS:
            return f"{kind} {state.style} {line}"
    return f"clip {state.style}"

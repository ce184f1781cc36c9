"""Markers, named ranges, the frame rate and what is played."""

from __future__ import annotations

from dataclasses import replace

from facemodel.animation.clip import FASTEST, SLOWEST, Animation, Marker, NamedRange
from facemodel.animation.curve import SAME_TIME


def with_marker(animation: Animation, time: float, name: str = "") -> Animation:
    """An animation with a marker, in place of one at that time."""
    others = [marker for marker in animation.markers if abs(marker.time - time) > SAME_TIME]
    return replace(animation, markers=tuple(sorted((*others, Marker(time, name)), key=lambda each: each.time)))


def without_marker(animation: Animation, time: float) -> Animation:
    """An animation without the marker at a time."""
    return replace(animation, markers=tuple(each for each in animation.markers if abs(each.time - time) > SAME_TIME))


def moved_marker(animation: Animation, time: float, to: float) -> Animation:
    """An animation in which a marker is at another time."""
    name = next((each.name for each in animation.markers if abs(each.time - time) <= SAME_TIME), None)
    return animation if name is None else with_marker(without_marker(animation, time), to, name)


def with_range(animation: Animation, name: str, start: float, end: float) -> Animation:
    """An animation with a named range, in place of the one of that name; the earlier time is its start."""
    low, high = min(start, end), max(start, end)
    if high - low <= SAME_TIME:
        return animation
    others = [each for each in animation.ranges if each.name != name]
    return replace(animation, ranges=tuple(sorted((*others, NamedRange(name, low, high)), key=lambda each: each.start)))


def without_range(animation: Animation, name: str) -> Animation:
    """An animation without a named range."""
    return replace(animation, ranges=tuple(each for each in animation.ranges if each.name != name))


def with_rate(animation: Animation, rate: float) -> Animation:
    """An animation shown in so many frames a second, within what is possible; nothing moves in time."""
    return replace(animation, rate=min(max(float(rate), SLOWEST), FASTEST))


def played(animation: Animation, start: float, end: float) -> Animation:
    """An animation that is played from one time to another; at least one frame of it."""
    low, high = min(start, end), max(start, end)
    return replace(animation, start=low, end=max(high, low + 1.0 / animation.rate))

"""Profiles of the mouth sphincter as a hand draws them: knots moved, added and taken out."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from facemodel.muscles import Profile

APART = 0.02
"""Smallest distance of two knots, in the unit of the axis."""

ROUND = 3
"""Decimals that a hand can mean."""


@dataclass(frozen=True)
class Axes:
    """What can be drawn.

    Attributes
    ----------
    reach : right end of the horizontal axis, which begins at zero
    least, most : ends of the vertical one
    mark : distance that has a name, and the name
    """

    reach: float
    least: float
    most: float
    mark: tuple[float, str]


def moved(profile: Profile, knot: int, at: float, value: float, axes: Axes) -> Profile:
    """A profile with one knot elsewhere: the first stays at zero, the last on zero, and none passes another."""
    last = len(profile.at) - 1
    low = profile.at[knot - 1] + APART if knot else 0.0
    high = profile.at[knot + 1] - APART if knot < last else axes.reach
    at = 0.0 if knot == 0 else round(min(max(at, low), high), ROUND)
    value = 0.0 if knot == last else round(min(max(value, axes.least), axes.most), ROUND)
    return Profile(_with(profile.at, knot, at), _with(profile.values, knot, value))


def grown(profile: Profile, at: float, value: float, axes: Axes) -> tuple[Profile, int] | None:
    """A profile with one knot more, and which it is; none where there is no room for it."""
    at, value = round(at, ROUND), round(min(max(value, axes.least), axes.most), ROUND)
    place = int(np.searchsorted(profile.at, at))
    if not 0 < place < len(profile.at) or min(abs(at - each) for each in profile.at) < APART:
        return None
    places, heights = ((*each[:place], new, *each[place:]) for each, new in ((profile.at, at), (profile.values, value)))
    return Profile(places, heights), place


def shrunk(profile: Profile, knot: int) -> Profile | None:
    """A profile with one knot less; none if it is an end."""
    if not 0 < knot < len(profile.at) - 1:
        return None
    return Profile(_without(profile.at, knot), _without(profile.values, knot))


def _with(numbers: Sequence[float], place: int, number: float) -> tuple[float, ...]:
    return (*numbers[:place], number, *numbers[place + 1 :])


def _without(numbers: Sequence[float], place: int) -> tuple[float, ...]:
    return (*numbers[:place], *numbers[place + 1 :])

"""Keys of one curve: put, taken, moved, scaled and given other shapes."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

import numpy as np

from facemodel.animation.curve import BEZIER, SAME_TIME, SHAPES, Curve, Handle, Shape
from facemodel.animation.keyed import values_of
from fem.types import BoolArray, FloatArray, IntArray

Places = Sequence[int] | IntArray
"""Places of keys in their curve."""

Map = Callable[[FloatArray], FloatArray]

THIRD = 1.0 / 3.0
SLOPE_STEP = 1e-5
"""Seconds over which the slope of a curve is taken; a thousandth of a frame."""


def with_key(curve: Curve, time: float, value: float, shape: Shape | None = None) -> Curve:
    """A curve with a key at a time; one that is there already is only given another value.

    Parameters
    ----------
    shape : how the curve goes on from a new key; as it did there if not given, smoothly in a curve without keys
    """
    found = curve.near(time)
    if found is not None:
        values = curve.values.copy()
        values[found] = value
        changed = replace(curve, values=values)
        return changed if shape is None else with_shape(changed, [found], shape)
    place = int(np.searchsorted(curve.times, time))
    code = SHAPES.index(shape or "smooth") if shape or not len(curve) else int(curve.shapes[max(place - 1, 0)])
    made = Curve(
        np.insert(curve.times, place, time),
        np.insert(curve.values, place, value),
        np.insert(curve.shapes, place, code).astype(np.int8),
        np.insert(curve.handles, place, 0.0, axis=0),
        np.insert(curve.weighted, place, False),
        np.insert(curve.broken, place, False),
        curve.overshoot,
    )
    return _levelled(made, place, curve) if code == BEZIER else made


def _levelled(made: Curve, place: int, before: Curve) -> Curve:
    """Handles of a new key along the curve as it ran there."""
    time = made.times[place]
    ends = values_of(before, np.array([time - SLOPE_STEP, time + SLOPE_STEP]))
    slope = (ends[1] - ends[0]) / (2 * SLOPE_STEP)
    return with_handles(made, place, _thirds(made, place, -1, slope), _thirds(made, place, 1, slope))


def _thirds(curve: Curve, place: int, side: int, slope: float) -> Handle:
    """The handle of a slope, a third of the way to the next key on one side."""
    other = place + side
    reach = THIRD * abs(curve.times[other] - curve.times[place]) if 0 <= other < len(curve) else THIRD
    return side * float(reach), side * float(reach) * float(slope)


def without_keys(curve: Curve, places: Places) -> Curve:
    """A curve without some keys."""
    kept = np.ones(len(curve), dtype=np.bool_)
    kept[np.asarray(places, dtype=np.int64)] = False
    return taken(curve, np.flatnonzero(kept))


def taken(curve: Curve, places: Places) -> Curve:
    """The curve through some of its keys alone, in the order of their places."""
    rows = np.asarray(places, dtype=np.int64)
    return Curve(
        curve.times[rows],
        curve.values[rows],
        curve.shapes[rows],
        curve.handles[rows],
        curve.weighted[rows],
        curve.broken[rows],
        curve.overshoot,
    )


def moved(curve: Curve, places: Places, seconds: float, rise: float) -> tuple[Curve, IntArray]:
    """A curve with some keys moved in time and value, and where they are now; keys that they land on give way."""
    return transformed(curve, places, lambda times: times + seconds, lambda values: values + rise)


def scaled(
    curve: Curve,
    places: Places,
    about: tuple[float, float],
    factors: tuple[float, float],
) -> tuple[Curve, IntArray]:
    """A curve with some keys moved towards a point or away from it, with their handles, and where they are now.

    Parameters
    ----------
    about : time and value that stay
    factors : of time, above 0, and of value
    """
    rows = np.asarray(places, dtype=np.int64)
    handles = curve.handles.copy()
    handles[rows] *= [factors[0], factors[1], factors[0], factors[1]]
    return transformed(
        replace(curve, handles=handles),
        rows,
        lambda times: about[0] + factors[0] * (times - about[0]),
        lambda values: about[1] + factors[1] * (values - about[1]),
    )


def transformed(curve: Curve, places: Places, time: Map, value: Map) -> tuple[Curve, IntArray]:
    """A curve with some keys at other times and values, and where they are now; keys that they land on give way."""
    rows = np.asarray(places, dtype=np.int64)
    times, values = curve.times.copy(), curve.values.copy()
    times[rows], values[rows] = time(times[rows]), value(values[rows])
    chosen = np.zeros(len(curve), dtype=np.bool_)
    chosen[rows] = True
    return _arranged(replace(curve, times=times, values=values), chosen)


def _arranged(curve: Curve, chosen: BoolArray) -> tuple[Curve, IntArray]:
    """Keys in the order of time; of those at one time the last chosen one stays."""
    order = np.lexsort((chosen, curve.times))
    times = curve.times[order]
    stays = np.append(np.diff(times) > SAME_TIME, True)
    if not stays.all():
        # A chosen key just before one that was not chosen has to win against it as well.
        near = np.split(order, np.flatnonzero(stays)[:-1] + 1)
        order = np.array([_winner(group, chosen) for group in near], dtype=np.int64)
    return taken(curve, order), np.flatnonzero(chosen[order])


def _winner(group: IntArray, chosen: BoolArray) -> int:
    among = group[chosen[group]]
    return int(among[-1] if len(among) else group[-1])


def with_values(curve: Curve, places: Places, value: float | FloatArray) -> Curve:
    """A curve with some keys at a value, or at one each."""
    values = curve.values.copy()
    values[np.asarray(places, dtype=np.int64)] = value
    return replace(curve, values=values)


def with_shape(curve: Curve, places: Places, shape: Shape) -> Curve:
    """A curve that goes on from some keys in another way; handles of a Bezier segment begin as the curve ran before."""
    rows = np.asarray(places, dtype=np.int64)
    shapes = curve.shapes.copy()
    fresh = rows[shapes[rows] != SHAPES.index(shape)]
    shapes[rows] = SHAPES.index(shape)
    made = replace(curve, shapes=shapes)
    if shape != "bezier":
        return made
    handles = made.handles.copy()
    for place in fresh.tolist():
        if place + 1 < len(curve):
            begin, end = curve.times[place], curve.times[place + 1]
            out, into = _end_slopes(curve, begin, end)
            reach = THIRD * (end - begin)
            handles[place, 2:] = reach, reach * out
            handles[place + 1, :2] = -reach, -reach * into
    return replace(made, handles=handles)


def _end_slopes(curve: Curve, begin: float, end: float) -> tuple[float, float]:
    """Slopes of a curve just behind one key and just before the next."""
    step = min(SLOPE_STEP, (end - begin) / 8)
    at = values_of(curve, np.array([begin, begin + step, begin + 2 * step, end - 2 * step, end - step, end]))
    # One-sided differences of second order: between two frames a curve bends much within a step.
    return float(4 * at[1] - at[2] - 3 * at[0]) / (2 * step), float(3 * at[5] - 4 * at[4] + at[3]) / (2 * step)


def with_handles(curve: Curve, place: int, arrives: Handle | None = None, leaves: Handle | None = None) -> Curve:
    """A curve with other handles at a key; of one that is not broken the other handle turns along, and keeps its reach.

    Parameters
    ----------
    arrives, leaves : seconds (not above 0, not below 0) and value from the key; the one not given follows
    """
    handles = curve.handles.copy()
    if arrives is not None:
        handles[place, :2] = min(arrives[0], 0.0), arrives[1]
    if leaves is not None:
        handles[place, 2:] = max(leaves[0], 0.0), leaves[1]
    if not curve.broken[place]:
        if leaves is None and arrives is not None and handles[place, 0] < -SAME_TIME:
            handles[place, 3] = handles[place, 2] * handles[place, 1] / handles[place, 0]
        elif leaves is not None and handles[place, 2] > SAME_TIME:
            handles[place, 1] = handles[place, 0] * handles[place, 3] / handles[place, 2]
    return replace(curve, handles=handles)


def with_flags(curve: Curve, places: Places, weighted: bool | None = None, broken: bool | None = None) -> Curve:
    """A curve whose handles at some keys count their length, or turn on their own, or no longer do."""
    rows = np.asarray(places, dtype=np.int64)
    weighs, breaks = curve.weighted.copy(), curve.broken.copy()
    if weighted is not None:
        weighs[rows] = weighted
    if broken is not None:
        breaks[rows] = broken
    made = replace(curve, weighted=weighs, broken=breaks)
    if broken is False:
        for place in rows.tolist():
            made = with_handles(made, place, leaves=tuple(made.handles[place, 2:].tolist()))
    return made

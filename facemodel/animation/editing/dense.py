"""Whole curves: baked, simplified, smoothed, warped in time, offset and looped."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace
from itertools import pairwise

import numpy as np
from scipy.ndimage import gaussian_filter1d

from facemodel.animation.captured import displaced
from facemodel.animation.clip import Animation
from facemodel.animation.curve import SAME_TIME, Curve, Shape, curve_of, curve_through
from facemodel.animation.editing.keys import with_values
from facemodel.animation.editing.selection import with_row
from facemodel.animation.evaluation import frame_times
from facemodel.animation.keyed import values_of
from facemodel.animation.samples import Samples
from facemodel.animation.track import Track
from fem.types import FloatArray

SMOOTH_STEPS = 8
"""Samples of a keyed curve within one standard deviation when it is smoothed."""

Span = tuple[float, float]
"""From when to when, seconds."""


def own_values(track: Track, times: FloatArray) -> FloatArray:
    """What a track comes to (T,) at times (T,): what was captured, its layers and its keys."""
    captured = 0.0 if track.captured is None else displaced(track, times)
    return np.asarray(captured + values_of(track.curve, times))


def extent(track: Track) -> Span:
    """From the first to the last of a track's keys and samples."""
    times = [track.curve.times[[0, -1]]] if len(track.curve) else []
    if track.captured is not None:
        times.append(np.array([track.captured.start, track.captured.end]))
    return (float(min(each[0] for each in times)), float(max(each[-1] for each in times))) if times else (0.0, 0.0)


def baked_to_samples(track: Track, rate: float, span: Span | None = None) -> Track:
    """A track whose keys and layers have become samples, one for every frame."""
    times = frame_times(*(span or extent(track)), rate)
    captured = Samples(own_values(track, times).astype(np.float32), rate, float(times[0]))
    return replace(track, captured=captured, layers=(), curve=Curve(overshoot=track.curve.overshoot))


def baked_to_keys(track: Track, rate: float, span: Span | None = None, shape: Shape = "linear") -> Track:
    """A track that is a key on every frame and nothing else."""
    times = frame_times(*(span or extent(track)), rate)
    return replace(track, captured=None, layers=(), curve=curve_through(times, own_values(track, times), shape))


def simplified(track: Track, tolerance: float, rate: float = 60.0) -> Track:
    """A track of as few smooth keys as stay within a tolerance of what it was, at every sample or frame of a rate.

    Keys that no fewer smooth ones can stand for stay as they are.
    """
    begin, end = extent(track)
    if track.captured is not None and not len(track.curve):
        times = track.captured.times
    else:
        times = np.union1d(frame_times(begin, end, rate), track.curve.times)
    if not len(times):
        return track
    kept = _needed(times, own_values(track, times), max(tolerance, 0.0))
    if track.captured is None and len(kept) >= len(track.curve):
        return track
    return replace(track, captured=None, layers=(), curve=replace(kept, overshoot=track.curve.overshoot))


def _needed(times: FloatArray, values: FloatArray, tolerance: float) -> Curve:
    """Add the worst sample of every segment until none is off by more than the tolerance."""
    chosen = np.array([0, len(times) - 1]) if len(times) > 1 else np.array([0])
    while True:
        curve = curve_through(times[chosen], values[chosen])
        off = np.abs(values_of(curve, times) - values)
        off[chosen] = 0.0
        worst = [
            begin + 1 + int(np.argmax(off[begin + 1 : end]))
            for begin, end in pairwise(chosen.tolist())
            if end - begin > 1 and off[begin + 1 : end].max() > tolerance
        ]
        if not worst:
            return curve
        chosen = np.union1d(chosen, worst)


def smoothed(track: Track, seconds: float) -> Track:
    """A track smoothed by a Gaussian with a standard deviation of so many seconds: samples, and values of keys.

    Layers keep their keys, which are then met as before.
    """
    if seconds <= 0:
        return track
    captured = track.captured
    if captured is not None:
        values = gaussian_filter1d(captured.values.astype(np.float64), seconds * captured.rate, mode="nearest")
        captured = replace(captured, values=values.astype(np.float32))
    return replace(track, captured=captured, curve=_smoothed_keys(track.curve, seconds))


def _smoothed_keys(curve: Curve, seconds: float) -> Curve:
    if len(curve) < 2:
        return curve
    offsets = np.arange(-4 * SMOOTH_STEPS, 4 * SMOOTH_STEPS + 1) * (seconds / SMOOTH_STEPS)
    weights = np.exp(-0.5 * (offsets / seconds) ** 2)
    around = values_of(curve, (curve.times[:, None] + offsets).ravel()).reshape(len(curve), -1)
    return with_values(curve, np.arange(len(curve)), around @ (weights / weights.sum()))


Warp = Callable[[FloatArray], FloatArray]
"""Times (T,) before to times (T,) after, increasing."""


def warp_through(before: Sequence[float], after: Sequence[float]) -> Warp:
    """The course of time that takes some moments to others, straight between them, in step before and behind.

    Parameters
    ----------
    before, after : the same number of moments, each increasing by more than `SAME_TIME`
    """
    old, new = np.array(before, dtype=np.float64), np.array(after, dtype=np.float64)

    def warp(times: FloatArray) -> FloatArray:
        if not len(old):
            return times
        inside = np.interp(times, old, new)
        return np.where(
            times < old[0], times + new[0] - old[0], np.where(times > old[-1], times + new[-1] - old[-1], inside)
        )

    return warp


def warped(track: Track, before: Sequence[float], after: Sequence[float]) -> Track:
    """A track in another course of time: keys go along, and what was captured is sampled anew at its own rate."""
    warp, back = warp_through(before, after), warp_through(after, before)
    captured = track.captured
    if captured is not None and len(captured.values):
        begin, end = warp(np.array([captured.start, captured.end])).tolist()
        times = frame_times(begin, end, captured.rate)
        captured = Samples(captured.at(back(times)).astype(np.float32), captured.rate, begin)
    layers = tuple(replace(layer, keys=_keys_warped(layer.keys, warp)) for layer in track.layers)
    return replace(track, captured=captured, layers=layers, curve=_keys_warped(track.curve, warp))


def _keys_warped(curve: Curve, warp: Warp) -> Curve:
    if not len(curve):
        return curve
    times = warp(curve.times)
    longer = np.diff(times) / np.diff(curve.times)
    handles = curve.handles.copy()
    handles[1:, 0] *= longer
    handles[:-1, 2] *= longer
    return replace(curve, times=times, handles=handles)


def offset(track: Track, seconds: float = 0.0, rise: float = 0.0) -> Track:
    """A track later by seconds and higher by an amount; a captured curve is lifted by its samples."""
    captured = track.captured
    if captured is not None:
        values = (captured.values + np.float32(rise)).astype(np.float32) if rise else captured.values
        captured = replace(captured, start=captured.start + seconds, values=values)
    lifted = captured is None
    layers = tuple(replace(layer, keys=_keys_offset(layer.keys, seconds, rise)) for layer in track.layers)
    return replace(
        track, captured=captured, layers=layers, curve=_keys_offset(track.curve, seconds, rise if lifted else 0.0)
    )


def _keys_offset(curve: Curve, seconds: float, rise: float) -> Curve:
    return replace(curve, times=curve.times + seconds, values=curve.values + rise) if len(curve) else curve


def looped(track: Track, span: Span, times: int) -> Track:
    """A track that does what it does in a span so many times, one after the other; what was behind comes after.

    The seam is closed by `closed`, where that is wanted, before.
    """
    begin, end = span
    length = end - begin
    if times < 2 or length <= SAME_TIME:
        return track
    captured = track.captured
    if captured is not None and len(captured.values):
        first, last = (round((at - captured.start) * captured.rate) for at in span)
        first, last = max(first, 0), min(max(last, 0), len(captured.values))
        parts = (captured.values[:last], *([captured.values[first:last]] * (times - 1)), captured.values[last:])
        captured = replace(captured, values=np.concatenate(parts))
    looped_track = replace(track, captured=captured)
    for row in range(len(track.layers) + 1):
        curve = track.curve if row == 0 else track.layers[row - 1].keys
        looped_track = with_row(looped_track, row, _keys_looped(curve, span, times))
    return looped_track


def _keys_looped(curve: Curve, span: Span, times: int) -> Curve:
    begin, end = span
    length = end - begin
    inside = [key for key in curve.keys if begin - SAME_TIME <= key.time <= end + SAME_TIME]
    keys = [key for key in curve.keys if key.time <= end + SAME_TIME]
    for turn in range(1, times):
        keys += [replace(key, time=key.time + turn * length) for key in inside]
    behind = (times - 1) * length
    keys += [replace(key, time=key.time + behind) for key in curve.keys if key.time > end + SAME_TIME]
    return curve_of(keys, curve.overshoot)


def closed(track: Track, span: Span, blend: float) -> Track:
    """A track that comes back at the end of a span to what it is at its start, drawn there over the last seconds."""
    begin, end = span
    over = min(max(blend, SAME_TIME), end - begin)
    first, last = own_values(track, np.array([begin, end])).tolist()
    gap = first - last

    def drawn(times: FloatArray) -> FloatArray:
        share = np.clip((times - end + over) / over, 0.0, 1.0)
        return np.where(times <= end + SAME_TIME, gap * share**2 * (3.0 - 2.0 * share), 0.0)

    if track.captured is None:
        curve = track.curve
        return replace(track, curve=with_values(curve, np.arange(len(curve)), curve.values + drawn(curve.times)))
    values = (track.captured.values + drawn(track.captured.times)).astype(np.float32)
    return replace(track, captured=replace(track.captured, values=values))


def each_track(animation: Animation, channels: Sequence[str], change: Callable[[Track], Track]) -> Animation:
    """An animation with some tracks changed; locked ones stay."""
    wanted = set(channels)
    return replace(
        animation,
        tracks=tuple(
            change(track) if track.channel in wanted and not track.locked else track for track in animation.tracks
        ),
    )

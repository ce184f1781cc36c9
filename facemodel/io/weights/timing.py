"""Frames at the times that a tracker noted, brought to even steps without touching a number that is there."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from facemodel.io.damage import DamageError
from fem.types import Float32Array, FloatArray

FASTEST_CAMERA = 250.0
"""Frames per second; no tracker of faces runs faster, so stamps closer than that are no seconds."""

SLOWEST_CAMERA = 1.0
USUAL = 30.0
"""Frames per second where nothing says how many there are."""

SHORTEST = 1e-6
"""Seconds between two stamps that are not the same."""

COMMON = (12, 15, 23.976, 24, 25, 29.97, 30, 48, 50, 59.94, 60, 90, 100, 119.88, 120, 240)
"""Frames per second of cameras."""

NEAR = 0.004
"""Share within which stamps mean a common rate."""

SLOT = 0.4
"""Of a frame: how far a stamp may be from its even place and still be that frame."""

LARGEST = float(np.finfo(np.float32).max)
"""What a capture can hold; a table may say more."""


@dataclass(frozen=True, eq=False)
class Even:
    """Frames at even steps.

    Attributes
    ----------
    values : (N, C)
    rate : frames per second
    start : time of the first, seconds
    notes : one sentence each for what was bridged or taken for granted
    """

    values: FloatArray
    rate: float
    start: float
    notes: tuple[str, ...]


def kept(values: FloatArray) -> Float32Array:
    """Numbers as captures have them: 0 where none is known, and none too large to be told from infinity."""
    return np.clip(np.nan_to_num(values), -LARGEST, LARGEST).astype(np.float32)


def even(times: FloatArray | None, values: FloatArray, lines: Sequence[int], rate: float | None) -> Even:
    """Frames at even steps; numbers that are missing are bridged.

    Parameters
    ----------
    times : (N,) seconds noted with the frames; none if there are none
    values : (N, C), not a number where one is missing
    lines : (N,) where they stand in the file
    rate : frames per second, if somebody says so; noted times are then not looked at

    Raises
    ------
    DamageError
        If the noted times go back.
    """
    notes: list[str] = []
    if times is None or rate is not None or len(times) < 2:
        own = USUAL if rate is None else rate
        if times is None and rate is None:
            notes.append(f"No times are noted in it; its frames are taken as {own:g} a second.")
        filled = _bridged(values, notes)
        return Even(filled, own, 0.0, tuple(notes))
    stamps = _going_on(times, lines)
    found = _refined(stamps, 1.0 / float(max(np.median(np.diff(stamps)), SHORTEST)))
    if not SLOWEST_CAMERA <= found <= FASTEST_CAMERA:
        notes.append(
            f"By its times it would have {found:.4g} frames a second, which no camera takes; "
            f"they are counted as {USUAL:g} a second."
        )
        return Even(_bridged(values, notes), USUAL, 0.0, tuple(notes))
    own = _common(found, stamps)
    return _placed(stamps, values, own, notes)


def _going_on(times: FloatArray, lines: Sequence[int]) -> FloatArray:
    """The times with missing ones bridged; each has to come after the one before."""
    known = np.isfinite(times)
    if known.sum() < 2:
        return np.arange(len(times)) / USUAL
    back = np.flatnonzero(np.diff(times[known]) < 0)
    if len(back):
        at = np.flatnonzero(known)[int(back[0]) + 1]
        before = times[known][int(back[0])]
        raise DamageError(
            f"line {lines[at]}",
            f"goes back in time, from {before:.3f} s to {times[at]:.3f} s",
            "correct its times, or say how many frames a second it has so that they are only counted",
        )
    places = np.arange(len(times))
    return np.asarray(np.interp(places, places[known], times[known]))


def _refined(stamps: FloatArray, rate: float) -> float:
    """A rate fitted to all stamps: to a few at first, then to twice as many each time, so that none is miscounted."""
    since = stamps - stamps[0]
    count = 8
    while count < 2 * len(since):
        some = since[:count]
        frames = np.rint(some * rate)
        if frames @ some <= 0:
            return rate
        rate = float(frames @ frames / (frames @ some))
        count *= 2
    return rate


def _common(found: float, stamps: FloatArray) -> float:
    """A common rate that the stamps mean, else what they say on average."""
    span = float(stamps[-1] - stamps[0])

    def misfit(rate: float) -> tuple[float, bool, float]:
        """How far the last stamp is from a frame of the rate, in tenths; whole rates are likelier than others."""
        return round(abs(span * rate - round(span * rate)), 1), rate != round(rate), abs(rate - found)

    fitting = [rate for rate in COMMON if abs(rate - found) <= NEAR * rate]
    if not fitting:
        # Where stamps are too uneven to show their step, as many frames as there are fill their span.
        fitting = [rate for rate in COMMON if abs(span * rate - (len(stamps) - 1)) < SLOT]
    return float(min(fitting, key=misfit)) if fitting else round(found, 3)


def _placed(stamps: FloatArray, values: FloatArray, rate: float, notes: list[str]) -> Even:
    """Every frame at the even place nearest to its time if there is one for each, else between them."""
    start = float(stamps[0])
    slots = np.rint((stamps - start) * rate).astype(np.int64)
    count = int(slots[-1]) + 1
    if np.all(np.diff(slots) > 0):
        grid = np.full((count, values.shape[1]), np.nan)
        grid[slots] = values
        if count > len(slots):
            notes.append(f"{count - len(slots)} of {count} frames are missing and were bridged.")
        given = values[np.isnan(values).any(axis=1)] if len(values) else values
        filled = _bridged(grid, notes if len(given) else [])
        return Even(filled, rate, start, tuple(notes))
    times = start + np.arange(count) / rate
    filled = _bridged(values, notes)
    columns = [np.interp(times, stamps, column) for column in filled.T]
    notes.append(f"Its times are uneven; it was sampled anew at {rate:g} frames a second.")
    return Even(np.stack(columns, axis=1) if columns else np.zeros((count, 0)), rate, start, tuple(notes))


def _bridged(values: FloatArray, notes: list[str]) -> FloatArray:
    """Values with those that are missing put between their neighbours; of a column without any number, none."""
    missing = np.isnan(values)
    if not missing.any():
        return values
    filled = values.copy()
    places = np.arange(len(values))
    for column in np.flatnonzero(missing.any(axis=0) & ~missing.all(axis=0)).tolist():
        known = ~missing[:, column]
        filled[:, column] = np.interp(places, places[known], values[known, column])
    gaps = int((missing & ~missing.all(axis=0)).any(axis=1).sum())
    if gaps:
        notes.append(f"In {gaps} of {len(values)} frames numbers are missing and were bridged.")
    return filled

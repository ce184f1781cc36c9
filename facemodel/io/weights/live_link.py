"""Live Link Face's CSV: 61 channels of ARKit at the times of a timecode."""

from __future__ import annotations

import re
from collections.abc import Sequence

import numpy as np

from facemodel.animation.capture import Capture
from facemodel.io.damage import DamageError
from facemodel.io.weights.names import ARKIT, live_link_name
from facemodel.io.weights.table import CORRECT, Table, read_table
from facemodel.io.weights.timing import even, kept
from fem.types import FloatArray

TIMECODE = re.compile(r"(\d{1,3}):(\d{1,2}):(\d{1,2})[:;](\d{1,3})(\.\d+)?")

TIMES = {"time": 1.0, "timestamp": 1.0, "seconds": 1.0, "timestamp_ms": 1e-3, "time_ms": 1e-3}
"""Headings of times, and how many seconds are one of what they count."""

FEWEST = 2
"""Channels of ARKit from which on a table is taken for one."""

BASES = (24, 25, 30, 48, 50, 60, 120)
"""Frames that a second of timecode may have."""


def is_arkit(names: tuple[str, ...]) -> bool:
    """Whether a heading names blend shapes of ARKit."""
    return sum(live_link_name(name) in ARKIT for name in names) >= FEWEST


def read_live_link(data: bytes, rate: float | None = None) -> Capture:
    """A capture from the bytes of a table of ARKit's channels, with a timecode or with times, or with neither.

    Raises
    ------
    DamageError
        If it is no such table, a timecode is none, or it goes back in time.
    """
    table = read_table(
        data, lambda name: live_link_name(name) is not None or name.casefold() in TIMES, texts=("timecode",)
    )
    channels = [name for name in table.names if live_link_name(name) is not None]
    if not channels:
        raise DamageError("line 1", "names no channel of ARKit such as JawOpen", "choose another file")
    spelled = [str(live_link_name(name)) for name in channels]
    values = np.stack([_column(table.column(name)) for name in channels], axis=1)
    codes = table.texts.get("timecode")
    stamps = _seconds(codes, table.lines) if codes and rate is None else _times(table)
    found = even(stamps, values, table.lines, rate)
    missing = sorted(set(ARKIT) - set(spelled))
    notes = list(table.notes)
    if missing:
        notes.append(
            f"{len(missing)} of ARKit’s 52 channels are not in it: {', '.join(missing[:5])}{'…' * (len(missing) > 5)}"
        )
    kind = "live-link" if codes else "arkit"
    return Capture(kind, tuple(spelled), kept(found.values), found.rate, 0.0, (*notes, *found.notes))  # type: ignore[arg-type]


def _column(column: FloatArray | None) -> FloatArray:
    assert column is not None
    return column


def _times(table: Table) -> FloatArray | None:
    """Seconds noted in a column, if one has them."""
    for name, seconds in TIMES.items():
        column = table.column(name)
        if column is not None:
            return column * seconds
    return None


def _seconds(codes: Sequence[str], lines: Sequence[int]) -> FloatArray:
    """Seconds of timecodes ``hours:minutes:seconds:frames.part``; midnight may pass."""
    parts = [TIMECODE.fullmatch(code) for code in codes]
    for line, code, part in zip(lines, codes, parts, strict=True):
        if part is None:
            raise DamageError(f"line {line}", f"says “{code[:30]}”, which is no timecode", CORRECT)
    numbers = np.array([[float(part[k] or 0) for k in range(1, 6)] for part in parts if part is not None])
    hours, minutes, seconds, frames, share = numbers.T
    base = next((each for each in BASES if each > frames.max()), float(frames.max()) + 1)
    clock = (hours * 60 + minutes) * 60 + seconds + (frames + share) / base
    over = np.flatnonzero(np.diff(clock) < -12 * 3600)
    for place in over.tolist():
        clock[place + 1 :] += 24 * 3600
    return np.asarray(clock - clock[0])

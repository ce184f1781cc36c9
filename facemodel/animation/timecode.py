"""Time as people write it: frames, seconds or timecode."""

from __future__ import annotations

import math
import re
from typing import Literal

TimeStyle = Literal["frames", "seconds", "timecode"]

DROPPING = {29.97: 2, 59.94: 4}
"""Rates of colour television, and how many numbers of frames each minute but every tenth leaves out, so that timecode
stays with the clock (SMPTE 12M)."""

NEAR_RATE = 0.01
"""Frames per second; 30000/1001 and 29.97 mean the same."""

ON_FRAME = 1e-6
"""Of a frame: a time that was computed from a frame's number is on that frame."""


def frame_of(time: float, rate: float) -> int:
    """The frame that is shown at a time, counted from time 0."""
    return math.floor(time * rate + ON_FRAME)


def nearest_frame(time: float, rate: float) -> int:
    """The frame nearest to a time."""
    return math.floor(time * rate + 0.5)


def time_of(frame: float, rate: float) -> float:
    """When a frame begins, seconds."""
    return frame / rate


def snapped(time: float, rate: float) -> float:
    """The time of the nearest frame."""
    return nearest_frame(time, rate) / rate


def written(time: float, rate: float, style: TimeStyle) -> str:
    """A time as text: ``42``, ``1.400 s`` or ``00:00:01:12``; with a semicolon where numbers of frames are dropped."""
    if style == "frames":
        return str(nearest_frame(time, rate))
    if style == "seconds":
        return f"{time:.3f} s"
    frame = nearest_frame(abs(time), rate)
    base, dropped = round(rate), _dropped(rate)
    if dropped:
        tens, rest = divmod(frame, 600 * base - 9 * dropped)
        frame += 9 * dropped * tens
        if rest >= base * 60:
            frame += dropped * (1 + (rest - base * 60) // (base * 60 - dropped))
    seconds, frames = divmod(frame, base)
    sign = "-" if time < 0 and frame else ""
    mark = ";" if dropped else ":"
    return f"{sign}{seconds // 3600:02}:{seconds // 60 % 60:02}:{seconds % 60:02}{mark}{frames:02}"


def read_time(text: str, rate: float, style: TimeStyle = "frames") -> float | None:
    """The time that is meant by ``42``, ``42f``, ``1.4s`` or ``00:01:12``; none if it is no time.

    Parameters
    ----------
    rate : frames per second
    style : what a plain number counts; of timecode, frames
    """
    given = text.strip().lower().replace(",", ".")
    if ":" in given or ";" in given:
        return _timecode(given, rate)
    found = re.fullmatch(r"([-+]?(?:\d+\.?\d*|\.\d+))\s*(f|frames?|s|sec|seconds?)?", given)
    if found is None:
        return None
    number, unit = float(found[1]), found[2] or ("s" if style == "seconds" else "f")
    return number if unit.startswith("s") else number / rate


def _timecode(text: str, rate: float) -> float | None:
    sign = -1 if text.startswith("-") else 1
    parts = re.split(r"[:;]", text.lstrip("+-"))
    if not 2 <= len(parts) <= 4 or not all(part.isdigit() and len(part) <= 6 for part in parts):
        return None
    hours, minutes, seconds, frames = ([0, 0, 0, 0] + [int(part) for part in parts])[-4:]
    base, dropped = round(rate), _dropped(rate)
    if frames >= base:
        return None
    frame = ((hours * 60 + minutes) * 60 + seconds) * base + frames
    whole = hours * 60 + minutes
    return sign * (frame - dropped * (whole - whole // 10)) / rate


def _dropped(rate: float) -> int:
    return next((count for known, count in DROPPING.items() if abs(known - rate) < NEAR_RATE), 0)

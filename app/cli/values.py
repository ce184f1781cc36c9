"""Values of options as argparse reads them."""

from __future__ import annotations

import math
import re
from argparse import ArgumentTypeError

SMALLEST_SIDE = 16
LARGEST_SIDE = 8192
"""Pixels; beyond this graphics drivers refuse."""

SLOWEST_RATE, FASTEST_RATE = 1.0, 1000.0
"""Frames per second of anything that is read or written."""

OVERLAYS = ("skull", "muscles", "forces", "supports", "wireframe")
"""What can be drawn with the skin, named as in `app.view_state.ViewState`."""


def weight(text: str) -> tuple[str, float]:
    """A name and a number from ``12=0.8``."""
    name, equals, number = text.rpartition("=")
    if not equals or not name.strip():
        raise ArgumentTypeError(f"“{text}” is not a name and a weight, such as 12=0.8")
    try:
        return name.strip(), float(number)
    except ValueError:
        raise ArgumentTypeError(f"“{number}” in “{text}” is not a number; write a weight such as 12=0.8") from None


def size(text: str) -> tuple[int, int]:
    """Width and height in pixels from ``1280x960``."""
    found = re.fullmatch(r"(\d{1,6})\s*[x×]\s*(\d{1,6})", text.strip(), re.IGNORECASE | re.ASCII)
    if found is None:
        raise ArgumentTypeError(f"“{text}” is not a width and a height in pixels, such as 1280x960")
    width, height = int(found[1]), int(found[2])
    if not all(SMALLEST_SIDE <= side <= LARGEST_SIDE for side in (width, height)):
        raise ArgumentTypeError(
            f"“{text}” is not possible; choose {SMALLEST_SIDE} to {LARGEST_SIDE} pixels for each side"
        )
    return width, height


def rate(text: str) -> float:
    """Frames per second."""
    try:
        found = float(text)
    except ValueError:
        raise ArgumentTypeError(f"“{text}” is not a number of frames per second") from None
    if not SLOWEST_RATE <= found <= FASTEST_RATE:
        raise ArgumentTypeError(f"{text} frames a second are not possible; choose {SLOWEST_RATE:g} to {FASTEST_RATE:g}")
    return found


def seconds(text: str) -> float:
    """A time from the beginning on."""
    try:
        found = float(text)
    except ValueError:
        raise ArgumentTypeError(f"“{text}” is not a number of seconds") from None
    if not 0.0 <= found < math.inf:
        raise ArgumentTypeError(f"{text} seconds are no time after the beginning")
    return found


def overlays(text: str) -> frozenset[str]:
    """Overlays from ``skull,muscles``."""
    names = frozenset(name.strip().lower() for name in text.split(",") if name.strip())
    for name in sorted(names):
        if name not in OVERLAYS:
            raise ArgumentTypeError(f"there is nothing called “{name}” to show; choose from {', '.join(OVERLAYS)}")
    return names


def count(text: str) -> int:
    """A whole number above nothing."""
    if not re.fullmatch(r"0*[1-9]\d{0,8}", text.strip(), re.ASCII):
        raise ArgumentTypeError(f"“{text}” is not a whole number above 0")
    return int(text)

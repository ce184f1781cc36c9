"""What a solve gives, and how it is watched and stopped."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass

from facemodel.basis import Basis
from facemodel.chart import ChartFigures

Progress = Callable[[str, float], None]
"""Told what is being done and the share of the whole that is done (0..1); may raise `Cancelled`."""


class Cancelled(Exception):  # noqa: N818 - it is a request, not an error
    """Raised by a progress callback to stop a solve; what was solved before stays as it was."""


@dataclass(frozen=True, eq=False)
class Solution:
    """A solved project.

    Attributes
    ----------
    basis : every displacement field
    chart : figures of the chart of the solved face
    unknowns : size of the linear system
    seconds : time of each step
    """

    basis: Basis
    chart: ChartFigures
    unknowns: int
    seconds: Mapping[str, float]


class Clock:
    """Seconds between laps."""

    def __init__(self) -> None:
        self.laps: dict[str, float] = {}
        self._last = time.perf_counter()

    def lap(self, name: str) -> None:
        """Note the seconds since the last lap under a name."""
        now = time.perf_counter()
        self.laps[name] = now - self._last
        self._last = now


def silent(_text: str, _share: float) -> None:
    """Progress that nobody watches."""

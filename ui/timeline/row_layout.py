"""How high the lines of the timeline are, and where they lie.  Pure."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass

from app.timeline.lines import Kind, Line
from ui.theme.metrics import GRID

HEIGHTS: Mapping[Kind, int] = {
    "expressions": 3 * GRID,
    "audio": 5 * GRID,
    "speech": 5 * GRID,
    "life": 3 * GRID,
    "events": 4 * GRID,
    "event": 6 * GRID,
    "group": 3 * GRID,
    "track": 3 * GRID,
    "layer": 3 * GRID,
}
"""Pixels."""

LOWEST, HIGHEST = 2 * GRID + 4, 14 * GRID
"""Pixels of a track and its layers, as a person wants them."""

WITH_PORTRAITS = 8 * GRID
"""Pixels of the line of key expressions once there are some."""


@dataclass(frozen=True)
class Placed:
    """A line in its place: from ``top`` down for ``height`` pixels of the whole list."""

    line: Line
    top: int
    height: int

    @property
    def bottom(self) -> int:
        """Where the next one begins."""
        return self.top + self.height


class RowLayout:
    """Lines one below the other.

    Parameters
    ----------
    lines : from top to bottom
    track : pixels of tracks and layers
    portraits : whether there are key expressions
    """

    def __init__(self, lines: Sequence[Line], track: int = HEIGHTS["track"], portraits: bool = False) -> None:
        self.rows: list[Placed] = []
        top = 0
        for line in lines:
            height = HEIGHTS[line.kind]
            if line.kind in ("track", "layer"):
                height = track
            elif line.kind == "expressions" and portraits:
                height = WITH_PORTRAITS
            self.rows.append(Placed(line, top, height))
            top += height
        self._tops = [placed.top for placed in self.rows]
        self.height = top

    def at(self, y: float) -> Placed | None:
        """The line at a height of the whole list."""
        if not 0 <= y < self.height:
            return None
        return self.rows[bisect_right(self._tops, y) - 1]

    def between(self, top: float, bottom: float) -> Iterator[Placed]:
        """Lines that reach into a stretch of the list."""
        begin = max(bisect_right(self._tops, top) - 1, 0)
        for placed in self.rows[begin:]:
            if placed.top >= bottom:
                return
            if placed.bottom > top:
                yield placed

    def of(self, key: str) -> Placed | None:
        """A line by its key."""
        return next((placed for placed in self.rows if placed.line.key == key), None)

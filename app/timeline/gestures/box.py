"""Choosing by drawing a box around things."""

from __future__ import annotations

from collections.abc import Callable

from app.timeline.chosen import NOTHING, Chosen
from app.timeline.gestures.gesture import Spot
from app.timeline.timeline import Timeline

Box = tuple[float, float, float, float]
"""Left, top, right and bottom, pixels."""


class ChooseInBox:
    """Chooses what lies in a box while it is drawn: instead of what was chosen, Shift as well, Ctrl no longer.

    Parameters
    ----------
    spot : its first corner
    inside : what lies in a box
    show : draws the box; none when it is over
    """

    advice = "Shift adds to what is chosen · Ctrl takes out of it · Esc leaves it as it was"

    def __init__(
        self, timeline: Timeline, spot: Spot, inside: Callable[[Box], Chosen], show: Callable[[Box | None], None]
    ) -> None:
        self._timeline = timeline
        self._before = timeline.chosen
        self._from = spot
        self._inside, self._show = inside, show

    def move(self, spot: Spot) -> None:
        """Choose what lies inside."""
        (left, right), (top, bottom) = sorted((self._from.x, spot.x)), sorted((self._from.y, spot.y))
        box = left, top, right, bottom
        self._show(box)
        found = self._inside(box)
        if spot.control:
            self._timeline.choose(self._before.without(found))
        else:
            self._timeline.choose((self._before if spot.shift else NOTHING).joined(found))

    def release(self, spot: Spot) -> None:
        """It stays chosen."""
        self.move(spot)
        self._show(None)

    def cancel(self) -> None:
        """What was chosen is chosen."""
        self._timeline.choose(self._before)
        self._show(None)

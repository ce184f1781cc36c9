"""One picture per frame: many requests to draw become one."""

from __future__ import annotations

from collections.abc import Callable

Schedule = Callable[[Callable[[], None]], None]
"""Calls a function once, at the next frame; in the window that is a single-shot timer."""


class RenderThrottle:
    """Draws at most once per frame, however often it is asked.

    Parameters
    ----------
    draw : draws the picture
    schedule : how to wait for the next frame
    """

    def __init__(self, draw: Callable[[], None], schedule: Schedule) -> None:
        self._draw = draw
        self._schedule = schedule
        self._waiting = False

    def ask(self) -> None:
        """Have a picture at the next frame."""
        if not self._waiting:
            self._waiting = True
            self._schedule(self._frame)

    def _frame(self) -> None:
        self._waiting = False
        self._draw()

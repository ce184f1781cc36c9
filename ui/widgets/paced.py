"""What need not be seen in every frame: of many values the newest is shown, a few times a second."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from PySide6.QtCore import QObject, QTimer

PACE = 125
"""Milliseconds between two readings of a number that a person can follow while a face moves beside it."""


class Paced(QObject):
    """Hands values on: the first at once, and of those that come soon after it the newest.

    Parameters
    ----------
    show : shows a value
    parent : ends with it
    """

    def __init__(self, show: Callable[[Any], None], parent: QObject) -> None:
        super().__init__(parent)
        self._show = show
        self._waiting: tuple[Any, ...] = ()
        self._timer = QTimer(self, singleShot=True, interval=PACE)
        self._timer.timeout.connect(self._hand_on)

    def offer(self, value: Any) -> None:
        """Show it now or soon."""
        self._waiting = (value,)
        if not self._timer.isActive():
            self._hand_on()

    def hurry(self, value: Any) -> None:
        """Show it now, and nothing of what came before any more."""
        self._timer.stop()
        self._waiting = ()
        self._show(value)

    def _hand_on(self) -> None:
        waiting, self._waiting = self._waiting, ()
        if waiting:
            self._show(*waiting)
            self._timer.start()

"""What need not be seen in every frame: of many values the newest is shown, a few times a second."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

from PySide6.QtCore import QObject, QTimer

PACE = 125
"""Milliseconds between two readings of a number that a person can follow while a face moves beside it."""


class Paced(QObject):
    """Hands values on: each at once, or while it is slow the newest of those that came.

    Parameters
    ----------
    show : shows a value
    parent : ends with it
    """

    def __init__(self, show: Callable[[Any], None], parent: QObject) -> None:
        super().__init__(parent)
        self._show = show
        self._slow = False
        self._waiting: tuple[Any, ...] = ()
        self._timer = QTimer(self, singleShot=True, interval=PACE)
        self._timer.timeout.connect(self._hand_on)

    def offer(self, value: Any) -> None:
        """Show it, now or soon; nothing of what came before is shown any more."""
        self._waiting = (value,)
        if not self._timer.isActive():
            self._hand_on()

    def be_slow(self, slow: bool) -> None:
        """Begin to leave values out, or show the newest and leave out none any more."""
        self._slow = slow
        if not slow:
            self._timer.stop()
            self._hand_on()

    def _hand_on(self) -> None:
        waiting, self._waiting = self._waiting, ()
        if waiting:
            self._show(*waiting)
            if self._slow:
                self._timer.start()

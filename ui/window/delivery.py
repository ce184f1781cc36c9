"""A way into the thread of the window for everyone who works in another."""

from __future__ import annotations

import queue
from collections.abc import Callable

from PySide6.QtCore import QObject, Qt, Signal, Slot

Call = Callable[[], None]


class UiThread(QObject):
    """Runs calls from other threads in the thread it was made in, one after the other, from the event loop.

    The calls wait in a queue of Python's own; the signal between the threads only rings the bell.
    """

    _rung = Signal()

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._calls: queue.SimpleQueue[Call] = queue.SimpleQueue()
        self._rung.connect(self._answer, Qt.ConnectionType.QueuedConnection)

    def deliver(self, call: Call) -> None:
        """Have ``call`` run soon; may be called from any thread."""
        self._calls.put(call)
        self._rung.emit()

    @Slot()
    def _answer(self) -> None:
        """One ring, one call: between two calls the window may paint and listen."""
        self._calls.get_nowait()()

"""A way into the thread of the window for everyone who works in another."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QObject, Qt, Signal, Slot

Call = Callable[[], None]


class UiThread(QObject):
    """Runs calls from other threads in the thread it was made in, one after the other, from the event loop."""

    _asked = Signal(object)

    def __init__(self, parent: QObject | None = None) -> None:
        super().__init__(parent)
        self._asked.connect(self._run, Qt.ConnectionType.QueuedConnection)

    def deliver(self, call: Call) -> None:
        """Have ``call`` run soon; may be called from any thread."""
        self._asked.emit(call)

    @Slot(object)
    def _run(self, call: Call) -> None:
        call()

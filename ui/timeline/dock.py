"""The timeline's dock: its title is the transport, and folding leaves nothing but that."""

from __future__ import annotations

from PySide6.QtCore import Qt, QTimer, Signal
from PySide6.QtWidgets import QHBoxLayout, QWidget

from ui.theme.metrics import GRID
from ui.timeline.panel import TimelinePanel
from ui.timeline.transport import Transport
from ui.window.dock import Dock

USUAL_HEIGHT = 34 * GRID
"""Pixels of the open timeline at its first opening."""


SETTLE = 60
"""Milliseconds after which the window has laid its docks out anew."""

MOST = 16_777_215
"""Qt's own word for “as high as one likes”."""


class TimelineDock(Dock):
    """Can be moved, floated, closed, and folded to one line.

    Signals
    -------
    folded(bool) : a person folded or opened it
    """

    folded = Signal(bool)

    def __init__(self, transport: Transport, panel: TimelinePanel) -> None:
        self.transport, self.panel = transport, panel
        super().__init__("timeline", "Timeline", panel)
        self._height = USUAL_HEIGHT
        self.is_folded = False
        transport.folded.connect(self._turn)
        self.fold(True)

    def fold(self, folded: bool) -> None:
        """Leave the transport alone, or show everything, without telling anyone."""
        if folded == self.is_folded:
            return
        line = self.titleBarWidget().sizeHint().height()
        if folded and self.isVisible():
            self._height = self.height()
        self.is_folded = folded
        self.transport.show_folded(folded)
        # The panel stays where it is without height: hidden, it would leave the dock no wider than its title.
        self.panel.setMaximumHeight(0 if folded else MOST)
        self.setMaximumHeight(line if folded else MOST)
        # A dock takes what it needs at least, and keeps it when it needs less again.
        self.setMinimumHeight(line if folded else self._height)
        QTimer.singleShot(SETTLE, self, lambda: self.setMinimumHeight(line))

    def open(self) -> None:
        """Show everything."""
        self.show()
        self.raise_()
        if self.is_folded:
            self._turn(False)

    def _turn(self, folded: bool) -> None:
        self.fold(folded)
        self.folded.emit(folded)

    def _title(self, title: str) -> QWidget:
        line = QWidget()
        line.setProperty("role", "panel")
        line.setAttribute(Qt.WidgetAttribute.WA_StyledBackground)
        layout = QHBoxLayout(line)
        layout.setContentsMargins(GRID // 2, 0, GRID // 2, 0)
        layout.setSpacing(0)
        layout.addWidget(self.transport, 1)
        for button in self._title_buttons(title):
            layout.addWidget(button)
        return line

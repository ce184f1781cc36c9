"""A landmark in the list of those that are picked on a skull."""

from __future__ import annotations

from PySide6.QtCore import QSize, Qt, Signal
from PySide6.QtGui import QColor, QFocusEvent, QKeyEvent, QMouseEvent, QPainter, QPaintEvent
from PySide6.QtWidgets import QHBoxLayout, QLabel, QToolButton, QWidget

from ui.theme.apply import current_theme
from ui.theme.colour import blend
from ui.theme.icons import icon
from ui.theme.metrics import GRID, ICON, RADIUS
from ui.widgets.glyph import Glyph

HEIGHT = 24
"""Pixels."""

POOR = 4.0
"""Millimetres missed from which a pick is worth another look."""

OPEN, ASKED, PICKED = ("circle-outline", "muted"), ("circle-double", "accent"), ("check-circle", "ok")
"""Glyphs and their colour."""


class LandmarkRow(QWidget):
    """Says whether it is picked and by how much it is missed; a click asks for it.

    Signals
    -------
    chosen(str) : it is to be picked next
    forgotten(str) : its pick is taken back
    """

    chosen = Signal(str)
    forgotten = Signal(str)

    def __init__(self, name: str, title: str, hint: str) -> None:
        super().__init__()
        self._name = name
        self._asked = False
        self.setFixedHeight(HEIGHT)
        self.setToolTip(f"{title}: {hint}")
        self.setAccessibleName(title)
        self.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self.setAttribute(Qt.WidgetAttribute.WA_Hover)
        self.glyph = Glyph(*OPEN)
        self.title, self.missed = QLabel(title), QLabel()
        self.drop = QToolButton()
        self.drop.setProperty("role", "small")
        self.drop.setIcon(icon("close", quiet=True))
        self.drop.setIconSize(QSize(ICON - 2, ICON - 2))
        self.drop.setToolTip("Take this pick back (Backspace)")
        self.drop.setFocusPolicy(Qt.FocusPolicy.NoFocus)
        self.drop.clicked.connect(lambda: self.forgotten.emit(self._name))
        layout = QHBoxLayout(self)
        layout.setContentsMargins(GRID // 2, 0, GRID // 2, 0)
        layout.setSpacing(GRID)
        layout.addWidget(self.glyph)
        layout.addWidget(self.title, 1)
        layout.addWidget(self.missed)
        layout.addWidget(self.drop)

    def show_state(self, picked: bool, asked: bool, missed: float | None) -> None:
        """Show whether it is picked, whether it is asked for, and by how many millimetres it is missed."""
        self._asked = asked
        self.glyph.become(*(PICKED if picked else ASKED if asked else OPEN))
        self.missed.setText("" if missed is None else f"{missed:.1f} mm")
        self.missed.setProperty("role", "error" if missed is not None and missed >= POOR else "muted")
        self.missed.style().polish(self.missed)
        self.drop.setVisible(picked)
        self.update()

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Ask for it."""
        if event.button() == Qt.MouseButton.LeftButton:
            self.chosen.emit(self._name)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Enter asks for it, Backspace takes its pick back."""
        if event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_Space):
            self.chosen.emit(self._name)
        elif event.key() in (Qt.Key.Key_Backspace, Qt.Key.Key_Delete):
            self.forgotten.emit(self._name)
        else:
            event.ignore()

    def focusInEvent(self, event: QFocusEvent) -> None:
        """Show the focus."""
        super().focusInEvent(event)
        self.update()

    def paintEvent(self, _event: QPaintEvent) -> None:
        """A ground under what is asked for, or under the pointer."""
        theme, painter = current_theme(), QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(QColor(theme.accent) if self.hasFocus() else Qt.PenStyle.NoPen)
        if self._asked:
            painter.setBrush(blend(theme.panel, theme.accent, 0.22))
        elif self.underMouse():
            painter.setBrush(QColor(theme.hover))
        else:
            painter.setBrush(Qt.BrushStyle.NoBrush)
        painter.drawRoundedRect(self.rect().adjusted(0, 0, -1, -1), RADIUS, RADIUS)

"""How many frames a second the clip has, and while it plays how many are really shown."""

from __future__ import annotations

from PySide6.QtCore import QPoint, QSize, Qt, QTimer
from PySide6.QtGui import QColor, QMouseEvent, QPainter, QPaintEvent
from PySide6.QtWidgets import QMenu, QWidget

from app.timeline.timeline import Timeline
from facemodel.animation.clip import FASTEST, SLOWEST
from facemodel.animation.editing.marks import with_rate
from ui.theme.apply import current_theme, interface_font
from ui.theme.metrics import GRID, RADIUS, ROW, SMALL_TYPE
from ui.widgets.number_edit import NumberEdit

RATES = (12, 15, 23.976, 24, 25, 29.97, 30, 48, 50, 59.94, 60, 90, 100, 120)

REFRESH = 250
"""Milliseconds between two readings of what is really shown; what changes faster cannot be read."""

BEHIND = 0.97
"""Share of the rate below which frames are being left out."""


class RateButton(QWidget):
    """Shows the rate.  A click offers the usual ones, a double click types any other."""

    def __init__(self, timeline: Timeline) -> None:
        super().__init__()
        self._timeline = timeline
        self._shown: float | None = None
        self._editor: NumberEdit | None = None
        self.setFixedSize(QSize(9 * GRID, ROW))
        self.setAttribute(Qt.WidgetAttribute.WA_Hover)
        self.setAccessibleName("Frames per second")
        self.setToolTip("Frames per second of the clip; while it plays, how many are really shown")
        self._timer = QTimer(self, interval=REFRESH)
        self._timer.timeout.connect(self._read)
        timeline.playhead.playing_changed.connect(self._follow)
        timeline.document.animation_changed.connect(lambda _names: self.update())
        timeline.document.project_changed.connect(lambda _project: self.update())

    @property
    def text(self) -> str:
        """What is written."""
        return f"{self._timeline.rate:g} fps" if self._shown is None else f"{self._shown:.1f} fps"

    def set_rate(self, rate: float) -> None:
        """Give the clip another rate, in one step."""
        self._close()
        kept = min(max(rate, SLOWEST), FASTEST)
        self._timeline.edit(with_rate(self._timeline.animation, kept), f"{kept:g} frames per second")

    def edit(self) -> None:
        """Open it for typing."""
        if self._editor is None:
            self._editor = NumberEdit(self, f"{self._timeline.rate:g}")
            self._editor.entered.connect(self.set_rate)
            self._editor.dismissed.connect(self._close)

    def menu(self) -> QMenu:
        """The usual rates."""
        menu = QMenu(self)
        for rate in RATES:
            action = menu.addAction(f"{rate:g} fps")
            action.setCheckable(True)
            action.setChecked(abs(rate - self._timeline.rate) < 1e-3)
            action.triggered.connect(lambda _on, rate=rate: self.set_rate(float(rate)))
        menu.addSeparator()
        menu.addAction("Another rate…").triggered.connect(self.edit)
        return menu

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Offer rates."""
        if event.button() == Qt.MouseButton.LeftButton and self._editor is None:
            menu = self.menu()
            menu.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
            menu.popup(self.mapToGlobal(QPoint(0, self.height())))

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw the rate; in the colour of a warning while frames are left out."""
        theme = current_theme()
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        if self.underMouse():
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(QColor(theme.hover))
            painter.drawRoundedRect(self.rect(), RADIUS, RADIUS)
        painter.setFont(interface_font(SMALL_TYPE + 1))
        late = self._shown is not None and self._shown < BEHIND * self._timeline.rate
        painter.setPen(QColor(theme.warn if late else theme.muted if self._shown is None else theme.text))
        painter.drawText(self.rect(), Qt.AlignmentFlag.AlignCenter, self.text)

    def _follow(self, playing: bool) -> None:
        self._timer.start() if playing else self._timer.stop()
        self._shown = None
        self.update()

    def _read(self) -> None:
        self._shown = self._timeline.playhead.rate
        self.update()

    def _close(self) -> None:
        editor, self._editor = self._editor, None
        if editor is not None:
            editor.go_away()

"""The time of the playhead: read, typed as frames, seconds or timecode, or dragged."""

from __future__ import annotations

from PySide6.QtCore import QPointF, QSize, Qt
from PySide6.QtGui import QColor, QFont, QKeyEvent, QMouseEvent, QPainter, QPaintEvent, QPen
from PySide6.QtWidgets import QSizePolicy, QWidget

from app.errors import NumberError
from app.timeline.timeline import Timeline
from facemodel.animation.timecode import TimeStyle, read_time, written
from ui.theme.apply import current_theme, interface_font
from ui.theme.metrics import GRID, RADIUS, ROW
from ui.widgets.number_edit import NumberEdit
from ui.widgets.weight_gestures import THRESHOLD

STYLES: tuple[TimeStyle, ...] = ("timecode", "frames", "seconds")

WIDTH = 13 * GRID

SWEEP = 4.0
"""Pixels of a drag for one frame."""


def time_from(text: str, timeline: Timeline) -> float:
    """The time that is meant by a text; ``+12`` and ``-12`` count from the playhead.

    Raises
    ------
    NumberError
        If it is no time.
    """
    style, rate = timeline.state.style, timeline.rate
    plain = text.strip()
    seconds = read_time(plain.lstrip("+-") if plain[:1] in "+-" else plain, rate, style)
    if seconds is None:
        raise NumberError(f"“{plain}” is no time; type frames such as 42, seconds such as 1.4s, or 00:01:12.")
    if plain.startswith("+"):
        return timeline.playhead.time + seconds
    return timeline.playhead.time - seconds if plain.startswith("-") else seconds


class TimeField(QWidget):
    """Shows the time of the playhead.  A click types another one, a drag goes through time, a right click changes how
    it is written.
    """

    def __init__(self, timeline: Timeline) -> None:
        super().__init__()
        self._timeline = timeline
        self._pressed: QPointF | None = None
        self._from = 0.0
        self._moved = False
        self._editor: NumberEdit | None = None
        self.setFixedSize(QSize(WIDTH, ROW))
        self.setSizePolicy(QSizePolicy.Policy.Fixed, QSizePolicy.Policy.Fixed)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setAttribute(Qt.WidgetAttribute.WA_Hover)
        self.setCursor(Qt.CursorShape.SizeHorCursor)
        self.setAccessibleName("Time of the playhead")
        self.setToolTip("Time: click to type frames, 1.4s or 00:01:12 · drag to scrub · right-click: how it is written")
        timeline.playhead.moved.connect(lambda _time: self.update())
        timeline.changed.connect(lambda *_states: self.update())
        timeline.document.animation_changed.connect(lambda _names: self.update())

    @property
    def text(self) -> str:
        """What is written."""
        timeline = self._timeline
        return written(timeline.playhead.time, timeline.rate, timeline.state.style)

    def edit(self) -> None:
        """Open it for typing."""
        if self._editor is None:
            self._editor = NumberEdit(self, self.text, lambda text: time_from(text, self._timeline))
            self._editor.setAccessibleName("Time")
            self._editor.entered.connect(self._enter)
            self._editor.dismissed.connect(self._close)

    def take_back(self) -> bool:
        """Go back to where the drag under way began; whether there was one."""
        held, self._pressed = self._pressed is not None, None
        if held:
            self._timeline.playhead.go(self._from)
        return held

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Take hold; the right button changes how times are written."""
        if event.button() == Qt.MouseButton.LeftButton:
            self._pressed, self._from, self._moved = event.position(), self._timeline.playhead.time, False
        elif event.button() == Qt.MouseButton.RightButton:
            now = self._timeline.state.style
            self._timeline.change(style=STYLES[(STYLES.index(now) + 1) % len(STYLES)])

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Time follows the hand, frame by frame."""
        if self._pressed is None:
            return
        gone = event.position().x() - self._pressed.x()
        if self._moved or abs(gone) >= THRESHOLD:
            self._moved = True
            self._timeline.playhead.go(max(self._from + round(gone / SWEEP) / self._timeline.rate, 0.0), snap=True)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """A click opens it for typing."""
        if event.button() == Qt.MouseButton.LeftButton and self._pressed is not None:
            self._pressed = None
            if not self._moved:
                self.edit()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Enter opens it for typing."""
        if event.key() in (Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_F2):
            self.edit()
        else:
            event.ignore()

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw the time."""
        theme = current_theme()
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(QColor(theme.hover if self.underMouse() else theme.raised))
        area = self.rect().toRectF().adjusted(0.5, 0.5, -0.5, -0.5)
        if self.hasFocus():
            painter.setPen(QPen(QColor(theme.accent), 1.0))
        elif theme.name == "light":
            painter.setPen(QPen(QColor(theme.line), 1.0))
        painter.drawRoundedRect(area, RADIUS, RADIUS)
        font = interface_font()
        font.setWeight(QFont.Weight.DemiBold)
        painter.setFont(font)
        painter.setPen(QColor(theme.text))
        painter.drawText(self.rect(), Qt.AlignmentFlag.AlignCenter, self.text)

    def _enter(self, seconds: float) -> None:
        self._close()
        self._timeline.playhead.go(max(seconds, 0.0))

    def _close(self) -> None:
        editor, self._editor = self._editor, None
        if editor is not None:
            editor.go_away()

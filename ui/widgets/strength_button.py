"""A button that is a bar at the same time: a click is full strength, a drag across it is any other."""

from __future__ import annotations

from PySide6.QtCore import QRectF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QFontMetrics, QKeyEvent, QMouseEvent, QPainter, QPainterPath, QPaintEvent, QPen
from PySide6.QtWidgets import QAbstractButton, QSizePolicy, QWidget

from ui.theme.apply import current_theme
from ui.theme.colour import blend
from ui.theme.metrics import GRID, RADIUS, ROW
from ui.theme.roles import Theme
from ui.widgets.bar_paint import EDGE
from ui.widgets.weight_gestures import THRESHOLD


class StrengthButton(QAbstractButton):
    """Shows how strongly something is on, from 0 to 1.

    Signals
    -------
    previewed(float) : the strength under a dragging pointer
    committed() : the drag is over and stays
    cancelled() : the drag is over and is taken back
    pressed_fully(bool) : clicked; true where it was not fully on before
    """

    previewed = Signal(float)
    committed = Signal()
    cancelled = Signal()
    pressed_fully = Signal(bool)

    def __init__(self, title: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setText(title)
        self.setAccessibleName(title)
        self.setCheckable(True)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setAttribute(Qt.WidgetAttribute.WA_Hover)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self._strength = 0.0
        self._pressed_at: float | None = None
        self._dragging = False
        self.clicked.connect(self._click)

    @property
    def strength(self) -> float:
        """How strongly it is on."""
        return self._strength

    def set_strength(self, strength: float) -> None:
        """Show a strength; emits nothing."""
        self._strength = strength
        self.setChecked(strength > 0)
        self.update()

    def nextCheckState(self) -> None:
        """A click alone checks nothing: what is shown follows the face."""

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Take hold."""
        if event.button() == Qt.MouseButton.LeftButton:
            self._pressed_at = event.position().x()
            self._dragging = False
        super().mousePressEvent(event)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Past the threshold the pointer sets the strength."""
        if self._pressed_at is None:
            return
        x = event.position().x()
        if not self._dragging and abs(x - self._pressed_at) < THRESHOLD:
            return
        self._dragging = True
        strength = round(min(max(x / max(1, self.width()), 0.0), 1.0), 2)
        self.set_strength(strength)
        self.previewed.emit(strength)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """A drag is kept, a press without one is a click."""
        dragging, self._dragging, self._pressed_at = self._dragging, False, None
        if dragging:
            self.setDown(False)
            self.committed.emit()
            self.update()
        else:
            super().mouseReleaseEvent(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Esc takes a drag back."""
        if event.key() == Qt.Key.Key_Escape and self._dragging:
            self._dragging, self._pressed_at = False, None
            self.setDown(False)
            self.cancelled.emit()
        else:
            super().keyPressEvent(event)

    def sizeHint(self) -> QSize:
        """The word and a little air."""
        return QSize(QFontMetrics(self.font()).horizontalAdvance(self.text()) + 2 * GRID, ROW)

    def minimumSizeHint(self) -> QSize:
        """The word."""
        return QSize(QFontMetrics(self.font()).horizontalAdvance(self.text()) + GRID, ROW)

    def paintEvent(self, _event: QPaintEvent) -> None:
        """A bar with the word in its middle, or the number while it is dragged."""
        theme = current_theme()
        area = QRectF(self.rect())
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        shape = QPainterPath()
        shape.addRoundedRect(area, RADIUS, RADIUS)
        painter.fillPath(shape, QColor(theme.hover if self.underMouse() or self.isDown() else theme.raised))
        if self._strength > 0:
            self._paint_fill(painter, shape, theme)
        if self.hasFocus() or self._dragging or theme.name == "light":
            strong = self.hasFocus() or self._dragging
            painter.setPen(QPen(QColor(theme.accent if strong else theme.line), 1.0))
            painter.drawRoundedRect(area.adjusted(0.5, 0.5, -0.5, -0.5), RADIUS, RADIUS)
        painter.setPen(QColor(theme.text))
        word = f"{self._strength:.2f}" if self._dragging else self.text()
        painter.drawText(area, Qt.AlignmentFlag.AlignCenter, word)

    def _paint_fill(self, painter: QPainter, shape: QPainterPath, theme: Theme) -> None:
        width = self.width() * min(self._strength, 1.0)
        painter.save()
        painter.setClipPath(shape)
        painter.fillRect(QRectF(0, 0, width, self.height()), blend(theme.raised, theme.accent, 0.34))
        painter.fillRect(QRectF(width - EDGE, 0, EDGE, self.height()), QColor(theme.accent))
        painter.restore()

    def _click(self) -> None:
        self.pressed_fully.emit(self._strength != 1.0)

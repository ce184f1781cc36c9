"""A button with a face on it, its name below, and a fill that says how strongly it is on."""

from __future__ import annotations

from PySide6.QtCore import QRectF, QSize, Qt
from PySide6.QtGui import QColor, QFontMetrics, QImage, QPainter, QPainterPath, QPaintEvent, QPen
from PySide6.QtWidgets import QAbstractButton, QSizePolicy, QWidget

from ui.theme.apply import current_theme, interface_font
from ui.theme.colour import blend
from ui.theme.metrics import GRID, RADIUS, SMALL_TYPE
from ui.theme.roles import Theme
from ui.widgets.bar_paint import EDGE
from ui.widgets.portrait_paint import paint_portrait

FACE, CAPTION = 60, 18
"""Height of the face and of the name below it."""

WIDEST = 7 * GRID
"""Width that a button asks for at most."""

FACE_PART = 0.42
"""Which part of a portrait is kept where it is cut: the eyes stay, rather than the chin."""


class FaceButton(QAbstractButton):
    """Shows a portrait with a title; before the portrait is taken its place is an even ground."""

    def __init__(self, title: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setText(title)
        self.setAccessibleName(title)
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setAttribute(Qt.WidgetAttribute.WA_Hover)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self._picture: QImage | None = None
        self._strength = 0.0

    @property
    def strength(self) -> float:
        """How strongly it is on."""
        return self._strength

    @property
    def picture(self) -> QImage | None:
        """The portrait that is shown."""
        return self._picture

    def set_picture(self, picture: QImage | None) -> None:
        """Show a portrait, or none."""
        self._picture = picture
        self.update()

    def sizeHint(self) -> QSize:
        """A face, and the word with a little air; a long word makes no button wider than others."""
        word = QFontMetrics(interface_font(SMALL_TYPE)).horizontalAdvance(self.text()) + 6
        return QSize(min(word, WIDEST), FACE + CAPTION)

    def minimumSizeHint(self) -> QSize:
        """A face; a long word is shortened."""
        return QSize(6 * GRID, FACE + CAPTION)

    def caption(self) -> str:
        """What stands below the face now."""
        return self.text()

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw face, name, and how strongly it is on."""
        theme = current_theme()
        area = QRectF(self.rect())
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        shape = QPainterPath()
        shape.addRoundedRect(area, RADIUS, RADIUS)
        painter.setClipPath(shape)
        lit = self.underMouse() or self.isDown()
        painter.fillRect(area, QColor(theme.hover if lit else theme.raised))
        face = QPainterPath()
        face.addRect(QRectF(0, 0, area.width(), FACE))
        paint_portrait(painter, face, self._picture, FACE_PART)
        words = QRectF(0, FACE, area.width(), CAPTION)
        if self._strength > 0:
            self._paint_fill(painter, words, theme)
        painter.setFont(interface_font(SMALL_TYPE))
        painter.setPen(QColor(theme.text))
        said = painter.fontMetrics().elidedText(self.caption(), Qt.TextElideMode.ElideRight, int(words.width()) - 4)
        painter.drawText(words, Qt.AlignmentFlag.AlignCenter, said)
        strong = self.hasFocus() or self._strength > 0
        if strong or lit or theme.name == "light":
            painter.setPen(QPen(QColor(theme.accent if strong else theme.muted if lit else theme.line), 1.0))
            painter.setBrush(Qt.BrushStyle.NoBrush)
            painter.drawRoundedRect(area.adjusted(0.5, 0.5, -0.5, -0.5), RADIUS, RADIUS)

    def _paint_fill(self, painter: QPainter, words: QRectF, theme: Theme) -> None:
        width = words.width() * min(self._strength, 1.0)
        painter.fillRect(QRectF(0, words.y(), width, words.height()), blend(theme.raised, theme.accent, 0.34))
        painter.fillRect(QRectF(width - EDGE, words.y(), EDGE, words.height()), QColor(theme.accent))

"""Icons of one family that take the colour of the theme at the moment they are painted."""

from __future__ import annotations

import qtawesome
from PySide6.QtCore import QPoint, QRect, QSize, Qt
from PySide6.QtGui import QColor, QIcon, QIconEngine, QPainter, QPixmap

from ui.theme.apply import current_theme
from ui.theme.colour import blend

FAMILY = "mdi6"

RECEDING = 0.75
"""How much of receding writing a quiet icon has: the least of which it keeps 3 to 1, as WCAG 2.2 asks of controls, on
every ground of both themes."""


class GlyphIcon(QIconEngine):
    """One glyph of the icon font; sharp at every scale, right after every change of theme."""

    def __init__(self, glyph: str, mirrored: bool = False, quiet: bool = False) -> None:
        super().__init__()
        self.glyph = glyph
        self.mirrored = mirrored
        self.quiet = quiet

    def paint(self, painter: QPainter, rect: QRect, mode: QIcon.Mode, state: QIcon.State) -> None:
        """Draw the glyph centred in ``rect``."""
        painter.save()
        if self.mirrored:
            painter.translate(2 * rect.x() + rect.width(), 0)
            painter.scale(-1, 1)
        painter.setPen(_colour(mode, state, self.quiet))
        painter.setFont(qtawesome.font(FAMILY, max(1, rect.height())))
        painter.drawText(rect, Qt.AlignmentFlag.AlignCenter, qtawesome.charmap(f"{FAMILY}.{self.glyph}"))
        painter.restore()

    def pixmap(self, size: QSize, mode: QIcon.Mode, state: QIcon.State) -> QPixmap:
        """The glyph on a transparent ground."""
        pixmap = QPixmap(size)
        pixmap.fill(Qt.GlobalColor.transparent)
        painter = QPainter(pixmap)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        self.paint(painter, QRect(QPoint(0, 0), size), mode, state)
        painter.end()
        return pixmap

    def clone(self) -> GlyphIcon:
        """Another engine for the same glyph."""
        return GlyphIcon(self.glyph, self.mirrored, self.quiet)


def icon(glyph: str, quiet: bool = False) -> QIcon:
    """An icon by its name in Material Design Icons; ``head-outline:mirrored`` turns one to the other side.

    A quiet one recedes until the pointer is on it, as befits what stands in every row.
    """
    name, _, turned = glyph.partition(":")
    return QIcon(GlyphIcon(name, turned == "mirrored", quiet))


def _colour(mode: QIcon.Mode, state: QIcon.State, quiet: bool) -> QColor:
    theme = current_theme()
    if mode == QIcon.Mode.Disabled:
        return blend(theme.panel, theme.muted, 0.5)
    if state == QIcon.State.On:
        return QColor(theme.text)
    if mode in (QIcon.Mode.Active, QIcon.Mode.Selected):
        return QColor(theme.text)
    return blend(theme.panel, theme.muted, RECEDING) if quiet else QColor(theme.muted)

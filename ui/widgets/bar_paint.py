"""How a filled bar that carries its name and its number is drawn."""

from __future__ import annotations

from dataclasses import dataclass

from PySide6.QtCore import QRectF, Qt
from PySide6.QtGui import QColor, QFontMetrics, QPainter, QPainterPath, QPen

from ui.theme.colour import blend
from ui.theme.metrics import GRID, RADIUS
from ui.theme.roles import Theme

FILL_SHARE = {"dark": 0.40, "light": 0.34}
"""How much of the role's colour a fill has: strong enough to see, pale enough to read upon."""

EDGE = 2.0
"""Width of the bright end of a fill."""

LAP = 4.0
"""Height of the second lap, which shows by how much a weight exceeds 1."""


@dataclass(frozen=True)
class Fill:
    """One coloured strip of a bar: how far it reaches (1 fills the bar, 2 laps it) and its colour role."""

    weight: float
    colour: str


@dataclass(frozen=True)
class Bar:
    """Everything that the look of a bar depends on."""

    label: str
    number: str
    fills: tuple[Fill, ...]
    hovered: bool = False
    active: bool = False
    enabled: bool = True

    @property
    def zero(self) -> bool:
        """Whether nothing is filled, so that the bar recedes."""
        return all(fill.weight == 0 for fill in self.fills)


def paint_bar(painter: QPainter, area: QRectF, bar: Bar, theme: Theme) -> None:
    """Draw ``bar`` into ``area``; several fills share its height from top to bottom."""
    painter.setRenderHint(QPainter.RenderHint.Antialiasing)
    shape = QPainterPath()
    shape.addRoundedRect(area, RADIUS, RADIUS)
    painter.fillPath(shape, _ground(bar, theme))
    painter.save()
    painter.setClipPath(shape)
    height = area.height() / max(1, len(bar.fills))
    for row, fill in enumerate(bar.fills):
        strip = QRectF(area.x(), area.y() + row * height, area.width(), height)
        _paint_fill(painter, strip, fill, theme, bar.enabled)
    painter.restore()
    _paint_outline(painter, area, bar, theme)
    _paint_text(painter, area, bar, theme)


def fill_colour(role: str, theme: Theme) -> QColor:
    """The colour of a fill upon which text stays readable."""
    return blend(theme.raised, role, FILL_SHARE[theme.name])


def _ground(bar: Bar, theme: Theme) -> QColor:
    if bar.hovered and bar.enabled:
        return QColor(theme.hover)
    if not bar.zero:
        return QColor(theme.raised)
    return blend(theme.panel, theme.raised, 0.5) if theme.name == "dark" else blend(theme.panel, theme.line, 0.28)


def _paint_fill(painter: QPainter, strip: QRectF, fill: Fill, theme: Theme, enabled: bool) -> None:
    if fill.weight <= 0:
        return
    width = strip.width() * min(fill.weight, 1.0)
    colour = fill_colour(fill.colour, theme) if enabled else QColor(theme.line)
    painter.fillRect(QRectF(strip.x(), strip.y(), width, strip.height()), colour)
    bright = QColor(fill.colour) if enabled else QColor(theme.muted)
    painter.fillRect(QRectF(strip.x() + max(0.0, width - EDGE), strip.y(), EDGE, strip.height()), bright)
    over = fill.weight - 1.0
    if over > 0:
        lap = min(LAP, strip.height() / 2)
        width = strip.width() * min(over, 1.0)
        painter.fillRect(QRectF(strip.x(), strip.bottom() - lap, width, lap), QColor(theme.accent))


def _paint_outline(painter: QPainter, area: QRectF, bar: Bar, theme: Theme) -> None:
    if bar.active:
        colour = QColor(theme.accent)
    elif theme.name == "light" and not bar.zero:
        colour = QColor(theme.line)
    else:
        return
    painter.setPen(QPen(colour, 1.0))
    painter.setBrush(Qt.BrushStyle.NoBrush)
    painter.drawRoundedRect(area.adjusted(0.5, 0.5, -0.5, -0.5), RADIUS, RADIUS)


def _paint_text(painter: QPainter, area: QRectF, bar: Bar, theme: Theme) -> None:
    inner = area.adjusted(GRID, 0, -GRID, 0)
    metrics = QFontMetrics(painter.font())
    recede = (bar.zero and not bar.hovered and not bar.active) or not bar.enabled
    centre = Qt.AlignmentFlag.AlignVCenter
    painter.setPen(QColor(theme.muted if recede else theme.text))
    painter.drawText(inner, centre | Qt.AlignmentFlag.AlignRight, bar.number)
    room = inner.width() - metrics.horizontalAdvance(bar.number) - GRID
    name = metrics.elidedText(bar.label, Qt.TextElideMode.ElideRight, int(room))
    painter.drawText(inner, centre | Qt.AlignmentFlag.AlignLeft, name)

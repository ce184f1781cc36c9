"""A legend over the picture: what the colours mean, with their unit."""

from __future__ import annotations

import math
from collections.abc import Callable
from dataclasses import dataclass
from typing import Protocol

import numpy as np
from PySide6.QtCore import QRectF, QSize, Qt
from PySide6.QtGui import QColor, QFontMetrics, QImage, QPainter, QPaintEvent
from PySide6.QtWidgets import QFrame, QVBoxLayout, QWidget

from fem.types import FloatArray
from ui.theme.apply import current_theme, interface_font
from ui.theme.metrics import GRID, SMALL_TYPE, TYPE

WIDTH = 26 * GRID
BAR = 10
TICKS = 3
STEPS = 256


class Named(Protocol):
    """An entry of a legend of choices."""

    @property
    def title(self) -> str:
        """What it is called."""

    @property
    def colour(self) -> tuple[float, float, float]:
        """Its colour, 0 to 1."""


@dataclass(frozen=True)
class Legend:
    """What colours mean: a range, or some choices.

    Attributes
    ----------
    title, unit : of the quantity
    low, high : ends of the range
    colours : (n, 3) colours 0 to 1 of values (n,)
    bands : the choices; none for a range
    beyond : whether there is more above the range, in its last colour
    """

    title: str
    unit: str
    low: float = 0.0
    high: float = 1.0
    colours: Callable[[FloatArray], FloatArray] | None = None
    bands: tuple[Named, ...] = ()
    beyond: bool = False


class Board(Protocol):
    """A place that cards can be laid over."""

    def lay_over(self, card: QWidget) -> None:
        """Put a card over the picture."""

    def place_cards(self) -> None:
        """Put all cards where they belong."""


class LegendCard(QFrame):
    """Shows one legend at a time, over the lower left corner of the picture."""

    def __init__(self, board: Board) -> None:
        super().__init__()
        self.setProperty("role", "card")
        self.setAttribute(Qt.WidgetAttribute.WA_TransparentForMouseEvents)
        self._board = board
        self._scale = LegendScale()
        layout = QVBoxLayout(self)
        layout.setContentsMargins(GRID + 4, GRID, GRID + 4, GRID)
        layout.addWidget(self._scale)
        board.lay_over(self)
        self.hide()

    @property
    def legend(self) -> Legend | None:
        """What is shown."""
        return self._scale.legend if not self.isHidden() else None

    def show_legend(self, legend: Legend | None) -> None:
        """Show a legend, or none."""
        if legend is not None:
            self._scale.become(legend)
            self.setAccessibleName(f"Legend: {legend.title}")
        self.setVisible(legend is not None)
        self._board.place_cards()


class LegendScale(QWidget):
    """A legend by itself: title, colours and numbers.

    Attributes
    ----------
    legend : what it shows
    """

    def __init__(self) -> None:
        super().__init__()
        self.legend = Legend("", "")

    def become(self, legend: Legend) -> None:
        """Show another legend."""
        self.legend = legend
        self.setFixedSize(self.sizeHint())
        self.update()

    def sizeHint(self) -> QSize:
        """As large as it is drawn."""
        rows = len(self.legend.bands)
        width = max(WIDTH, QFontMetrics(interface_font(TYPE)).horizontalAdvance(self._title) + 2)
        return QSize(width, TYPE + 8 + (rows * (TYPE + 7) if rows else BAR + SMALL_TYPE + 9))

    @property
    def _title(self) -> str:
        return f"{self.legend.title}, {self.legend.unit}" if self.legend.unit else self.legend.title

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw it."""
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        painter.setPen(QColor(current_theme().text))
        painter.setFont(interface_font(TYPE))
        line = QRectF(0, 0, self.width(), TYPE + 5)
        painter.drawText(line, Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter, self._title)
        if self.legend.bands:
            self._paint_bands(painter, TYPE + 9)
        else:
            self._paint_range(painter, TYPE + 9)

    def _paint_bands(self, painter: QPainter, top: float) -> None:
        for row, band in enumerate(self.legend.bands):
            y = top + row * (TYPE + 7)
            painter.fillRect(QRectF(0, y + 2, 12, 12), QColor.fromRgbF(*band.colour))
            place = QRectF(20, y, self.width() - 20, TYPE + 4)
            painter.drawText(place, Qt.AlignmentFlag.AlignLeft | Qt.AlignmentFlag.AlignVCenter, band.title)

    def _paint_range(self, painter: QPainter, top: float) -> None:
        legend = self.legend
        if legend.colours is None:
            return
        values = np.linspace(legend.low, legend.high, STEPS)
        strip = np.ascontiguousarray(np.clip(legend.colours(values), 0, 1) * 255 + 0.5, dtype=np.uint8)
        picture = QImage(strip.tobytes(), STEPS, 1, 3 * STEPS, QImage.Format.Format_RGB888)
        painter.drawImage(QRectF(0, top, self.width(), BAR), picture)
        painter.setFont(interface_font(SMALL_TYPE))
        painter.setPen(QColor(current_theme().muted))
        sides = (Qt.AlignmentFlag.AlignLeft, Qt.AlignmentFlag.AlignHCenter, Qt.AlignmentFlag.AlignRight)
        for side, value in zip(sides, np.linspace(legend.low, legend.high, TICKS), strict=True):
            more = "≥ " if legend.beyond and value == legend.high else ""
            place = QRectF(0, top + BAR + 3, self.width(), SMALL_TYPE + 5)
            painter.drawText(place, side, more + figure(float(value), legend.high))


def figure(value: float, top: float) -> str:
    """A number of a range that ends at ``top``, with as many decimals as three figures of that have."""
    decimals = max(0, 2 - math.floor(math.log10(abs(top)))) if top else 0
    text = f"{value:.{min(decimals, 6)}f}"
    return text.rstrip("0").rstrip(".") if "." in text else text

"""A group under a heading that folds."""

from __future__ import annotations

from PySide6.QtCore import QPointF, QRectF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QPainter, QPaintEvent, QPolygonF
from PySide6.QtWidgets import QAbstractButton, QSizePolicy, QVBoxLayout, QWidget

from ui.theme.apply import current_theme, interface_font
from ui.theme.metrics import GRID, ROW, SMALL_TYPE


class FoldHeading(QAbstractButton):
    """The heading: a triangle, the title in capitals, and how many things in the group are on."""

    def __init__(self, title: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.setText(title)
        self.setAccessibleName(title)
        self.setCheckable(True)
        self.setChecked(True)
        self.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self.setAttribute(Qt.WidgetAttribute.WA_Hover)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self._active = 0

    def set_active(self, count: int) -> None:
        """Show how many are on."""
        if count != self._active:
            self._active = count
            self.update()

    def sizeHint(self) -> QSize:
        """One row."""
        return QSize(20 * GRID, ROW + 2)

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw triangle, title and count."""
        theme = current_theme()
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        bright = self.underMouse() or self.hasFocus()
        colour = QColor(theme.text if bright else theme.muted)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(colour)
        painter.drawPolygon(_triangle(QPointF(GRID + 4.5, self.height() / 2), self.isChecked()))
        painter.setPen(colour)
        font = interface_font(SMALL_TYPE)
        font.setLetterSpacing(font.SpacingType.AbsoluteSpacing, 0.6)
        painter.setFont(font)
        line = QRectF(3 * GRID, 0, self.width() - 4 * GRID, self.height())
        centre = Qt.AlignmentFlag.AlignVCenter
        painter.drawText(line, centre | Qt.AlignmentFlag.AlignLeft, self.text().upper())
        if self._active:
            painter.setPen(QColor(theme.accent))
            painter.drawText(line, centre | Qt.AlignmentFlag.AlignRight, str(self._active))


class Collapsible(QWidget):
    """Rows under a heading; folding hides them.

    Signals
    -------
    folded(bool) : a person folded or unfolded it
    """

    folded = Signal(bool)

    def __init__(self, title: str, parent: QWidget | None = None) -> None:
        super().__init__(parent)
        self.heading = FoldHeading(title)
        self._body = QWidget()
        self.rows = QVBoxLayout(self._body)
        self.rows.setContentsMargins(0, 0, 0, GRID)
        self.rows.setSpacing(2)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(0)
        layout.addWidget(self.heading)
        layout.addWidget(self._body)
        self.heading.toggled.connect(self._body.setVisible)
        self.heading.clicked.connect(lambda checked: self.folded.emit(not checked))

    @property
    def is_folded(self) -> bool:
        """Whether the rows are hidden."""
        return not self.heading.isChecked()

    def fold(self, folded: bool) -> None:
        """Hide or show the rows without telling anyone."""
        self.heading.setChecked(not folded)


def _triangle(centre: QPointF, unfolded: bool) -> QPolygonF:
    long, short = 4.0, 2.5
    if unfolded:
        corners = [(-long, -short), (long, -short), (0.0, short)]
    else:
        corners = [(-short, -long), (short, 0.0), (-short, long)]
    return QPolygonF([centre + QPointF(x, y) for x, y in corners])

"""The colour of a muscle on the face: that of its group, one of a few that go with the others, or any."""

from __future__ import annotations

from PySide6.QtCore import QRectF, QSize, Qt, Signal
from PySide6.QtGui import QColor, QPainter, QPaintEvent
from PySide6.QtWidgets import QColorDialog, QGridLayout, QMenu, QToolButton, QWidget, QWidgetAction

from ui.theme.apply import current_theme
from ui.theme.metrics import GRID, RADIUS, ROW

CHOICES = (
    ("#cc943f", "#d9b45a", "#a7a34c", "#879959"),
    ("#5c999e", "#5a86b8", "#9478bd", "#b673a6"),
    ("#bd544f", "#d0754f", "#c26b85", "#8c6b5c"),
)
"""Colours alike in brightness, so that no muscle shouts."""

SIDE = 20


class Swatch(QToolButton):
    """A field of one colour."""

    def __init__(self, name: str, side: int = SIDE) -> None:
        super().__init__()
        self.colour = ""
        self.setFixedSize(QSize(side, side))
        self.setFocusPolicy(Qt.FocusPolicy.TabFocus)
        self.setAccessibleName(name)

    def paintEvent(self, _event: QPaintEvent) -> None:
        """Draw it, with a frame under the pointer and in focus."""
        theme = current_theme()
        painter = QPainter(self)
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        near = self.underMouse() or self.hasFocus()
        painter.setPen(QColor(theme.accent if near and self.isEnabled() else theme.line))
        painter.setBrush(QColor(self.colour) if self.colour else Qt.BrushStyle.NoBrush)
        painter.setOpacity(1.0 if self.isEnabled() else 0.5)
        painter.drawRoundedRect(QRectF(self.rect()).adjusted(1.5, 1.5, -1.5, -1.5), RADIUS, RADIUS)


class ColourButton(Swatch):
    """Shows a colour, and lets another be chosen.

    Signals
    -------
    chosen(str) : ``#rrggbb``, or nothing for the colour of the group
    """

    chosen = Signal(str)

    def __init__(self) -> None:
        super().__init__("Colour", ROW)
        self.setToolTip("Colour on the face: that of the group, or one of its own")
        self.setPopupMode(QToolButton.ToolButtonPopupMode.InstantPopup)
        self.menu_box = QMenu(self)
        self.of_group = self.menu_box.addAction("Colour of the group", lambda: self.chosen.emit(""))
        self.of_group.setCheckable(True)
        fields = QWidgetAction(self.menu_box)
        fields.setDefaultWidget(self._fields())
        self.menu_box.addAction(fields)
        self.menu_box.addAction("Other colour…", self._ask)
        self.setMenu(self.menu_box)

    def show_colour(self, colour: str, own: bool) -> None:
        """Show a colour, which is a muscle's own or that of its group; nothing where there are several."""
        self.colour = colour
        self.of_group.setChecked(bool(colour) and not own)
        self.update()

    def _fields(self) -> QWidget:
        box = QWidget()
        grid = QGridLayout(box)
        grid.setContentsMargins(GRID, GRID // 2, GRID, GRID // 2)
        grid.setSpacing(GRID // 2)
        for row, colours in enumerate(CHOICES):
            for column, colour in enumerate(colours):
                swatch = Swatch(colour)
                swatch.colour = colour
                swatch.setToolTip(colour)
                swatch.clicked.connect(lambda _checked=False, colour=colour: self._take(colour))
                grid.addWidget(swatch, row, column)
        return box

    def _take(self, colour: str) -> None:
        self.menu_box.close()
        self.chosen.emit(colour)

    def _ask(self) -> None:
        colour = QColorDialog.getColor(QColor(self.colour or CHOICES[0][0]), self.window(), "Colour of the muscle")
        if colour.isValid():
            self.chosen.emit(colour.name())

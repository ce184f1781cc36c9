"""How the cells of the muscles’ tree are drawn: headings, names, chips of sides, eyes and padlocks."""

from __future__ import annotations

import qtawesome
from PySide6.QtCore import QModelIndex, QPersistentModelIndex, QRectF, QSize, Qt
from PySide6.QtGui import QColor, QPainter
from PySide6.QtWidgets import QStyle, QStyledItemDelegate, QStyleOptionViewItem

from ui.theme.apply import current_theme
from ui.theme.chosen import chosen_ground, quiet_ink
from ui.theme.colour import blend, contrast
from ui.theme.icons import FAMILY
from ui.theme.metrics import GRID, ICON, RADIUS, ROW
from ui.theme.roles import Theme

KEYS = Qt.ItemDataRole.UserRole + 1
"""Keys of the muscles that a cell stands for."""
SIDE = Qt.ItemDataRole.UserRole + 2
"""Side of a chip."""
GROUP = Qt.ItemDataRole.UserRole + 3
"""Group that a heading names."""
COLOUR = Qt.ItemDataRole.UserRole + 4
"""Colour on the face of a heading's group, or of a muscle that has its own."""
SHARE = Qt.ItemDataRole.UserRole + 5
"""Share of the muscles of a row that is hidden or locked, for eye and padlock; whether one is hidden, for a chip."""

NAME, LEFT, RIGHT, EYE, LOCK = range(5)
GLYPHS = {EYE: ("eye-outline", "eye-off-outline"), LOCK: ("lock-open-variant-outline", "lock")}
"""Glyphs of a switch that is off, and of one that is on."""

SWATCH = 8
"""Side of the colour that a group has on the face."""
QUIET, HALF = 0.55, 0.7
"""Shares of writing in the colours of a switch that is off, which is seen only in the row under the pointer, and of one
that is on for some of its muscles.  Off it still keeps 3 to 1 on its ground, as WCAG 2.2 asks of controls."""
ROLES = {"L": "left", "R": "right", "M": "both"}

Cell = QModelIndex | QPersistentModelIndex
SELECTED, HOVERED = QStyle.StateFlag.State_Selected, QStyle.StateFlag.State_MouseOver


class MuscleCells(QStyledItemDelegate):
    """Draws names, chips and switches; a cell that is selected is filled with the colour of its side.

    Attributes
    ----------
    under : the first cell of the row under the pointer, whose switches show even if they are off
    """

    under: QModelIndex = QModelIndex()

    def sizeHint(self, _option: QStyleOptionViewItem, _index: Cell) -> QSize:
        """One row of any width."""
        return QSize(0, ROW)

    def paint(self, painter: QPainter, option: QStyleOptionViewItem, index: Cell) -> None:
        """Draw a heading, a name, a chip or a switch."""
        painter.save()
        painter.setRenderHint(QPainter.RenderHint.Antialiasing)
        if index.column() in GLYPHS:
            _paint_switch(painter, option, index, index.sibling(index.row(), NAME) == self.under)
        elif index.data(SIDE):
            _paint_chip(painter, option, index)
        elif index.column() == NAME:
            _paint_name(painter, option, index)
        painter.restore()


def switch_ink(theme: Theme, share: float) -> QColor:
    """The colour of a switch that is on for a share (0..1) of its muscles."""
    return blend(theme.panel, theme.text, 1.0 if share == 1.0 else HALF if share else QUIET)


def _paint_switch(painter: QPainter, option: QStyleOptionViewItem, index: Cell, near: bool) -> None:
    share = index.data(SHARE) or 0.0
    if not share and not near:
        return
    theme = current_theme()
    off, on = GLYPHS[index.column()]
    hovered = bool(option.state & HOVERED)
    painter.setPen(switch_ink(theme, 1.0 if hovered else share))
    painter.setFont(qtawesome.font(FAMILY, ICON - 2))
    painter.drawText(
        QRectF(option.rect), Qt.AlignmentFlag.AlignCenter, qtawesome.charmap(f"{FAMILY}.{on if share else off}")
    )


def _paint_chip(painter: QPainter, option: QStyleOptionViewItem, index: Cell) -> None:
    theme = current_theme()
    area = QRectF(option.rect).adjusted(2, 3, -2, -3)
    colour, on = QColor(getattr(theme, ROLES[index.data(SIDE)])), bool(option.state & SELECTED)
    if index.data(SHARE):
        colour = blend(theme.panel, colour, 0.45)
    hovered = bool(option.state & HOVERED)
    painter.setPen(Qt.PenStyle.NoPen)
    if on or hovered:
        painter.setBrush(colour if on else blend(theme.panel, colour, 0.25))
        painter.drawRoundedRect(area, RADIUS, RADIUS)
    dark, light = QColor(theme.window), QColor(theme.on_accent)
    readable = dark if contrast(dark, colour) > contrast(light, colour) else light
    painter.setPen(readable if on else theme.text if hovered else theme.muted if index.data(SHARE) else colour)
    painter.drawText(area, Qt.AlignmentFlag.AlignCenter, index.data(Qt.ItemDataRole.DisplayRole))


def _paint_name(painter: QPainter, option: QStyleOptionViewItem, index: Cell) -> None:
    theme = current_theme()
    area = QRectF(option.rect)
    heading, colour = index.data(GROUP), index.data(COLOUR)
    if option.state & SELECTED:
        painter.fillRect(area, chosen_ground(theme))
    elif option.state & HOVERED:
        painter.fillRect(area, QColor(theme.hover))
    if colour:
        left = area.x() if heading else area.right() - GRID - SWATCH
        swatch = QRectF(left, area.center().y() - SWATCH / 2, SWATCH, SWATCH)
        painter.setPen(Qt.PenStyle.NoPen)
        painter.setBrush(QColor(colour))
        painter.drawRoundedRect(swatch, 2, 2)
        if heading:
            area.setLeft(swatch.right() + GRID // 2)
        else:
            area.setRight(swatch.left())
    quiet = quiet_ink(theme, option.state & SELECTED)
    painter.setPen(quiet if heading or index.data(SHARE) else QColor(theme.text))
    words = index.data(Qt.ItemDataRole.DisplayRole)
    room = area.adjusted(GRID // 2, 0, -GRID // 2, 0)
    text = painter.fontMetrics().elidedText(words, Qt.TextElideMode.ElideRight, int(room.width()))
    painter.drawText(room, Qt.AlignmentFlag.AlignVCenter | Qt.AlignmentFlag.AlignLeft, text)

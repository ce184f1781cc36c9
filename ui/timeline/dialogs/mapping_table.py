"""A mapping table as a table that can be edited: wrong cells are marked and leave the row as it was."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from PySide6.QtCore import QAbstractTableModel, QModelIndex, Qt, Signal
from PySide6.QtGui import QColor

from app.arithmetic import evaluate
from app.errors import NumberError
from facemodel.actions import ActionUnit
from facemodel.animation.capture import Capture
from facemodel.animation.mapping import Mapping, MapRow, fields_of, with_row, without_row
from ui.theme.apply import current_theme

Role = Qt.ItemDataRole
HEADINGS = ("Source", "Target", "Gain", "Offset", "Cap", "Centred")
TIPS = (
    "Channel of the capture",
    "Action unit such as 12, 12L or a name; or head.yaw, eyeL.pitch …",
    "What 1 of the source is of the target",
    "Taken off the source before",
    "The farthest that the row brings its target from rest; empty for the range of the channel",
    "Take the median off before: for a head whose camera was not straight ahead",
)

NUMBERS = (2, 3, 4)
"""Columns that are read from their right."""


class MappingTable(QAbstractTableModel):
    """The rows of a mapping.

    Signals
    -------
    edited(object) : the Mapping as a person has changed it

    Parameters
    ----------
    mapping : what is shown
    capture : whose channels are the sources
    units : of the face, which has the targets
    """

    edited = Signal(object)

    def __init__(self, mapping: Mapping, capture: Capture, units: Sequence[ActionUnit]) -> None:
        super().__init__()
        self.mapping, self._units = mapping, units
        self._channels = frozenset(capture.channels)

    def take(self, mapping: Mapping) -> None:
        """Show another table."""
        self.beginResetModel()
        self.mapping = mapping
        self.endResetModel()

    def add_row(self, source: str) -> None:
        """One more row behind the last."""
        place = len(self.mapping.rows)
        self.beginInsertRows(QModelIndex(), place, place)
        self.mapping = with_row(self.mapping, place, MapRow(source, source))
        self.endInsertRows()
        self.edited.emit(self.mapping)

    def remove_rows(self, places: Sequence[int]) -> None:
        """Without some rows."""
        self.beginResetModel()
        for place in sorted(set(places), reverse=True):
            self.mapping = without_row(self.mapping, place)
        self.endResetModel()
        self.edited.emit(self.mapping)

    def rowCount(self, parent: QModelIndex | None = None) -> int:
        """How many rows there are."""
        return 0 if parent is not None and parent.isValid() else len(self.mapping.rows)

    def columnCount(self, _parent: QModelIndex | None = None) -> int:
        """As many as headings."""
        return len(HEADINGS)

    def headerData(self, section: int, orientation: Qt.Orientation, role: int = Role.DisplayRole) -> Any:
        """Headings, and what they mean."""
        if orientation == Qt.Orientation.Horizontal:
            if role == Role.DisplayRole:
                return HEADINGS[section]
            if role == Role.ToolTipRole:
                return TIPS[section]
            if role == Role.TextAlignmentRole:
                side = Qt.AlignmentFlag.AlignRight if section in NUMBERS else Qt.AlignmentFlag.AlignLeft
                return side | Qt.AlignmentFlag.AlignVCenter
        return None

    def flags(self, index: QModelIndex) -> Qt.ItemFlag:
        """All cells can be edited, the last one is a box to tick."""
        own = Qt.ItemFlag.ItemIsUserCheckable if index.column() == 5 else Qt.ItemFlag.ItemIsEditable
        return Qt.ItemFlag.ItemIsEnabled | Qt.ItemFlag.ItemIsSelectable | own

    def data(self, index: QModelIndex, role: int = Role.DisplayRole) -> Any:
        """What a cell says; what has no place on this face or in this capture recedes or warns."""
        row, column = self.mapping.rows[index.row()], index.column()
        if role in (Role.DisplayRole, Role.EditRole):
            return _cell(row, column)
        if role == Role.CheckStateRole and column == 5:
            return Qt.CheckState.Checked if row.centred else Qt.CheckState.Unchecked
        if role == Role.ForegroundRole:
            return self._colour(row, column)
        if role == Role.TextAlignmentRole and column in NUMBERS:
            return Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter
        if role == Role.ToolTipRole and column < 2:
            return self._complaint(row, column)
        return None

    def setData(self, index: QModelIndex, value: Any, role: int = Role.EditRole) -> bool:
        """Take what was typed or ticked; what is no number is not taken."""
        row, column = self.mapping.rows[index.row()], index.column()
        if role == Role.CheckStateRole and column == 5:
            made = replace(row, centred=Qt.CheckState(value) == Qt.CheckState.Checked)
        elif role == Role.EditRole:
            try:
                made = _typed(row, column, str(value).strip())
            except NumberError:
                return False
        else:
            return False
        if made == row:
            return False
        self.mapping = with_row(self.mapping, index.row(), made)
        self.dataChanged.emit(index, index)
        self.edited.emit(self.mapping)
        return True

    def _complaint(self, row: MapRow, column: int) -> str:
        if column == 0 and row.source not in self._channels:
            return "The capture has no such channel"
        return "This face has no such action unit" if column == 1 and not fields_of(row.target, self._units) else ""

    def _colour(self, row: MapRow, column: int) -> QColor | None:
        theme = current_theme()
        if row.source not in self._channels:
            return QColor(theme.muted)
        return QColor(theme.warn) if column == 1 and not fields_of(row.target, self._units) else None


def _cell(row: MapRow, column: int) -> str:
    cap = "" if row.cap is None else f"{row.cap:g}"
    return (row.source, row.target, f"{row.gain:g}", f"{row.offset:g}", cap, "")[column]


def _typed(row: MapRow, column: int, text: str) -> MapRow:
    """A row with a cell as it was typed; raises `NumberError` if it is no number where one has to be."""
    if column == 0:
        return replace(row, source=text) if text else row
    if column == 1:
        return replace(row, target=text) if text else row
    if column == 4 and not text:
        return replace(row, cap=None)
    number = evaluate(text)
    return replace(row, **{2: {"gain": number}, 3: {"offset": number}, 4: {"cap": abs(number)}}[column])  # type: ignore[arg-type]

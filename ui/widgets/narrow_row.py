"""Rows of lists that never scroll sideways."""

from __future__ import annotations

from PySide6.QtCore import QModelIndex, QPersistentModelIndex, QSize
from PySide6.QtWidgets import QStyledItemDelegate, QStyleOptionViewItem

from ui.theme.metrics import ROW


class NarrowRow(QStyledItemDelegate):
    """A row as wide as the list, so that a long name is shortened and the list never scrolls sideways."""

    def sizeHint(self, _option: QStyleOptionViewItem, _index: QModelIndex | QPersistentModelIndex) -> QSize:
        """One row of any width."""
        return QSize(0, ROW)

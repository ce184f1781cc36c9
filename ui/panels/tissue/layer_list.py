"""The layers that can be painted: the one chosen here is in hand and is shown."""

from __future__ import annotations

from PySide6.QtCore import QModelIndex, QPersistentModelIndex, QRect, QSize, Qt
from PySide6.QtGui import QPainter
from PySide6.QtWidgets import QListWidget, QListWidgetItem, QStyle, QStyledItemDelegate, QStyleOptionViewItem

from app.tools.brush_state import BrushState, HandBrush
from app.view import View
from facemodel.painting.layers import PAINT_LAYERS
from ui.theme.apply import current_theme
from ui.theme.chosen import quiet_ink
from ui.theme.metrics import GRID, ROW

KEY, UNIT = Qt.ItemDataRole.UserRole + 1, Qt.ItemDataRole.UserRole + 2


class _Row(QStyledItemDelegate):
    """Title at the left, unit receding at the right."""

    def sizeHint(self, _option: QStyleOptionViewItem, _index: QModelIndex | QPersistentModelIndex) -> QSize:
        return QSize(0, ROW)

    def paint(
        self, painter: QPainter, option: QStyleOptionViewItem, index: QModelIndex | QPersistentModelIndex
    ) -> None:
        super().paint(painter, option, index)
        painter.save()
        painter.setPen(quiet_ink(current_theme(), option.state & QStyle.StateFlag.State_Selected))
        place = QRect(option.rect).adjusted(0, 0, -GRID, 0)
        painter.drawText(place, Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter, index.data(UNIT))
        painter.restore()


class LayerList(QListWidget):
    """Binds the layer of the brush and of the view to a list, both ways."""

    def __init__(self, brush: HandBrush, view: View) -> None:
        super().__init__()
        self._brush, self._view = brush, view
        self.setAccessibleName("Layers")
        self.setItemDelegate(_Row(self))
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setVerticalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        self.setFixedHeight(ROW * len(PAINT_LAYERS) + 2)
        for layer in PAINT_LAYERS:
            item = QListWidgetItem(layer.title)
            item.setData(KEY, layer.key)
            item.setData(UNIT, layer.unit)
            item.setToolTip(_tip(layer.low, layer.high, layer.unit, layer.reason))
            self.addItem(item)
        self._mark(brush.state.layer)
        if view.state.layer != brush.state.layer:
            view.change(layer=brush.state.layer)
        self.currentItemChanged.connect(self._choose)
        brush.changed.connect(self._follow)

    def _choose(self) -> None:
        key = self.currentItem().data(KEY)
        self._brush.change(layer=key)
        self._view.change(layer=key)

    def _follow(self, now: BrushState, before: BrushState) -> None:
        if now.layer != before.layer:
            self._mark(now.layer)

    def _mark(self, key: str) -> None:
        for row in range(self.count()):
            if self.item(row).data(KEY) == key:
                self.setCurrentRow(row)


def _tip(low: float, high: float, unit: str, reason: str) -> str:
    return f"{low:g} to {high:g} {unit}: {reason}" if unit else reason

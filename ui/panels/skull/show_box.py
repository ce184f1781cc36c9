"""What is drawn of skin and bone while the skull is worked on."""

from __future__ import annotations

from PySide6.QtWidgets import QCheckBox, QVBoxLayout, QWidget

from app.view import View
from ui.theme.metrics import GRID

SWITCHES = (
    ("skull", "Skull", "Draw the bone through a clear skin (K)"),
    ("muscles", "Muscles", "Draw the muscles over the bone, to see what moves with it (U)"),
)


class ShowBox(QWidget):
    """Binds switches of the view to boxes, both ways."""

    def __init__(self, view: View) -> None:
        super().__init__()
        self._view = view
        self.boxes: dict[str, QCheckBox] = {}
        layout = QVBoxLayout(self)
        layout.setContentsMargins(GRID, 0, GRID, 0)
        layout.setSpacing(GRID // 2)
        for name, title, tip in SWITCHES:
            box = self.boxes[name] = QCheckBox(title)
            box.setToolTip(tip)
            box.toggled.connect(lambda on, name=name: view.change(**{name: on}))
            layout.addWidget(box)
        view.changed.connect(self._show)
        self._show()

    def _show(self, *_now: object) -> None:
        for name, box in self.boxes.items():
            box.blockSignals(True)
            box.setChecked(getattr(self._view.state, name))
            box.blockSignals(False)

"""What is drawn of the layers, and of the last solve."""

from __future__ import annotations

from PySide6.QtWidgets import QCheckBox, QVBoxLayout, QWidget

from app.document import Document
from app.view import View
from app.view_state import ViewState
from ui.theme.metrics import GRID
from ui.widgets.number_bar import NumberBar
from ui.widgets.number_scale import NumberScale

SWITCHES = (
    ("contours", "Lines of equal value", "Ten lines across the range of the legend"),
    ("glyphs", "Ellipses of stiffness", "How stiff the skin is along and across its grain"),
    ("change_map", "Change by the last solve", "Colour the skin by how far the last solve moved what is shown"),
    ("before", "Face before the last solve", "Show the same expression as it was before the last solve"),
)
OF_SOLVES = ("change_map", "before")


class LookBox(QWidget):
    """Binds switches of the view to boxes, both ways."""

    def __init__(self, document: Document, view: View) -> None:
        super().__init__()
        self._document, self._view = document, view
        self.opacity = NumberBar("Opacity", NumberScale(0, 100, 100 * ViewState().layer_opacity, "%", whole=True))
        self.opacity.previewed.connect(lambda value: view.change(layer_opacity=value / 100))
        self.boxes: dict[str, QCheckBox] = {}
        layout = QVBoxLayout(self)
        layout.setContentsMargins(GRID, 0, GRID, 0)
        layout.setSpacing(GRID // 2)
        layout.addWidget(self.opacity)
        for name, title, tip in SWITCHES:
            box = self.boxes[name] = QCheckBox(title)
            box.setToolTip(tip)
            box.toggled.connect(lambda on, name=name: view.change(**{name: on}))
            layout.addWidget(box)
        view.changed.connect(self._show)
        document.solution_changed.connect(self._show)
        document.project_changed.connect(self._show)
        self._show()

    def _show(self, *_now: object) -> None:
        state = self._view.state
        self.opacity.set_value(100 * state.layer_opacity)
        for name, box in self.boxes.items():
            box.blockSignals(True)
            box.setChecked(getattr(state, name))
            box.blockSignals(False)
        for name in OF_SOLVES:
            self.boxes[name].setEnabled(self._document.previous_solution is not None or getattr(state, name))

"""Which shapes an exported model has."""

from __future__ import annotations

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QLabel, QWidget

from facemodel.io.export.asked import Shaping
from ui.panels.export.form import Form, choice
from ui.widgets.number_bar import NumberBar
from ui.widgets.number_scale import NumberScale

SHAPINGS: dict[Shaping, str] = {
    "units": "Action units, and what corrects them",
    "clip": "A few shapes made for this clip",
}
ADVICE: dict[Shaping, str] = {
    "units": "Other programs can go on animating with the action units.",
    "clip": "Plays in small viewers: those on phones take 8 shapes.",
}

FEWEST, MOST = 2, 64


class ModelBox(QWidget):
    """Shapes of action units or of the clip, and how many.

    Signals
    -------
    changed() : something else is chosen
    """

    changed = Signal()

    def __init__(self) -> None:
        super().__init__()
        self.shaping = choice("Shapes", dict(SHAPINGS))
        self.most = NumberBar("At most", NumberScale(FEWEST, MOST, 8, "", True, 2.0))
        self.advice = QLabel()
        self.advice.setProperty("role", "muted")
        self.advice.setWordWrap(True)
        form = Form()
        form.head("Model")
        form.row("Shapes", self.shaping)
        form.row("", self.most)
        form.row("", self.advice)
        self.setLayout(form)
        self.shaping.activated.connect(self._follow)
        self.most.previewed.connect(lambda _value: self.changed.emit())
        self._follow()

    @property
    def chosen(self) -> tuple[Shaping, int | None]:
        """Which shapes, and how many at most if that is limited."""
        shaping: Shaping = self.shaping.currentData()
        return shaping, round(self.most.value) if shaping == "clip" else None

    def _follow(self, _index: int = 0) -> None:
        shaping = self.shaping.currentData()
        self.most.setEnabled(shaping == "clip")
        self.advice.setText(ADVICE[shaping])
        self.changed.emit()

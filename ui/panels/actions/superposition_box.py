"""The superposition check: a button, its progress, and how far the sum of the fields is from the summed loads."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QCheckBox, QHBoxLayout, QLabel, QProgressBar, QPushButton, QVBoxLayout, QWidget

from app.actions.context import Context
from app.superposition_check import SuperpositionCheck
from app.view_state import ViewState
from facemodel.comparison import Comparison
from facemodel.errors import RisoriusError
from ui.theme.metrics import GRID

NOTHING = 1e-3
"""Millimetres; what is nearer than a thousandth is rounding."""

STEPS = 1000
IDLE = "Checks what the face shows; a double click on an expression shows that."


class SuperpositionBox(QWidget):
    """Binds the check to a button that begins or cancels it, and tells what it finds."""

    def __init__(self, context: Context, check: SuperpositionCheck) -> None:
        super().__init__()
        self._context, self._check = context, check
        self.button = QPushButton("Check superposition")
        self.button.setToolTip("Solve the summed loads of what is seen in full, and compare")
        self.draw = QCheckBox("Draw it")
        self.draw.setToolTip("Colour the skin by how far both ways are apart")
        self.bar = QProgressBar()
        self.bar.setRange(0, STEPS)
        self.bar.setTextVisible(False)
        self.bar.setFixedHeight(GRID // 2)
        self.bar.setAccessibleName("Progress of the check")
        self.result = QLabel("")
        self.result.setProperty("role", "muted")
        self.result.setWordWrap(True)
        self.result.setAlignment(Qt.AlignmentFlag.AlignTop)
        line = QHBoxLayout()
        line.addWidget(self.button)
        line.addStretch(1)
        line.addWidget(self.draw)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(GRID, 0, GRID, GRID)
        layout.setSpacing(GRID // 2)
        layout.addLayout(line)
        layout.addWidget(self.bar)
        layout.addWidget(self.result)
        self.button.clicked.connect(self.press)
        self.draw.toggled.connect(lambda on: context.view.change(apart_map=on))
        context.view.changed.connect(self._show_view)
        check.changed.connect(self.refresh)
        self._show_view(context.view.state)
        self.refresh()

    def press(self) -> None:
        """Begin to check what is seen, or stop."""
        if self._check.running:
            self._check.cancel()
            return
        try:
            self._check.begin()
        except RisoriusError as error:
            self._say(str(error))

    def refresh(self) -> None:
        """Show how far the check is, or what it found."""
        running, (step, share) = self._check.running, self._check.step
        self.button.setText("Cancel" if running else "Check superposition")
        self.bar.setVisible(running)
        self.bar.setValue(round(STEPS * share))
        found = self._check.found
        if running:
            self._say(f"{step} …")
        elif found is not None:
            self._say(told(found))
        else:
            self._say(self._check.failure or IDLE)
        self.draw.setVisible(found is not None and found.largest >= NOTHING)

    def _say(self, text: str) -> None:
        self.result.setText(text)
        self.result.setVisible(bool(text))

    def _show_view(self, now: ViewState, _before: ViewState | None = None) -> None:
        self.draw.blockSignals(True)
        self.draw.setChecked(now.apart_map)
        self.draw.blockSignals(False)


def told(found: Comparison) -> str:
    """What a check found, in words."""
    if found.largest < NOTHING:
        return f"The sum is exact: less than a thousandth of a millimetre apart, of {found.moved:.1f} mm moved."
    return (
        f"At most {found.largest:.2f} mm apart, {found.rms:.3f} mm rms, of {found.moved:.1f} mm moved. "
        "Where lids and lips meet something they give way, which is not linear."
    )

"""The superposition check: a button, and how far the sum of the fields is from the summed loads solved in full."""

from __future__ import annotations

from PySide6.QtWidgets import QHBoxLayout, QLabel, QPushButton, QVBoxLayout, QWidget

from app.actions.context import Context
from app.jobs import Failure
from app.superposition_check import Posed, SuperpositionJob, check_superposition, posed
from facemodel.comparison import Comparison
from facemodel.errors import RisoriusError
from ui.theme.metrics import GRID
from ui.window.delivery import UiThread

NOTHING = 1e-3
"""Millimetres; what is nearer than a thousandth is rounding."""


class SuperpositionBox(QWidget):
    """Checks the expression that is shown, away from the window's thread."""

    def __init__(self, context: Context) -> None:
        super().__init__()
        self._context = context
        self._thread = UiThread(self)
        self.job: SuperpositionJob = SuperpositionJob(check_superposition, self._thread.deliver)
        self.button = QPushButton("Check superposition")
        self.button.setToolTip("Solve the summed loads of this expression in full, and compare")
        self.result = QLabel("")
        self.result.setProperty("role", "muted")
        self.result.setWordWrap(True)
        line = QHBoxLayout()
        line.addWidget(self.button)
        line.addStretch(1)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(GRID, 0, GRID, GRID)
        layout.setSpacing(GRID // 2)
        layout.addLayout(line)
        layout.addWidget(self.result)
        self.button.clicked.connect(self.check)
        self.job.progress.connect(self._tell)
        self.job.finished.connect(self._show)
        self.job.failed.connect(self._show_failure)
        document = context.document
        for other in (document.expression_changed, document.solution_changed, document.project_changed):
            other.connect(self._forget)

    def check(self) -> None:
        """Begin to check what is shown."""
        try:
            asked = posed(self._context.document)
        except RisoriusError as error:
            self.result.setText(str(error))
            return
        if not any(asked.expression.values()):
            self.result.setText("The face is at rest; move some sliders first.")
            return
        self.button.setEnabled(False)
        self.job.request(asked)

    def _tell(self, text: str, _share: float) -> None:
        self.result.setText(f"{text} …")

    def _show(self, found: Comparison, _asked: Posed) -> None:
        self.button.setEnabled(True)
        if found.largest < NOTHING:
            said = f"The sum is exact: less than a thousandth of a millimetre apart, of {found.moved:.1f} mm moved."
        else:
            said = (
                f"At most {found.largest:.2f} mm apart, {found.rms:.3f} mm rms, of {found.moved:.1f} mm moved. "
                "Jaw arcs and lids on the eye are not linear."
            )
        self.result.setText(said)

    def _show_failure(self, failure: Failure) -> None:
        self.button.setEnabled(True)
        self.result.setText(failure.sentence)

    def _forget(self, *_what: object) -> None:
        """What was found belongs to another expression."""
        if self.job.running:
            self.job.cancel()
        self.button.setEnabled(True)
        self.result.setText("")

"""Whether the fields are those of the paint, in one line."""

from __future__ import annotations

from PySide6.QtWidgets import QLabel

from app.document import Document
from app.solving import Solving


class SolveNote(QLabel):
    """Follows a document and the job that solves it."""

    def __init__(self, document: Document, solving: Solving) -> None:
        super().__init__()
        self._document, self._solving = document, solving
        self.setWordWrap(True)
        self.setProperty("role", "muted")
        job = solving.job
        for signal in (job.started, job.finished, job.cancelled, job.failed, document.solution_changed):
            signal.connect(self._show)
        document.history_changed.connect(self._show)
        self._show()

    def _show(self, *_now: object) -> None:
        document = self._document
        stale = len(document.stale_fields)
        if not document.stale:
            solution = document.solution
            took = "" if solution is None else f" in {sum(solution.seconds.values()):.1f} s"
            self.setText(f"The face shows what is painted, solved{took}.")
        elif self._solving.job.running:
            self.setText(f"Solving; {stale} fields are those from before the last step until then.")
        else:
            self.setText(f"{stale} fields are not solved for what is painted; F5 solves them.")

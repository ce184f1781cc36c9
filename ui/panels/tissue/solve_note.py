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
        else:
            self.setText(told(stale, self._solving.job.running))


def told(stale: int, solving: bool) -> str:
    """What is said while some fields are not those of the paint.

    Parameters
    ----------
    stale : how many
    solving : whether they are being solved
    """
    fields, them = ("1 field", "it") if stale == 1 else (f"{stale} fields", "them")
    if solving:
        return f"Solving; until then {fields} {'is' if stale == 1 else 'are'} as before the last step."
    return f"{fields} {'is' if stale == 1 else 'are'} not solved for what is painted; F5 solves {them}."

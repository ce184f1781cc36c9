"""The superposition check of what is seen: where the sum of the fields is not what the summed loads would do."""

from __future__ import annotations

from dataclasses import dataclass

from psygnal import Signal

from app.document import Document
from app.jobs import Deliver, Failure, Job
from app.solo import seen
from app.view import View
from app.view_state import ViewState
from facemodel.actions import Expression
from facemodel.basis import Basis
from facemodel.comparison import Comparison, compared, in_full
from facemodel.errors import FaceError
from facemodel.project import Project
from facemodel.solution import Progress, silent


@dataclass(frozen=True, eq=False)
class Posed:
    """An expression of a solved project, as it is drawn or as the pure linear sum."""

    project: Project
    basis: Basis
    expression: Expression
    linear: bool = False


class SuperpositionCheck:
    """Checks what is seen in the background; what it found is forgotten as soon as something else is seen.

    Attributes
    ----------
    found : what came out; none before, and none once something else is seen
    failure : why nothing came out; empty if nothing went wrong
    step : what is being done, and the share of the whole that is done

    Parameters
    ----------
    document, view : what is seen
    deliver : brings a call to the thread of the document; without it a check is waited for
    """

    changed = Signal()
    """It began, went on, ended, or was forgotten."""

    def __init__(self, document: Document, view: View, deliver: Deliver | None = None) -> None:
        self._document, self._view = document, view
        self.job: Job[Posed, Comparison] = Job(check_superposition, deliver)
        self.found: Comparison | None = None
        self.failure = ""
        self.step: tuple[str, float] = ("", 0.0)
        self.job.progress.connect(self._go_on)
        self.job.finished.connect(self._end)
        self.job.failed.connect(self._fail)
        self.job.cancelled.connect(self._stop)
        for signal in (document.expression_changed, document.solution_changed, document.project_changed):
            signal.connect(self._forget)
        view.changed.connect(self._follow_view)

    @property
    def running(self) -> bool:
        """Whether a result is still to come."""
        return self.job.running

    def begin(self) -> None:
        """Check what is seen.

        Raises
        ------
        FaceError
            If the face is not solved as it is now, or is at rest.
        """
        asked = posed(self._document, self._view.state)
        self.found, self.failure, self.step = None, "", ("Checking", 0.0)
        self.job.request(asked)
        self.changed.emit()

    def cancel(self) -> None:
        """Stop checking."""
        self.job.cancel()

    def _go_on(self, text: str, share: float) -> None:
        self.step = text, share
        self.changed.emit()

    def _end(self, found: Comparison, _asked: Posed) -> None:
        self.found = found
        self.changed.emit()

    def _fail(self, failure: Failure) -> None:
        self.failure = failure.sentence
        self.changed.emit()

    def _stop(self) -> None:
        self.changed.emit()

    def _follow_view(self, now: ViewState, before: ViewState) -> None:
        if self.found is not None or self.running:
            one, other = seen(self._document, now), seen(self._document, before)
            if now.linear != before.linear or (one is not other and one != other):
                self._forget()

    def _forget(self, *_what: object) -> None:
        """What was found belongs to something else than what is seen now."""
        if self.running:
            self.job.cancel()
        if self.found is not None or self.failure:
            self.found, self.failure = None, ""
            self.changed.emit()


def posed(document: Document, state: ViewState) -> Posed:
    """What is seen, without what is sculpted: that is meant to be another than what is solved.

    Raises
    ------
    FaceError
        If it is not solved as it is now, or is at rest.
    """
    if document.solved is None or document.stale:
        raise FaceError("There is nothing to check before this face is solved; choose “Solve now” first.")
    expression = seen(document, state)
    if not any(expression.values()):
        raise FaceError("The face is at rest, where nothing is summed; move some sliders first.")
    return Posed(document.project, document.solved.basis, expression, state.linear)


def check_superposition(asked: Posed, progress: Progress = silent) -> Comparison:
    """Solve the summed loads in full and compare.

    Raises
    ------
    FaceError, Cancelled
        As `facemodel.comparison.in_full` does.
    """
    whole = in_full(asked.project, asked.expression, progress)
    return compared(asked.project, asked.expression, asked.basis, whole, linear=asked.linear)

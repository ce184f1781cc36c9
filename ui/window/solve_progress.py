"""What a background solve looks like: progress, its end, and how fast the face follows the hand."""

from __future__ import annotations

from app.actions.context import Context
from app.jobs import Failure
from app.quality import QUALITY_TITLES
from app.view_state import ViewState
from facemodel.actions import skin_fields
from facemodel.project import Project
from ui.window.dialogs import show_error
from ui.window.status_line import StatusLine
from ui.window.viewport_widget import Viewport


class SolveProgress:
    """Follows the job of a context on the bottom line.

    Parameters
    ----------
    context : whose job it is
    status : where it is shown
    viewport : whose time per frame is shown beside
    """

    def __init__(self, context: Context, status: StatusLine, viewport: Viewport) -> None:
        self._context = context
        self._status = status
        self._viewport = viewport
        job = context.solving.job
        job.started.connect(self._begin)
        job.progress.connect(self._go_on)
        job.finished.connect(self._end)
        job.cancelled.connect(self._cancelled)
        job.failed.connect(self._failed)
        context.document.solution_changed.connect(self._refresh)
        viewport.timed.connect(self._refresh)
        context.view.changed.connect(self._follow_view)
        status.cancel_asked.connect(context.solving.cancel)
        self._refresh()

    def _begin(self, project: Project) -> None:
        self._status.show_progress(f"Solving {project.face.title}", 0.0)

    def _go_on(self, text: str, share: float) -> None:
        """A solution that is not in the cache takes a while: until then the face is shown at rest."""
        self._status.show_progress(text, share)
        if share < 1.0 and not self._viewport.shows_face:
            self._viewport.show_document()

    def _end(self, _solution: object, _project: object) -> None:
        self._status.end_progress()
        self._refresh()

    def _cancelled(self) -> None:
        self._status.end_progress()
        self._status.notify("Solving was cancelled; F5 solves again.")
        self._viewport.show_document()
        self._refresh()

    def _failed(self, failure: Failure) -> None:
        self._status.end_progress()
        self._refresh()
        self._viewport.show_document()
        show_error(self._viewport, failure.sentence, failure.details)

    def _follow_view(self, now: ViewState, before: ViewState) -> None:
        if now.level != before.level:
            self._refresh()

    def _refresh(self, _now: object = None) -> None:
        document = self._context.document
        total = len(skin_fields(document.project.units))
        done = 0 if document.solution is None or document.stale else len(document.solution.basis.names)
        took = self._viewport.frame_time
        timing = f" · {took:.0f} ms" if took and done else ""
        level = QUALITY_TITLES[self._context.view.state.level].lower()
        self._status.show_state(
            f"solved {done}/{total}{timing} · {level}",
            "Displacement fields that are solved, the time to pose and draw the last expression, "
            "and how finely it is drawn while it moves (View › Drawing quality)",
        )

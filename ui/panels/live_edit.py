"""Changes that are seen while the hand makes them: each is solved when the one before it is, and all are one step."""

from __future__ import annotations

from collections.abc import Callable
from itertools import count

from app.document import Document
from app.solving import Solving
from facemodel.project import Project

GESTURES = count(1)
"""Numbers that tell the gestures of a session apart."""

Change = Callable[[Project], Project]


class LiveEdit:
    """One gesture after the other on a document.

    What the hand asks for while a solve is under way waits, and only the last of it is done: the face follows as fast
    as it can be solved, and never lags behind.  Until the gesture is kept it can be taken back without a trace.

    Parameters
    ----------
    document : what is changed
    solving : which tells when a solve is over; without it every change is done at once
    """

    def __init__(self, document: Document, solving: Solving | None = None) -> None:
        self._document = document
        self._solving = solving
        self._gesture = ""
        self._waiting: tuple[Project, Project, str] | None = None
        if solving is not None:
            for over in (solving.job.finished, solving.job.failed, solving.job.cancelled):
                over.connect(self._solved)

    @property
    def under_way(self) -> bool:
        """Whether a gesture has begun and is neither kept nor taken back."""
        return bool(self._gesture)

    def propose(self, change: Change, label: str) -> None:
        """Change the project as the hand means it now.

        Raises
        ------
        RisoriusError
            If it cannot be changed so; what was proposed before stays.
        """
        if not self._gesture:
            self._gesture = f"live {next(GESTURES)}"
        before = self._document.project
        self._waiting = before, change(before), label
        if not self._busy:
            self._go_on()

    def keep(self) -> None:
        """The hand let go: what it asked for last stays, and is one step."""
        self._go_on()
        self._gesture = ""

    def cancel(self) -> None:
        """All is as it was before the hand took hold."""
        self._waiting = None
        gesture, self._gesture = self._gesture, ""
        if gesture:
            self._document.retract(gesture)

    @property
    def _busy(self) -> bool:
        return self._solving is not None and self._solving.job.running

    def _solved(self, *_outcome: object) -> None:
        if not self._busy:
            self._go_on()

    def _go_on(self) -> None:
        """Do what waits, unless somebody else has changed the project in the meantime."""
        if self._waiting is None:
            return
        (before, after, label), self._waiting = self._waiting, None
        if self._document.project is before:
            self._document.edit(after, label, self._gesture)

"""Snap the skull to the depths of the tissue, away from the window: it takes a second."""

from __future__ import annotations

from dataclasses import dataclass

from psygnal import Signal

from app.authoring.skull import with_pose
from app.document import Document
from app.jobs import Deliver, Failure, Job
from facemodel.errors import RisoriusError
from facemodel.face import Pose
from facemodel.project import Project
from facemodel.skull.snapping import snapped
from facemodel.solution import Progress

LABEL = "Snap skull to tissue depths"


@dataclass(frozen=True, eq=False)
class Wish:
    """Whose skull is to be snapped, whether it may be scaled, and whether muscles go along."""

    project: Project
    scales: bool
    origins: bool


def snapped_pose(wish: Wish, _progress: Progress) -> Pose:
    """The pose that is wished for; for a job."""
    return snapped(wish.project.face, wish.scales)


class SkullSnap:
    """Snaps the skull of a document, unless somebody else changes it in the meantime."""

    changed = Signal(bool)
    """Whether it is at work."""
    failed = Signal(str)
    """(sentence) why the skull stays where it is."""

    def __init__(self, document: Document) -> None:
        self._document = document
        self._job: Job[Wish, Pose] | None = None

    def snap(self, scales: bool = True, origins: bool = True, deliver: Deliver | None = None) -> None:
        """Begin to snap; in the background where calls can be delivered home, see `app.jobs.Job`."""
        self.stop()
        job = self._job = Job(snapped_pose, deliver)
        job.finished.connect(self._lay)
        job.failed.connect(self._fail)
        self.changed.emit(True)
        job.request(Wish(self._document.project, scales, origins))

    def stop(self) -> None:
        """Think better of it."""
        job, self._job = self._job, None
        if job is not None:
            job.close()
            self.changed.emit(False)

    def _lay(self, pose: Pose, wish: Wish) -> None:
        self.stop()
        if self._document.project.face is not wish.project.face:
            return
        try:
            self._document.edit(with_pose(self._document.project, pose, wish.origins), LABEL)
        except RisoriusError as error:
            self.failed.emit(str(error))

    def _fail(self, failure: Failure) -> None:
        self.stop()
        self.failed.emit(failure.sentence)

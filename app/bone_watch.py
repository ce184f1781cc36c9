"""Keeps watch over the skull of a document: what is found out about it is found anew when bone or skin change."""

from __future__ import annotations

from psygnal import Signal

from app.document import Document
from app.jobs import Deliver, Job
from facemodel.face import Face
from facemodel.skull.findings import Findings, findings
from facemodel.solution import Progress


def found_out(face: Face, _progress: Progress) -> Findings:
    """All findings about a face; for a job."""
    return findings(face)


class BoneWatch:
    """Finds out about the bone of a document while somebody attends to it.

    Attributes
    ----------
    found : about the face as it was looked at last; none before
    """

    changed = Signal()
    """There are other findings."""

    def __init__(self, document: Document) -> None:
        self._document = document
        self._job: Job[Face, Findings] | None = None
        self.found: Findings | None = None

    @property
    def current(self) -> bool:
        """Whether what was found holds for the document as it is."""
        return self.found is not None and _same_bone(self.found.face, self._document.project.face)

    def attend(self, deliver: Deliver | None = None) -> None:
        """Begin to look; in the background where calls can be delivered home, see `app.jobs.Job`."""
        if self._job is None:
            self._job = Job(found_out, deliver)
            self._job.finished.connect(self._take)
            self._document.history_changed.connect(self._look)
        self._look()

    def leave(self) -> None:
        """Look no more; what was found stays."""
        if self._job is not None:
            self._document.history_changed.disconnect(self._look)
            self._job.close()
            self._job = None

    def _look(self) -> None:
        """After every step of the document; most of them leave the bone alone."""
        if self._job is not None and not self.current:
            self._job.request(self._document.project.face)

    def _take(self, found: Findings, _face: Face) -> None:
        self.found = found
        self.changed.emit()


def _same_bone(one: Face, other: Face) -> bool:
    same = one.skull.cranium is other.skull.cranium and one.skull.mandible is other.skull.mandible
    return same and one.skin is other.skin and one.skull.anchors is other.skull.anchors and one.solved is other.solved

"""Keep a document solved: whatever makes its solution stale starts a solve, and the result goes home."""

from __future__ import annotations

from app.document import Document
from app.jobs import SolveJob
from facemodel.project import Project


class Solving:
    """Ties a job to a document, for as long as somebody keeps it.

    Parameters
    ----------
    document : what is to be solved
    job : what solves it; belongs to nobody else
    """

    def __init__(self, document: Document, job: SolveJob) -> None:
        self.document = document
        self.job = job
        document.project_changed.connect(self._follow)
        job.finished.connect(document.accept)

    @property
    def wanted(self) -> bool:
        """Whether the document has to be solved and nothing is under way."""
        return self.document.stale and not self.job.running

    def solve(self) -> None:
        """Solve the document as it is now."""
        self.job.request(self.document.project)

    def cancel(self) -> None:
        """Stop solving; the last good face stays."""
        self.job.cancel()

    def _follow(self, project: Project) -> None:
        if self.document.stale:
            self.job.request(project)
        else:
            self.job.cancel()

"""Keep a document solved: whatever makes its solution stale starts a solve, and the result goes home."""

from __future__ import annotations

from app.document import Document
from app.jobs import SolveJob
from app.solved import same_fields
from facemodel.cache import cached_solution, keep_solution
from facemodel.face import Face
from facemodel.project import Project
from facemodel.solution import Progress, Solution, silent
from facemodel.solver import FaceSolver, Work


class EditingSolve:
    """Solves for an editing session: the first time from the cache on the disk, from then on what an edit touches.

    What is solved the first time for a head is kept on the disk, so that it opens at once the next time; edits are
    not, since one entry is far larger than the project.  The second solve of a head begins the living solver even if
    the first one came from the disk.  It belongs to one worker thread.
    """

    def __init__(self) -> None:
        self._solver = FaceSolver()
        self._opened: Face | None = None

    @property
    def work(self) -> Work:
        """What the last solve of the living solver had to do."""
        return self._solver.work

    def __call__(self, project: Project, progress: Progress = silent) -> Solution:
        """Solve a snapshot.

        Raises
        ------
        FaceError, Cancelled
            As `facemodel.solver.FaceSolver.solve` does.
        """
        if self._opened is not None and self._opened.skin is project.face.skin:
            return self._solver.solve(project, progress)
        kept = cached_solution(project)
        if kept is not None:
            progress(f"Read {len(kept.basis.names)} fields from the cache", 1.0)
        else:
            kept = self._solver.solve(project, progress)
            keep_solution(project, kept)
        self._opened = project.face
        return kept


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
        self._asked: Project | None = None
        self._prepared: Face | None = None
        document.history_changed.connect(self._follow)
        job.finished.connect(document.accept)

    @property
    def wanted(self) -> bool:
        """Whether the document has to be solved and nothing is under way."""
        return self.document.stale and not self.job.running

    def solve(self) -> None:
        """Solve the document as it is now."""
        self._asked = self.document.project
        self.job.request(self._asked)

    def prepare(self) -> None:
        """Solve once more what came from the disk, so that the first edit is as quick as all others.

        Nothing if that was done for this head, or a solve is under way.
        """
        face = self.document.project.face
        if not self.job.running and (self._prepared is None or self._prepared.skin is not face.skin):
            self._prepared = face
            self.solve()

    def cancel(self) -> None:
        """Stop solving; the last good face stays."""
        self.job.cancel()

    def _follow(self) -> None:
        """After every step: solve if it made the solution stale, stop if it holds again; poses change nothing."""
        if not self.document.stale:
            self.job.cancel()
            self._asked = None
        elif self._asked is None or not same_fields(self._asked, self.document.project):
            self.solve()

"""Read a skull from a file and lay it into the head, away from the window; then it can be fitted."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from psygnal import Signal

from app.authoring.skull import known_skull
from app.bone_reading import read_apart
from app.document import Document
from app.jobs import Deliver, Failure, Job
from app.skull_fitting import SkullFitting
from facemodel.errors import RisoriusError
from facemodel.project import Project
from facemodel.skull.mending import Bone
from facemodel.skull.registration import laid_on
from facemodel.solution import Progress
from fem.types import FloatArray


@dataclass(frozen=True, eq=False)
class Order:
    """Which file is to be read, for the head of which project."""

    path: Path
    project: Project


@dataclass(frozen=True, eq=False)
class Arrival:
    """What a file held, and how (4, 4) it is laid into the head at first."""

    bone: Bone
    way: FloatArray


def brought(order: Order, progress: Progress) -> Arrival:
    """Read a skull and lay it into a head; raises `ProjectError` if there is none in the file."""
    bone = read_apart(order.path, progress)
    progress("Laying it into the head", 0.9)
    return Arrival(bone, laid_on(bone.mesh, known_skull(order.project)))


class SkullImport:
    """Brings skulls to a fitting, one at a time.

    Parameters
    ----------
    document : for whose head
    fitting : where they are fitted
    """

    progress = Signal(str)
    """(text) what is being done; empty when it is over."""
    failed = Signal(str)
    """(sentence) why there is no skull."""

    def __init__(self, document: Document, fitting: SkullFitting) -> None:
        self._document, self._fitting = document, fitting
        self._job: Job[Order, Arrival] | None = None

    @property
    def running(self) -> bool:
        """Whether a file is being read."""
        return self._job is not None and self._job.running

    def read(self, path: Path, deliver: Deliver | None = None) -> None:
        """Read a file and begin to fit what is in it; in the background where calls can be delivered home."""
        self.stop()
        job = self._job = Job(brought, deliver)
        job.progress.connect(lambda text, _share: self.progress.emit(text))
        job.finished.connect(self._arrived)
        job.failed.connect(self._fail)
        self.progress.emit("Reading the file")
        job.request(Order(path, self._document.project))

    def stop(self) -> None:
        """Think better of it."""
        job, self._job = self._job, None
        if job is not None:
            job.close()
            self.progress.emit("")

    def _arrived(self, arrival: Arrival, order: Order) -> None:
        self.stop()
        try:
            self._fitting.begin(arrival.bone, order.path.name, self._document.project, arrival.way)
        except RisoriusError as error:
            self.failed.emit(str(error))

    def _fail(self, failure: Failure) -> None:
        self.stop()
        self.failed.emit(failure.sentence)

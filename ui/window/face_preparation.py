"""What a face needs before it can be drawn, computed away from the window's thread so that the window stays alive."""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import Future, ThreadPoolExecutor

from PySide6.QtCore import QObject

from facemodel.project import Project
from ui.viewport.look import look_of
from ui.viewport.scene import neutral_basis
from ui.window.delivery import UiThread


class FacePreparation(QObject):
    """Prepares one face at a time; only the latest one asked for is heard of.

    Both things that are prepared are remembered by those who make them, so `ui.viewport.scene.Scene.show` finds them.
    """

    def __init__(self, parent: QObject) -> None:
        super().__init__(parent)
        self._home = UiThread(self)
        self._worker = ThreadPoolExecutor(max_workers=1, thread_name_prefix="face")
        self._latest: Future[None] | None = None

    def prepare(self, project: Project, at_rest: bool, then: Callable[[], None]) -> None:
        """Compute how a face looks, and with ``at_rest`` its unsolved shape; call ``then`` in this thread."""
        job = self._worker.submit(_prepared, project, at_rest)
        self._latest = job
        job.add_done_callback(lambda done: self._home.deliver(lambda: self._settle(done, then)))

    def close(self) -> None:
        """Be heard of no more."""
        self._latest = None
        self._worker.shutdown(wait=True, cancel_futures=True)

    def _settle(self, job: Future[None], then: Callable[[], None]) -> None:
        if job is self._latest:
            self._latest = None
            job.result()
            then()


def _prepared(project: Project, at_rest: bool) -> None:
    look_of(project.face)
    if at_rest:
        neutral_basis(project)

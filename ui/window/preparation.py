"""Work that is done away from the window's thread, so that the window stays alive meanwhile."""

from __future__ import annotations

from collections.abc import Callable
from concurrent.futures import Future, ThreadPoolExecutor

from PySide6.QtCore import QObject

from ui.window.delivery import UiThread


class Preparation(QObject):
    """Does one piece of work after the other; only the latest one asked for is heard of."""

    def __init__(self) -> None:
        super().__init__()
        self._home = UiThread(self)
        self._worker = ThreadPoolExecutor(max_workers=1, thread_name_prefix="face")
        self._latest: Future[object] | None = None

    def begin(self, work: Callable[[], object]) -> None:
        """Do something that will be wanted soon and remembers its own result."""
        self._worker.submit(work)

    def prepare(self, work: Callable[[], object], then: Callable[[], None]) -> None:
        """Do something, and when it is done call ``then`` in the thread of the window."""
        job = self._worker.submit(work)
        self._latest = job
        job.add_done_callback(lambda done: self._home.deliver(lambda: self._settle(done, then)))

    def close(self) -> None:
        """Be heard of no more."""
        self._latest = None
        self._worker.shutdown(wait=True, cancel_futures=True)

    def _settle(self, job: Future[object], then: Callable[[], None]) -> None:
        if job is self._latest:
            self._latest = None
            job.result()
            then()

"""Work in the background, solving above all: progress, cancellation, and the latest request wins."""

from __future__ import annotations

import logging
import queue
import traceback
from collections.abc import Callable
from concurrent.futures import Future, ThreadPoolExecutor
from dataclasses import dataclass, field
from functools import partial
from threading import Event
from typing import Any, Generic, TypeVar

from psygnal import Signal

from facemodel.errors import RisoriusError
from facemodel.project import Project
from facemodel.solve import Cancelled, Progress, Solution

Asked = TypeVar("Asked")
Given = TypeVar("Given")

Work = Callable[[Asked, Progress], Given]
"""Works on a snapshot; it calls the progress between its phases and lets pass what that raises."""

Solve = Work[Project, Solution]
"""Solves a snapshot."""

Deliver = Callable[[Callable[[], None]], None]
"""Calls a function soon in the thread that owns the document.  It is called from other threads."""

log = logging.getLogger(__name__)


@dataclass(frozen=True)
class Failure:
    """Why there is no solution.

    Attributes
    ----------
    sentence : for the person at the screen
    details : the traceback for the log; empty where the sentence says it all
    """

    sentence: str
    details: str = ""


@dataclass(frozen=True, eq=False)
class _Request(Generic[Asked]):
    asked: Asked
    stopped: Event = field(default_factory=Event)


class Job(Generic[Asked, Given]):
    """Works on one snapshot at a time outside the thread that owns the document.

    A newer request stops the older one and drops its result.  All signals are emitted in the thread to which
    ``deliver`` brings them.  NumPy and SciPy release the interpreter while they work, so one thread is enough for
    the window to stay alive; snapshots and solutions are plain data, so that a process could take its place.

    Parameters
    ----------
    work : what is done to a snapshot
    deliver : brings a call to the owner's thread; without it `request` waits for the end and emits all signals
        itself, which is what a program without an event loop wants
    """

    started = Signal(object)
    """(what was asked for)"""
    progress = Signal(str, float)
    """(text, share from 0 to 1)"""
    finished = Signal(object, object)
    """(what came out, what was asked for)"""
    failed = Signal(object)
    """(Failure)"""
    cancelled = Signal()

    def __init__(self, work: Work[Asked, Given], deliver: Deliver | None = None) -> None:
        self._work = work
        self._inbox: queue.SimpleQueue[Callable[[], None]] = queue.SimpleQueue()
        self._waits = deliver is None
        self._deliver: Deliver = deliver or self._inbox.put
        self._worker = ThreadPoolExecutor(max_workers=1, thread_name_prefix="solve")
        self._current: _Request[Asked] | None = None
        self._future: Future[Given] | None = None

    @property
    def running(self) -> bool:
        """Whether a result is still to come."""
        return self._current is not None

    def request(self, asked: Asked) -> None:
        """Work on a snapshot; an older request is stopped and heard of no more."""
        self._stop()
        request = _Request(asked)
        self._current = request
        self.started.emit(asked)
        if self._current is not request:
            return
        self._future = self._worker.submit(self._work, asked, partial(self._report, request))
        self._future.add_done_callback(partial(self._done, request))
        while self._waits and self._current is request:
            self._inbox.get()()

    def cancel(self) -> None:
        """Stop; `cancelled` is emitted at once, and the solver ends before its next phase."""
        if self._current is not None:
            self._stop()
            self.cancelled.emit()

    def close(self) -> None:
        """Stop for good and say nothing more; a phase that is running ends by itself."""
        self._stop()
        self._worker.shutdown(wait=False, cancel_futures=True)

    def _stop(self) -> None:
        request, self._current = self._current, None
        if request is not None:
            request.stopped.set()
        if self._future is not None:
            self._future.cancel()

    def _report(self, request: _Request[Asked], text: str, share: float) -> None:
        """In the worker: pass progress on, or end a solve that nobody waits for."""
        if request.stopped.is_set():
            raise Cancelled
        self._deliver(partial(self._tell, request, text, share))

    def _done(self, request: _Request[Asked], future: Future[Given]) -> None:
        """In the worker: bring the outcome home, if anybody is there to hear it."""
        if request.stopped.is_set():
            _note_unheard(future)
        else:
            self._deliver(partial(self._settle, request, future))

    def _tell(self, request: _Request[Asked], text: str, share: float) -> None:
        if request is self._current:
            self.progress.emit(text, share)

    def _settle(self, request: _Request[Asked], future: Future[Given]) -> None:
        if request is not self._current:
            _note_unheard(future)
            return
        self._current = None
        error = future.exception()
        if error is None:
            self.finished.emit(future.result(), request.asked)
        elif isinstance(error, Cancelled):
            self.cancelled.emit()
        else:
            self.failed.emit(_failure(error))


SolveJob = Job[Project, Solution]
"""Solves projects."""


def _note_unheard(future: Future[Any]) -> None:
    """Log the failure of a solve that was stopped; that it was stopped is no failure."""
    error = None if future.cancelled() else future.exception()
    if error is not None and not isinstance(error, Cancelled):
        log.warning("A solve that nobody waited for failed.", exc_info=error)


def _failure(error: BaseException) -> Failure:
    if isinstance(error, RisoriusError):
        return Failure(str(error))
    if isinstance(error, MemoryError):
        sentence = "There is not enough memory to solve this face; close other programs and solve again."
    else:
        sentence = "Solving failed for a reason that is not foreseen; the log says more. Please report it."
    return Failure(sentence, "".join(traceback.format_exception(error)))

"""Keep the open document safe while it is worked on: its last state is in a journal seconds after every step."""

from __future__ import annotations

import time
from dataclasses import dataclass
from datetime import datetime
from functools import partial
from pathlib import Path
from threading import Condition, Thread

from psygnal import Signal

from app.document import Document
from app.jobs import Deliver
from app.journal import Journal, Note, Recoverable, forget, journal_folder, read_back, recoverable
from facemodel.errors import ProjectError
from facemodel.project import Project

DELAY = 1.0
"""Seconds from a step to its journal: steps in quick succession are written once, and no more than these are lost."""

LAST_WRITE = 10.0
"""Seconds that the end of the program waits for a write that is under way."""


@dataclass(frozen=True, eq=False)
class _State:
    """What is to be kept; no project if there is nothing to lose."""

    project: Project | None
    note: Note


class Autosave:
    """Writes the journal of a document in a thread of its own, for as long as it has changes that are not saved.

    Parameters
    ----------
    document : what is kept safe
    deliver : brings a call to the thread that owns the document, see `app.jobs`
    folder : of the journals; the one beside the preferences if not given
    delay : seconds from a step to its journal
    """

    written = Signal(object)
    """(datetime) the last state is in the journal."""
    failed = Signal(str)
    """(sentence) it cannot be written; said once until it can again."""

    def __init__(self, document: Document, deliver: Deliver, folder: Path | None = None, delay: float = DELAY) -> None:
        self._document, self._deliver, self._delay = document, deliver, delay
        self._folder = folder or journal_folder()
        self._journal = Journal(self._folder)
        self._changed = Condition()
        self._due: _State | None = None
        self._ends = False
        self._complained = False
        self._thread = Thread(target=self._work, name="journal", daemon=True)
        document.history_changed.connect(self._follow)
        document.saved_changed.connect(self._follow)
        self._thread.start()

    def recoverable(self) -> tuple[Recoverable, ...]:
        """What other sessions have left that were killed, the latest first."""
        return recoverable(self._folder)

    def accept(self, entry: Recoverable) -> None:
        """Go on with what a killed session has left; it is in this session's journal before it leaves the other.

        Raises
        ------
        ProjectError
            If it is damaged, or cannot be kept here.
        """
        project = read_back(entry)
        self._document.restore(project, entry.path)
        self._journal.write(project, self._note())
        forget(entry)

    def decline(self, entry: Recoverable) -> None:
        """Remove what a killed session has left."""
        forget(entry)

    def close(self) -> None:
        """End with the program: what is not saved by now is not wanted."""
        self._document.history_changed.disconnect(self._follow)
        self._document.saved_changed.disconnect(self._follow)
        with self._changed:
            self._ends = True
            self._changed.notify()
        self._thread.join(LAST_WRITE)
        self._journal.clear()

    def _follow(self) -> None:
        project = self._document.project if self._document.dirty else None
        with self._changed:
            self._due = _State(project, self._note())
            self._changed.notify()

    def _note(self) -> Note:
        return Note(name=self._document.name, path=self._document.path, when=time.time())

    def _work(self) -> None:
        """In the thread: wait for a step, let others come, and write the last of them."""
        while True:
            with self._changed:
                self._changed.wait_for(lambda: self._ends or self._due is not None)
                self._changed.wait_for(lambda: self._ends or self._nothing_to_lose(), self._delay)
                if self._ends:
                    return
                state, self._due = self._due, None
            if state is not None:
                self._keep(state)

    def _nothing_to_lose(self) -> bool:
        return self._due is not None and self._due.project is None

    def _keep(self, state: _State) -> None:
        if state.project is None:
            self._journal.clear()
            return
        try:
            self._journal.write(state.project, state.note)
        except ProjectError as error:
            if not self._complained:
                self._deliver(partial(self.failed.emit, str(error)))
            self._complained = True
            return
        self._complained = False
        self._deliver(partial(self.written.emit, datetime.fromtimestamp(state.note.when)))

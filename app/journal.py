"""The journal of a session on the disk: the last state of the document, for the case that the process is killed."""

from __future__ import annotations

import secrets
import time
from contextlib import suppress
from dataclasses import dataclass
from datetime import datetime
from pathlib import Path
from threading import Lock

from pydantic import BaseModel, ConfigDict, ValidationError

from app.preferences import preferences_path
from app.session_lock import SessionLock, is_locked
from facemodel.errors import ProjectError
from facemodel.io.disk import read_file, replacing
from facemodel.io.project_file import load_project, save_project
from facemodel.project import Project

PROJECT, NOTE, LOCK, DAMAGED = ".risorius", ".json", ".lock", ".damaged"

LARGEST_NOTE = 2**16
"""Bytes; a note takes two hundred."""


class Note(BaseModel):
    """What a person has to know of a project that can be brought back.

    Attributes
    ----------
    name : of the document
    path : the file it belongs to, if it had one
    when : seconds since 1970
    """

    model_config = ConfigDict(frozen=True, extra="ignore")

    name: str
    path: Path | None = None
    when: float


@dataclass(frozen=True)
class Recoverable:
    """A project that can be brought back.

    Attributes
    ----------
    stem : path of its files in the journal's folder, without ending
    name : of the document
    path : the file it belongs to, if it had one
    when : the time of its last state
    """

    stem: Path
    name: str
    path: Path | None
    when: datetime


def journal_folder() -> Path:
    """Where journals are kept: beside the preferences."""
    return preferences_path().parent / "journal"


class Journal:
    """The journal of one session; it makes no file before there is something to keep.  Any thread may use it.

    Parameters
    ----------
    folder : of all journals
    """

    def __init__(self, folder: Path) -> None:
        self._stem = folder / f"{time.strftime('%Y%m%d-%H%M%S')}-{secrets.token_hex(4)}"
        self._lock: SessionLock | None = None
        self._guard = Lock()

    def write(self, project: Project, note: Note) -> None:
        """Keep a state of the document in place of the last one.

        Raises
        ------
        ProjectError
            If it cannot be written; the last state stays.
        """
        with self._guard:
            self._claim()
            save_project(project, _with(self._stem, PROJECT))
            with replacing(_with(self._stem, NOTE)) as stream:
                stream.write(note.model_dump_json().encode())

    def clear(self) -> None:
        """Forget what is kept: it is saved, or not wanted."""
        with self._guard:
            _remove(self._stem)
            if self._lock is not None:
                self._lock.release()
                self._lock = None

    def _claim(self) -> None:
        if self._lock is not None:
            return
        try:
            self._stem.parent.mkdir(parents=True, exist_ok=True)
            self._lock = SessionLock(_with(self._stem, LOCK))
        except OSError as error:
            raise ProjectError(
                f"Changes cannot be kept safe in “{self._stem.parent}” ({error}); allow writing there, or save often."
            ) from error


def recoverable(folder: Path) -> tuple[Recoverable, ...]:
    """What sessions have left that did not end by themselves, the latest first; never an error.

    Sessions that still live are left out, and so is what is damaged beyond reading.
    """
    try:
        # A name that begins with a dot is that of a file a living session is writing at this moment.
        stems = sorted(path.with_suffix("") for path in folder.glob(f"[!.]*{PROJECT}"))
        found = [_entry(stem) for stem in stems if not is_locked(_with(stem, LOCK))]
    except OSError:
        return ()
    return tuple(sorted(found, key=lambda entry: entry.when, reverse=True))


def read_back(entry: Recoverable) -> Project:
    """The last state of a session.

    Raises
    ------
    ProjectError
        If it is damaged; it is then set aside as ``.damaged`` and offered no more.
    """
    try:
        return load_project(_with(entry.stem, PROJECT))
    except ProjectError as error:
        aside = _with(entry.stem, DAMAGED)
        with suppress(OSError):
            _with(entry.stem, PROJECT).replace(aside)
        forget(entry)
        raise ProjectError(
            f"“{entry.name}” cannot be brought back, since its journal is damaged; what is left of it is “{aside}”."
        ) from error


def forget(entry: Recoverable) -> None:
    """Remove what a session has left."""
    _remove(entry.stem)
    with suppress(OSError):
        _with(entry.stem, LOCK).unlink(missing_ok=True)


def _entry(stem: Path) -> Recoverable:
    try:
        note = Note.model_validate_json(read_file(_with(stem, NOTE), LARGEST_NOTE))
        return Recoverable(stem, note.name, note.path, datetime.fromtimestamp(note.when))
    except (ValidationError, ProjectError, OverflowError, OSError, ValueError):
        written = _with(stem, PROJECT).stat().st_mtime
        return Recoverable(stem, "A project without a name", None, datetime.fromtimestamp(written))


def _remove(stem: Path) -> None:
    for ending in (PROJECT, NOTE):
        with suppress(OSError):
            _with(stem, ending).unlink(missing_ok=True)


def _with(stem: Path, ending: str) -> Path:
    return stem.with_name(stem.name + ending)

"""What is worked on outlives the process; what is saved or thrown away leaves nothing behind."""

import os
import queue
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from app.autosave import Autosave
from app.differences import same_content
from app.document import Document
from app.journal import Journal, Note, journal_folder, read_back, recoverable
from app.preferences import preferences_path
from facemodel.errors import ProjectError
from facemodel.io.disk import replacing
from facemodel.project import Project

PATIENCE = 60.0
"""Seconds after which a test gives up."""


class Desk:
    """A document with its journal, and the thread that owns them."""

    def __init__(self, document: Document, folder: Path) -> None:
        self.inbox: queue.Queue[Callable[[], None]] = queue.Queue()
        self.document = document
        self.autosave = Autosave(document, self.inbox.put, folder, delay=0.01)
        self.failures: list[str] = []
        self.autosave.failed.connect(self.failures.append)

    def wait(self) -> None:
        """Hear of the next journal that is written, or of a failure."""
        self.inbox.get(timeout=PATIENCE)()


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    return tmp_path / "journal"


@pytest.fixture
def desk(document: Document, folder: Path) -> Iterator[Desk]:
    desk = Desk(document, folder)
    yield desk
    desk.autosave.close()


def left_by_a_crash(folder: Path, project: Project, name: str = "Portrait", when: float = 1.7e9) -> Journal:
    """Write a journal as a process does that is killed right after."""
    journal = Journal(folder)
    journal.write(project, Note(name=name, path=folder / f"{name}.risorius", when=when))
    assert journal._lock is not None
    journal._lock.release(remove=False)
    return journal


def eventually(holds: Callable[[], bool]) -> bool:
    end = time.monotonic() + PATIENCE
    while not holds() and time.monotonic() < end:
        time.sleep(0.005)
    return holds()


def test_a_killed_session_can_be_brought_back_as_it_was_last(repository: Path, folder: Path) -> None:
    command = [sys.executable, "-m", "tests.app.session_to_kill", str(folder)]
    environment = {**os.environ, "PYTHONPATH": str(repository)}
    with subprocess.Popen(command, cwd=repository, env=environment, stdout=subprocess.PIPE, text=True) as session:
        assert session.stdout is not None
        for _ in range(5):
            said = float(session.stdout.readline())
        assert recoverable(folder) == ()
        session.kill()
        rest = session.stdout.read()
    (entry,) = recoverable(folder)
    assert entry.name == "Untitled, Patch"
    last_heard = [said, *map(float, rest.split())][-1]
    assert entry.when.timestamp() >= last_heard
    project = read_back(entry)
    assert project.expression["17"] in {step / 200 for step in range(1, 201)}
    assert len(project.muscles) == 2


def test_every_step_is_in_the_journal_soon_and_gone_when_it_is_saved(desk: Desk, folder: Path, file: Path) -> None:
    assert not folder.exists()
    desk.document.set_weights({"17": 0.5})
    desk.wait()
    assert list(folder.glob("*.risorius"))
    desk.document.save(file)
    assert eventually(lambda: not list(folder.iterdir()))


def test_going_back_to_what_is_saved_leaves_nothing(desk: Desk, folder: Path) -> None:
    desk.document.set_weights({"17": 0.5})
    desk.wait()
    desk.document.undo()
    assert eventually(lambda: not list(folder.iterdir()))


def test_closing_leaves_nothing(desk: Desk, folder: Path) -> None:
    desk.document.set_weights({"17": 0.5})
    desk.wait()
    desk.autosave.close()
    assert not list(folder.iterdir())


def test_a_living_session_is_not_offered_to_another(desk: Desk, folder: Path) -> None:
    desk.document.set_weights({"17": 0.5})
    desk.wait()
    assert recoverable(folder) == ()


def test_a_state_that_is_just_being_written_is_not_offered(folder: Path) -> None:
    folder.mkdir()
    with replacing(folder / "20260101-120000-abcdef12.risorius") as stream:
        stream.write(b"half of it")
        stream.flush()
        assert list(folder.iterdir())
        assert recoverable(folder) == ()


def test_what_is_accepted_is_open_unsaved_and_safe_in_the_new_journal(
    desk: Desk, folder: Path, project: Project
) -> None:
    lost = project.posed({"12L": 0.25})
    left_by_a_crash(folder, lost)
    (entry,) = desk.autosave.recoverable()
    assert (entry.name, entry.when.timestamp()) == ("Portrait", 1.7e9)
    desk.autosave.accept(entry)
    assert same_content(desk.document.project, lost)
    assert desk.document.path == folder / "Portrait.risorius"
    assert desk.document.dirty
    assert desk.autosave.recoverable() == ()
    assert len(list(folder.glob("[!.]*.risorius"))) == 1
    desk.document.undo()
    assert desk.document.dirty


def test_what_is_declined_is_gone(desk: Desk, folder: Path, project: Project) -> None:
    left_by_a_crash(folder, project)
    desk.autosave.decline(*desk.autosave.recoverable())
    assert not list(folder.iterdir())


def test_the_latest_is_offered_first(folder: Path, project: Project) -> None:
    for name, when in (("old", 1.6e9), ("new", 1.7e9), ("older", 1.5e9)):
        left_by_a_crash(folder, project, name, when)
    assert [entry.name for entry in recoverable(folder)] == ["new", "old", "older"]


@pytest.mark.parametrize("note", [b"", b"{", b'{"name": 3}', b'{"name": "x", "when": 1e300}', b"\xff" * 100_000, None])
def test_a_damaged_note_costs_the_name_and_nothing_else(folder: Path, project: Project, note: bytes | None) -> None:
    left_by_a_crash(folder, project)
    (path,) = folder.glob("*.json")
    if note is None:
        path.unlink()
    else:
        path.write_bytes(note)
    (entry,) = recoverable(folder)
    assert same_content(read_back(entry), project)


@pytest.mark.parametrize("kept", [0, 10, 1000])
def test_a_damaged_journal_is_set_aside_and_said_once(desk: Desk, folder: Path, project: Project, kept: int) -> None:
    left_by_a_crash(folder, project)
    (path,) = folder.glob("*.risorius")
    path.write_bytes(path.read_bytes()[:kept])
    (entry,) = desk.autosave.recoverable()
    before = desk.document.project
    with pytest.raises(ProjectError, match="Portrait"):
        desk.autosave.accept(entry)
    assert desk.document.project is before
    assert desk.autosave.recoverable() == ()
    assert [each.suffix for each in folder.iterdir()] == [".damaged"]


def test_a_folder_that_is_none_stops_nobody(document: Document, tmp_path: Path) -> None:
    blocked = tmp_path / "file"
    blocked.write_text("not a folder")
    desk = Desk(document, blocked / "journal")
    assert desk.autosave.recoverable() == ()
    for weight in (0.1, 0.2):
        document.set_weights({"17": weight})
    desk.wait()
    desk.autosave.close()
    assert len(desk.failures) == 1
    assert "journal" in desk.failures[0]


def test_the_journal_lies_beside_the_preferences() -> None:
    assert journal_folder().parent == preferences_path().parent

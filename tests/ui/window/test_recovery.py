"""Unsaved work outlives a killed editor, and the next one offers it in one question."""

import os
import subprocess
import sys
from collections.abc import Callable
from pathlib import Path

import pytest
from PySide6.QtCore import Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QMessageBox, QPushButton

from app.document import Document
from app.journal import Journal, Note, journal_folder, recoverable
from facemodel.project import Project
from tests.ui.hands import drag
from ui.window.main_window import MainWindow
from ui.window.recovery_offer import RecoveryOffer
from ui.window.safekeeping import Safekeeping

LEFT = Qt.MouseButton.LeftButton


@pytest.fixture
def folder(tmp_path: Path) -> Path:
    return tmp_path / "journal"


@pytest.fixture
def next_start(qtbot, window: MainWindow, folder: Path) -> Callable[[], RecoveryOffer]:
    """Start on the journals that are there; what is offered."""

    def start(journals: Path = folder) -> RecoveryOffer:
        Safekeeping(window, journals).offer_soon()
        qtbot.waitUntil(lambda: window.findChild(RecoveryOffer) is not None)
        offer = window.findChild(RecoveryOffer)
        qtbot.waitUntil(offer.isVisible)
        return offer

    return start


def press(button: QPushButton) -> None:
    QTest.mouseClick(button, LEFT)


def left_by_a_crash(folder: Path, project: Project, name: str, when: float = 1.7e9) -> Path:
    """Write a journal as a process does that is killed right after."""
    before = set(folder.glob("*.risorius"))
    journal = Journal(folder)
    journal.write(project, Note(name=name, path=None, when=when))
    journal._lock.release(remove=False)
    (made,) = set(folder.glob("*.risorius")) - before
    return made


def test_a_killed_editor_loses_nothing(
    repository: Path, tmp_path: Path, document: Document, next_start: Callable[..., RecoveryOffer], monkeypatch
) -> None:
    monkeypatch.setenv("RISORIUS_CONFIG", str(tmp_path / "theirs"))
    environment = {**os.environ, "PYTHONPATH": str(repository)}
    command = [sys.executable, "-m", "tests.ui.window.editor_to_kill"]
    with subprocess.Popen(command, cwd=repository, env=environment, stdout=subprocess.PIPE, text=True) as editor:
        said = editor.stdout.readline()
        editor.kill()
    assert said.startswith("autosaved ")
    weight = float(said.split()[-1])
    offer = next_start(journal_folder())
    assert "Untitled" in offer.list.item(0).text()
    press(offer.bring_back)
    assert document.project.expression["17"] == weight > 0
    assert document.dirty


def test_unsaved_work_is_kept_and_leaves_with_saving(qtbot, window, document, folder, tmp_path) -> None:
    Safekeeping(window, folder)
    drag(window.expression.rows[17].slider, 0.0, 0.5)
    qtbot.waitUntil(window.status.kept.isVisible)
    assert len(list(folder.glob("*.risorius"))) == 1
    document.save(tmp_path / "kept.risorius")
    assert not window.status.kept.isVisible()
    qtbot.waitUntil(lambda: not list(folder.iterdir()))


def test_leaving_by_a_clean_close_leaves_nothing(qtbot, window, folder, answer) -> None:
    Safekeeping(window, folder)
    drag(window.expression.rows[17].slider, 0.0, 0.5)
    qtbot.waitUntil(window.status.kept.isVisible)
    answer(QMessageBox.StandardButton.Discard)
    assert window.close()
    assert list(folder.iterdir()) == []


def test_where_nothing_can_be_kept_it_is_said(qtbot, window, tmp_path) -> None:
    (tmp_path / "file").write_text("no folder")
    Safekeeping(window, tmp_path / "file" / "journal")
    drag(window.expression.rows[17].slider, 0.0, 0.5)
    qtbot.waitUntil(lambda: window.status.kept.text() == "not autosaved")


def test_nothing_left_nothing_asked(qtbot, window, folder) -> None:
    Safekeeping(window, folder).offer_soon()
    QTest.qWait(50)
    assert window.findChild(RecoveryOffer) is None


def test_one_of_several_comes_back_and_one_is_discarded(project, document, folder, next_start) -> None:
    for number, name in enumerate(("oldest", "middle", "latest")):
        left_by_a_crash(folder, project.posed({"17": 0.1 * (number + 1)}), name, 1.7e9 + number)
    offer = next_start()
    assert [offer.list.item(row).text().split()[0] for row in range(3)] == ["latest", "middle", "oldest"]
    press(offer.discard)
    press(offer.bring_back)
    assert document.project.expression["17"] == pytest.approx(0.2)
    assert [entry.name for entry in recoverable(folder)] == ["oldest"]


def test_later_asks_again(window, project, document, folder, next_start) -> None:
    left = left_by_a_crash(folder, project, "portrait")
    before = document.project
    QTest.keyClick(next_start(), Qt.Key.Key_Escape)
    assert document.project is before
    assert left.exists()


def test_a_damaged_journal_is_one_sentence(project, document, folder, next_start, answer) -> None:
    left = left_by_a_crash(folder, project, "portrait")
    left.write_bytes(left.read_bytes()[:1000])
    before = document.project
    offer = next_start()
    said = answer(QMessageBox.StandardButton.Ok)
    press(offer.bring_back)
    assert "portrait" in said[0]
    assert document.project is before


def test_what_was_begun_meanwhile_is_asked_for_first(window, project, document, folder, next_start, answer) -> None:
    left = left_by_a_crash(folder, project.posed({"12L": 0.5}), "portrait")
    offer = next_start()
    document.set_weights({"17": 0.4})
    said = answer(QMessageBox.StandardButton.Cancel)
    press(offer.bring_back)
    assert "Untitled" in said[0]
    assert document.shown["17"] == 0.4
    assert left.exists()

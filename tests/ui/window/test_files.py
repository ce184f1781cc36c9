"""Files, and the questions that go with them."""

import numpy as np
import pytest
from PIL import Image
from PySide6.QtCore import QMimeData, QPoint, QPointF, Qt, QTimer, QUrl
from PySide6.QtGui import QDragEnterEvent, QDropEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QFileDialog, QLabel, QMessageBox

from facemodel.animation.sound import Sound
from facemodel.io.audio import write_sound
from facemodel.io.project_file import load_project, save_project
from tests.ui.hands import drag
from tests.ui.window.seen import differs, picture
from ui.window.main_window import MainWindow

Button = QMessageBox.StandardButton
CTRL, SHIFT = Qt.KeyboardModifier.ControlModifier, Qt.KeyboardModifier.ShiftModifier
SMILE = 12


def drop(window: MainWindow, path) -> bool:
    """Drop a file on the window; whether it was welcome."""
    data = QMimeData()
    data.setUrls([QUrl.fromLocalFile(str(path))])
    place, copy = QPoint(300, 300), Qt.DropAction.CopyAction
    left, none = Qt.MouseButton.LeftButton, Qt.KeyboardModifier.NoModifier
    enter = QDragEnterEvent(place, copy, data, left, none)
    enter.setAccepted(False)
    QApplication.sendEvent(window, enter)
    if enter.isAccepted():
        QApplication.sendEvent(window, QDropEvent(QPointF(place), copy, data, left, none))
    return enter.isAccepted()


@pytest.fixture
def file(tmp_path, project):
    path = tmp_path / "smile.risorius"
    save_project(project.posed({"12L": 0.5, "12R": 0.5}), path)
    return path


def test_saving_and_opening_is_a_round_trip(window, document, tmp_path, monkeypatch):
    target = tmp_path / "made"
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (str(target), ""))
    drag(window.expression.rows[17].slider, 0.0, 0.5)
    assert window.isWindowModified()
    QTest.keyClick(window, Qt.Key.Key_S, CTRL)
    saved = target.with_suffix(".risorius")
    assert load_project(saved).expression == document.project.expression
    assert not window.isWindowModified()
    assert window.windowTitle().startswith("made[*]")

    document.reset_expression()
    document.save()
    monkeypatch.setattr(QFileDialog, "getOpenFileName", lambda *_: (str(saved), ""))
    QTest.keyClick(window, Qt.Key.Key_O, CTRL)
    assert document.path == saved


def test_a_dropped_project_is_opened_and_recent(window, document, file):
    assert drop(window, file)
    assert document.path == file
    assert window.expression.rows[SMILE].slider.weight == 0.5
    assert window.context.settings.preferences.recent == (file,)
    QApplication.processEvents()
    assert any(action.id == "file.recent.0" for action in window.binding.actions)


def test_a_dropped_sound_plays_along_from_the_playhead_on(window, document, tmp_path, qtbot):
    file = tmp_path / "Line.WAV"
    write_sound(Sound(np.zeros((4000, 1), np.float32), 8000), file)
    window.span.timeline.playhead.go(0.5)
    assert drop(window, file)
    qtbot.waitUntil(lambda: document.project.animation.audio is not None)
    assert document.project.animation.audio.start == 0.5
    document.undo()
    assert document.project.animation.audio is None


def test_a_dropped_table_of_phonemes_is_said(window, document, tmp_path, qtbot):
    file = tmp_path / "line.tsv"
    file.write_text("0.00\tX\n0.10\tA\n0.30\tX\n")
    assert drop(window, file)
    qtbot.waitUntil(lambda: len(document.project.animation.speech.phonemes) > 0)


def test_anything_else_is_not_welcome(window, document, tmp_path):
    assert not drop(window, tmp_path / "picture.png")
    assert document.path is None


def test_a_damaged_file_is_one_sentence_and_the_document_stays(window, document, tmp_path, answer):
    damaged = tmp_path / "damaged.risorius"
    damaged.write_bytes(b"not a project")
    drag(window.expression.rows[17].slider, 0.0, 0.5)
    before = document.project
    said = answer(Button.Discard, Button.Ok)
    drop(window, damaged)
    assert "damaged.risorius" in said[-1]
    assert document.project is before


@pytest.mark.parametrize(("button", "closed", "dirty"), [(Button.Cancel, False, True), (Button.Discard, True, True)])
def test_closing_asks_about_unsaved_changes(window, document, answer, button, closed, dirty):
    drag(window.expression.rows[17].slider, 0.0, 0.5)
    said = answer(button)
    assert window.close() is closed
    assert len(said) == 1
    assert document.dirty is dirty


def test_saving_when_asked_saves_and_closes(window, document, answer, tmp_path, monkeypatch):
    target = tmp_path / "kept.risorius"
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (str(target), ""))
    drag(window.expression.rows[17].slider, 0.0, 0.5)
    answer(Button.Save)
    assert window.close()
    assert load_project(target).expression == {"17": document.shown["17"]}


def test_closing_without_changes_asks_nothing(window, answer):
    said = answer()
    assert window.close()
    assert said == []


def test_new_asks_too_and_cancel_keeps_the_document(window, document, answer):
    drag(window.expression.rows[17].slider, 0.0, 0.5)
    before = document.project
    answer(Button.Cancel)
    QTest.keyClick(window, Qt.Key.Key_N, CTRL)
    assert document.project is before


def test_a_picture_has_what_is_seen(window, tmp_path, monkeypatch):
    target = tmp_path / "seen.png"
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (str(target), ""))
    seen = picture(window)
    QTest.keyClick(window, Qt.Key.Key_F12)
    assert not differs(np.asarray(Image.open(target).convert("RGB")).astype(int), seen)


def test_a_picture_that_cannot_be_written_is_one_sentence(window, tmp_path, monkeypatch, answer):
    monkeypatch.setattr(QFileDialog, "getSaveFileName", lambda *_: (str(tmp_path / "no" / "seen.png"), ""))
    said = answer(Button.Ok)
    window.binding.perform("file.screenshot")
    assert "seen.png" in said[0]


def test_it_shows_chart_and_solution(window, document):
    QTest.keyClick(window, Qt.Key.Key_I, CTRL)
    words = {label.text() for label in window.docks["information"].findChildren(QLabel)}
    assert f"{document.solution.chart.worst:.2f}" in words
    assert document.project.face.title in words
    assert document.project.face.provenance in words


def test_what_an_error_names_is_shown_as_it_is_written(window, qtbot):
    shown = []

    def look():
        box = QApplication.activeModalWidget()
        shown.append(box.textFormat())
        box.button(Button.Ok).click()

    QTimer.singleShot(50, look)
    window.context.host.show_error("“<b>smile</b>.risorius” cannot be opened.")
    assert shown == [Qt.TextFormat.PlainText]

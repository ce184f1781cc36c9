"""The export page asks for no more than a format needs, exports while work goes on, and can be cancelled."""

import os
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path

import av
import pytest
from PySide6.QtCore import Qt
from PySide6.QtWidgets import QComboBox, QMessageBox
from pytestqt.qtbot import QtBot

from app.document import Document
from facemodel.animation.clip import STILL, Animation, NamedRange
from facemodel.animation.curve import Key, curve_of
from facemodel.animation.track import Track
from tests.io.glb_reader import Glb
from ui.panels.export.page import ExportPage
from ui.window.main_window import MainWindow

SMILE = Animation(
    (Track("12L", curve_of([Key(0, 0.0), Key(1, 1.0)])),), rate=12.0, end=1.0, ranges=(NamedRange("laugh", 0.25, 0.5),)
)


@pytest.fixture
def page(window: MainWindow, document: Document, qtbot: QtBot, tmp_path: Path) -> Iterator[ExportPage]:
    document.edit(replace(document.project, animation=SMILE), "Animate")
    window.context.host.show_export()
    found = window.findChild(ExportPage)
    qtbot.waitUntil(found.isVisible)
    found.place.setText(str(tmp_path / "smile.mp4"))
    yield found
    found.job.cancel()


def pick(box: QComboBox, key: str) -> None:
    """Choose as a hand does."""
    box.setCurrentIndex(box.findData(key))
    box.activated.emit(box.currentIndex())


def exported(folder: Path) -> list[str]:
    """All that is in a folder, half-written files too, but for what the editor itself keeps there."""
    return sorted(name for name in os.listdir(folder) if name != "preferences.json")


def click(qtbot: QtBot, button: object) -> None:
    qtbot.mouseClick(button, Qt.MouseButton.LeftButton)


def finished(page: ExportPage, qtbot: QtBot) -> str:
    qtbot.waitUntil(lambda: not page.job.running)
    return page.progress.text.text()


def test_each_format_shows_what_can_be_asked_of_it(page: ExportPage) -> None:
    shown = {}
    for suffix in (".mp4", ".glb", ".obj"):
        pick(page.kind, suffix)
        shown[suffix] = (page.film.isVisible(), page.model.isVisible())
        assert page.place.text().endswith(f"smile{suffix}")
    assert shown == {".mp4": (True, False), ".glb": (False, True), ".obj": (False, False)}


def test_a_film_comes_as_it_was_asked_for(page: ExportPage, qtbot: QtBot, tmp_path: Path) -> None:
    pick(page.frames.range, "range laugh")
    for bar, side in ((page.film.wide, 64.0), (page.film.high, 48.0)):
        bar.set_now(side)
    assert page.film.size_choice.currentData() == "own"
    assert page.progress.text.text() == "3 frames, 0.25 s"
    click(qtbot, page.export)
    assert not page.frames.isEnabled()
    assert page.stop.isVisible()
    assert finished(page, qtbot) == "Exported smile.mp4: 3 frames, 0.25 s."
    with av.open(str(tmp_path / "smile.mp4")) as opened:
        stream = opened.streams.video[0]
        assert (stream.width, stream.height, stream.frames) == (64, 48, 3)
    assert page.frames.isEnabled()


def test_a_model_comes_with_the_shapes_that_were_asked_for(page: ExportPage, qtbot: QtBot, tmp_path: Path) -> None:
    pick(page.kind, ".glb")
    pick(page.model.shaping, "clip")
    page.model.most.set_now(3)
    click(qtbot, page.export)
    assert "of the editor" in finished(page, qtbot)
    file = Glb((tmp_path / "smile.glb").read_bytes())
    assert len(file.times) == 13
    assert len(file.meshes["skin"]["extras"]["targetNames"]) <= 3


@pytest.mark.parametrize(("key", "begins"), [("live-link", "Timecode,BlendShapeCount,"), ("fap", "2.1 ")])
def test_weights_come_in_the_formats_of_other_programs(
    page: ExportPage, qtbot: QtBot, tmp_path: Path, key: str, begins: str
) -> None:
    pick(page.kind, key)
    assert not page.film.isVisible()
    assert not page.model.isVisible()
    click(qtbot, page.export)
    assert "13 frames at 12 a second" in finished(page, qtbot)
    assert (tmp_path / "smile").with_suffix(page.chosen.suffix).read_text().startswith(begins)


def test_a_cancelled_export_leaves_the_file_that_was_there(page: ExportPage, qtbot: QtBot, tmp_path: Path) -> None:
    (tmp_path / "smile.mp4").write_text("precious")
    page.frames.rate.set_now(120.0)
    assert "replaces the smile.mp4 that is there" in page.progress.text.text()
    click(qtbot, page.export)
    qtbot.waitUntil(lambda: page.progress.text.text().startswith("Filming"))
    click(qtbot, page.stop)
    assert finished(page, qtbot) == "The export was cancelled; nothing was written."
    qtbot.waitUntil(lambda: exported(tmp_path) == ["smile.mp4"])
    assert (tmp_path / "smile.mp4").read_text() == "precious"


def test_the_editor_stays_alive_and_the_page_may_be_closed(
    page: ExportPage, window: MainWindow, document: Document, qtbot: QtBot, tmp_path: Path
) -> None:
    pick(page.kind, ".obj")
    pick(page.frames.range, "range laugh")
    click(qtbot, page.export)
    page.close()
    document.set_weights({"12R": 0.5})
    assert document.project.expression == {"12R": 0.5}
    finished(page, qtbot)
    qtbot.waitUntil(lambda: window.status.hint.text() == "Exported smile.obj")
    assert len(exported(tmp_path)) == 4


def test_what_stands_in_the_way_is_said(
    page: ExportPage, document: Document, qtbot: QtBot, tmp_path: Path, answer: Callable[..., list[str]]
) -> None:
    def said() -> str:
        assert not page.export.isEnabled()
        assert page.progress.text.property("role") == "error"
        return page.progress.text.text()

    page.place.setText(str(tmp_path / "none" / "smile.mp4"))
    assert "There is no folder" in said()
    page.place.setText(str(tmp_path / "smile.avi"))
    assert said() == "Name a file that ends in .mp4."
    page.place.setText(str(tmp_path / "smile.mp4"))
    page.frames.last.set_now(0.0)
    assert said() == "The range is empty; let it end after its begin."
    pick(page.frames.range, "played")
    assert page.export.isEnabled()
    document.edit(replace(document.project, animation=STILL), "Stand still")
    assert not page.export.isEnabled()
    assert page.progress.text.text() == "Nothing moves yet: add keys, events or speech, or film a turntable."
    page.film.turns.set_now(1.0)
    assert page.export.isEnabled()
    page.film.wide.set_now(33.0)
    click(qtbot, page.export)
    assert "videos have even sides; choose 34x720" in finished(page, qtbot)


def test_an_undo_brings_back_what_there_is_to_export(page: ExportPage, document: Document) -> None:
    document.edit(replace(document.project, animation=replace(SMILE, end=3.0)), "Longer")
    assert page.frames.span == (0.0, 3.0)
    document.undo()
    assert page.frames.span == (0.0, 1.0)
    document.undo()
    assert not page.export.isEnabled()


def test_closing_the_window_asks_and_then_ends_an_export(
    page: ExportPage, window: MainWindow, qtbot: QtBot, tmp_path: Path, answer: Callable[..., list[str]]
) -> None:
    page.frames.rate.set_now(120.0)
    click(qtbot, page.export)
    qtbot.waitUntil(lambda: page.progress.text.text().startswith("Filming"))
    window.context.document._saved = window.context.document.project
    said = answer(QMessageBox.StandardButton.Cancel, QMessageBox.StandardButton.Discard)
    assert not window.close()
    assert page.job.running
    assert window.close()
    assert said == ["“smile.mp4” is still being exported."] * 2
    assert not page.isVisible()
    qtbot.waitUntil(lambda: exported(tmp_path) == [])


def test_a_name_without_its_folder_is_asked_for_in_words(page: ExportPage) -> None:
    page.place.setText("smile.mp4")
    assert "with its folder" in page.problem()

"""A capture is looked at before it is taken in: the table is typed into while face and timeline follow."""

from pathlib import Path

import numpy as np
import pytest
from PySide6.QtCore import QPoint, QRect, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QLabel, QLineEdit, QWidget
from pytestqt.qtbot import QtBot

from app.document import Document
from facemodel.animation.clip import STILL
from facemodel.animation.samples import Samples
from tests.animation.tracker import Shown, seen
from tests.ui.hands import drag
from ui.timeline.dialogs.mapping_page import MappingPage
from ui.widgets.number_edit import NumberEdit
from ui.window.main_window import MainWindow

LEFT = Qt.MouseButton.LeftButton
GAIN, TARGET, CAP = 2, 1, 4

PEAK = 1.0
"""Seconds at which the smile of the capture is broadest, 4 of 5."""


@pytest.fixture
def capture(tmp_path: Path) -> Path:
    """A smile that comes and goes within two seconds, as OpenFace writes one."""
    file = tmp_path / "smile.csv"
    lines = ["frame, timestamp, confidence, success, AU12_r, AU25_r"]
    lines += [f"{k + 1}, {k / 30:.4f}, 0.98, 1, {4.0 * (1 - abs(k / 30 - PEAK)):.4f}, 0.5" for k in range(61)]
    file.write_text("\n".join(lines) + "\n")
    return file


@pytest.fixture
def page(window: MainWindow, capture: Path, qtbot: QtBot) -> MappingPage:
    window.timeline.exchange.read_capture(capture)
    qtbot.waitUntil(lambda: window.findChild(MappingPage) is not None)
    page = window.findChild(MappingPage)
    qtbot.waitUntil(page.isVisible)
    scrub(window, PEAK)
    return page


def scrub(window: MainWindow, time: float) -> None:
    ruler = window.timeline.panel.ruler
    place = QPoint(round(window.timeline.view.scale.x(time)), 8)
    QTest.mouseClick(ruler, LEFT, Qt.KeyboardModifier.NoModifier, place)


def enter(editor: QLineEdit, text: str) -> None:
    editor.selectAll()
    QTest.keyClick(editor, Qt.Key.Key_Delete)
    QTest.keyClicks(editor, text)
    QTest.keyClick(editor, Qt.Key.Key_Return)


def type_cell(page: MappingPage, column: int, text: str, qtbot: QtBot) -> None:
    """Double-click a cell of the row of the smile and type."""
    row = next(k for k, each in enumerate(page.table.mapping.rows) if each.source == "AU12_r")
    page.activateWindow()
    qtbot.waitUntil(page.isActiveWindow)
    page.view.scrollTo(page.table.index(row, column))
    place = page.view.visualRect(page.table.index(row, column)).center()
    QTest.mouseClick(page.view.viewport(), LEFT, Qt.KeyboardModifier.NoModifier, place)
    QTest.mouseDClick(page.view.viewport(), LEFT, Qt.KeyboardModifier.NoModifier, place)
    enter(page.view.findChild(QLineEdit), text)


def smile(document: Document) -> float:
    return document.shown.get("12L", 0.0)


def captured(document: Document, channel: str = "12L") -> Samples:
    track = document.project.animation.track(channel)
    assert track is not None
    assert track.captured is not None
    return track.captured


def push(button: QWidget) -> None:
    QTest.mouseClick(button, LEFT)


def test_the_face_is_scrubbed_while_the_table_is_open(
    window: MainWindow, page: MappingPage, document: Document
) -> None:
    assert not window.timeline.dock.is_folded
    broad = smile(document)
    assert broad == pytest.approx(0.78, abs=0.08)
    scrub(window, 0.3)
    assert 0.1 < smile(document) < 0.5 * broad
    assert page.isVisible()


def test_a_typed_gain_and_cap_are_seen_on_the_face(page: MappingPage, document: Document, qtbot: QtBot) -> None:
    type_cell(page, GAIN, "0.2/2", qtbot)
    qtbot.waitUntil(lambda: smile(document) == pytest.approx(0.38, abs=0.05))
    type_cell(page, CAP, "0.25", qtbot)
    qtbot.waitUntil(lambda: smile(document) == pytest.approx(0.25, abs=0.01))
    type_cell(page, CAP, "", qtbot)
    qtbot.waitUntil(lambda: smile(document) == pytest.approx(0.38, abs=0.05))
    type_cell(page, GAIN, "much", qtbot)
    assert next(row for row in page.table.mapping.rows if row.source == "AU12_r").gain == pytest.approx(0.1)


def test_another_target_moves_something_else(page: MappingPage, document: Document, qtbot: QtBot) -> None:
    type_cell(page, TARGET, "20", qtbot)
    qtbot.waitUntil(lambda: document.shown.get("20L", 0.0) > 0.6)
    assert smile(document) == 0.0
    assert document.project.animation.track("12L") is None
    type_cell(page, TARGET, "wagging ears", qtbot)
    qtbot.waitUntil(lambda: "AU12_r" in page.notes.text())


def test_smoothing_rounds_the_peak_off(page: MappingPage, document: Document, qtbot: QtBot) -> None:
    sharp = captured(document).values.max()
    bar = page.smoothing
    QTest.mouseDClick(bar, LEFT, Qt.KeyboardModifier.NoModifier, bar.rect().center())
    enter(bar.findChild(NumberEdit), "0.3")
    qtbot.waitUntil(lambda: captured(document).values.max() < 0.85 * sharp)
    assert page.mapping.smoothing == pytest.approx(0.3)


def test_all_of_it_is_one_step_and_cancel_leaves_nothing(page: MappingPage, document: Document, qtbot: QtBot) -> None:
    type_cell(page, GAIN, "0.1", qtbot)
    qtbot.waitUntil(lambda: smile(document) < 0.5)
    QTest.keyClick(page, Qt.Key.Key_Escape)
    assert document.history.done == ()
    assert document.project.animation is STILL or not document.project.animation.tracks


def test_import_takes_it_in_as_it_was_last_typed(page: MappingPage, document: Document, qtbot: QtBot) -> None:
    type_cell(page, GAIN, "0.05", qtbot)
    push(page.take_in)
    assert captured(document).values.max() == pytest.approx(0.2, abs=0.02)
    assert document.history.done == ("Import smile.csv",)
    document.undo()
    assert not document.project.animation.tracks


def test_a_change_elsewhere_takes_the_capture_in(window: MainWindow, page: MappingPage, document: Document) -> None:
    gone: list[int] = []
    page.finished.connect(gone.append)
    document.set_weights({"17": 0.5}, "Chin")
    assert gone == [MappingPage.DialogCode.Accepted]
    assert document.history.done == ("Import smile.csv", "Chin")
    document.undo()
    document.undo()
    assert not document.project.animation.tracks


def test_one_channel_is_told_as_one(window: MainWindow, tmp_path: Path, qtbot: QtBot) -> None:
    (tmp_path / "chin.csv").write_text("time,17\n0,0\n0.1,1\n")
    window.timeline.exchange.read_capture(tmp_path / "chin.csv")
    qtbot.waitUntil(lambda: window.findChild(MappingPage) is not None)
    page = window.findChild(MappingPage)
    assert page.notes.text().startswith("1 channel moves.")
    assert any("· 1 channel ·" in label.text() for label in page.findChildren(QLabel))


def test_another_capture_takes_in_the_one_that_waits(
    window: MainWindow, page: MappingPage, capture: Path, document: Document, qtbot: QtBot
) -> None:
    gone: list[int] = []
    page.finished.connect(gone.append)
    window.timeline.exchange.read_capture(capture)
    qtbot.waitUntil(lambda: bool(gone))
    assert gone == [MappingPage.DialogCode.Accepted]
    qtbot.waitUntil(lambda: sum(each.isVisible() for each in window.findChildren(MappingPage)) == 1)
    (other,) = (each for each in window.findChildren(MappingPage) if each.isVisible())
    other.reject()
    assert document.history.done == ("Import smile.csv",)


@pytest.fixture
def landmark_page(window: MainWindow, tmp_path: Path, qtbot: QtBot) -> MappingPage:
    """The page of a tracker that saw a calm face, which then opened its mouth for good."""
    project = window.context.document.project
    shown = [Shown()] * 30 + [Shown({"26": 1.0, "25": 0.6})] * 30
    file = tmp_path / "take.npz"
    np.savez(file, landmarks=seen(project, window.context.document.solution, shown))
    window.timeline.exchange.read_capture(file)
    qtbot.waitUntil(lambda: window.findChild(MappingPage) is not None)
    page = window.findChild(MappingPage)
    qtbot.waitUntil(page.isVisible)
    return page


def test_the_moment_of_rest_is_looked_at_and_chosen(
    window: MainWindow, landmark_page: MappingPage, document: Document, qtbot: QtBot
) -> None:
    page, playhead = landmark_page, window.timeline.timeline.playhead
    assert page.rest is not None
    assert page.rest.bar.value < 1.0
    scrub(window, 1.8)
    qtbot.waitUntil(lambda: document.shown.get("26", 0.0) > 0.5)

    drag(page.rest.bar, 0.2, 0.95, release=False)
    assert playhead.time == pytest.approx(page.rest.bar.value, abs=0.05)
    assert playhead.time > 1.0
    assert document.shown["26"] > 0.5
    QTest.mouseRelease(page.rest.bar, LEFT, Qt.KeyboardModifier.NoModifier, page.rest.bar.rect().center())
    qtbot.waitUntil(lambda: document.shown.get("26", 0.0) < 0.2)

    scrub(window, 0.5)
    QTest.mouseClick(page.rest.here, LEFT)
    qtbot.waitUntil(lambda: "at rest at 0.5" in page.notes.text())
    page.reject()
    assert document.history.done == ()


def test_weights_are_not_asked_when_the_face_was_at_rest(page: MappingPage) -> None:
    assert page.rest is None


def ink(widget: QWidget, area: QRect) -> tuple[int, int]:
    """Return the first and the last column of an area that something is written in, pixels."""
    picture = widget.grab(area).toImage()
    ground = picture.pixelColor(1, 1)
    written = [
        x
        for x in range(picture.width())
        if any(picture.pixelColor(x, y) != ground for y in range(4, area.height() - 4))
    ]
    return written[0], written[-1]


def test_headings_stand_over_what_is_in_their_columns(page: MappingPage) -> None:
    head, view = page.view.horizontalHeader(), page.view
    view.selectionModel().clear()
    QApplication.processEvents()
    for column, end in ((0, 0), (1, 0), (GAIN, 1)):
        above = QRect(head.sectionViewportPosition(column), 0, head.sectionSize(column), head.height())
        cells = [view.visualRect(page.table.index(row, column)) for row in range(2)]
        below = [ink(view.viewport(), cell)[end] for cell in cells]
        # One letter leaves a pixel or so more free at its side than another one does.
        assert ink(head.viewport(), above)[end] == pytest.approx(below[0], abs=2)

"""What sounds look like is edited beside a window that stays in reach; every change is one step."""

from itertools import pairwise

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from pytestqt.qtbot import QtBot

from app.document import Document
from tests.ui.hands import drag
from ui.theme.metrics import ROW
from ui.timeline.dialogs.viseme_page import VisemePage
from ui.window.main_window import MainWindow

LEFT = Qt.MouseButton.LeftButton
NONE = Qt.KeyboardModifier.NoModifier


@pytest.fixture
def page(window: MainWindow, qtbot: QtBot) -> VisemePage:
    window.timeline.dock.open()
    window.binding.qt["timeline.visemes"].trigger()
    (page,) = window.findChildren(VisemePage)
    qtbot.waitUntil(page.isActiveWindow)
    return page


def retype(page: VisemePage, text: str) -> None:
    page.weights.setFocus()
    page.weights.selectAll()
    QTest.keyClicks(page.weights, text)
    QTest.keyClick(page.weights, Qt.Key.Key_Tab)


def test_the_face_looks_like_the_viseme_in_hand_and_that_is_no_step(page: VisemePage, document: Document) -> None:
    QTest.keyClick(page.list, Qt.Key.Key_Down)
    wanted = {name: weight for name, weight in page.viseme.weights.items() if weight}
    assert wanted
    assert sum(weight > 0 for weight in document.shown.values()) >= len(wanted)
    QTest.keyClick(page, Qt.Key.Key_Escape)
    assert not any(document.shown.values())
    assert document.history.done == ()


def test_typed_weights_are_one_step_that_undo_takes_back_under_the_page(
    page: VisemePage, document: Document, window: MainWindow
) -> None:
    before = page.weights.text()
    retype(page, "26=0.4")
    assert document.history.done == (f"Viseme {page.viseme.name}",)
    assert document.shown["26"] == pytest.approx(0.4)
    window.binding.settle()
    window.binding.qt["edit.undo"].trigger()
    assert page.weights.text() == before
    assert document.project.animation.speech.visemes == ()
    window.binding.settle()
    window.binding.qt["edit.redo"].trigger()
    assert page.weights.text() == "26=0.4"


def test_enter_takes_what_is_typed_and_leaves_the_page_open(page: VisemePage, document: Document) -> None:
    page.weights.selectAll()
    QTest.keyClicks(page.weights, "26=0.3")
    QTest.keyClick(page.weights, Qt.Key.Key_Return)
    assert document.shown["26"] == pytest.approx(0.3)
    assert page.isVisible()


def test_every_viseme_has_a_row_of_its_own(page: VisemePage) -> None:
    rows = [page.list.visualItemRect(page.list.item(k)) for k in range(page.list.count())]
    assert {row.height() for row in rows} == {ROW}
    assert all(one.bottom() < other.top() for one, other in pairwise(rows))


def test_nonsense_is_told_and_changes_nothing(page: VisemePage, document: Document) -> None:
    retype(page, "26=wide")
    assert page.complaint.text()
    assert document.history.done == ()


def test_a_drag_of_dominance_is_one_step_and_escape_takes_it_back(page: VisemePage, document: Document) -> None:
    was = page.viseme.dominance
    drag(page.dominance, 0.5, 0.2, release=False)
    QTest.keyClick(page.dominance, Qt.Key.Key_Escape)
    QTest.mouseRelease(page.dominance, LEFT)
    assert (page.viseme.dominance, document.history.done) == (was, ())
    drag(page.dominance, 0.5, 0.2)
    assert page.viseme.dominance < was
    assert document.history.done == ("Dominance",)


def test_the_window_stays_in_reach_and_a_slider_makes_the_face_to_take(
    page: VisemePage, window: MainWindow, document: Document
) -> None:
    assert not page.isModal()
    ruler = window.timeline.panel.ruler
    QTest.mouseClick(ruler, LEFT, NONE, QPoint(round(window.timeline.view.scale.x(0.5)), 8))
    assert window.span.timeline.playhead.time == pytest.approx(0.5, abs=0.03)
    page.show_face()
    document.set_weights({"17": 0.7})
    page.take_face()
    assert page.viseme.weights["17"] == pytest.approx(0.7)
    page.restore()
    assert document.project.animation.speech.visemes == ()


def test_another_document_shows_its_own_and_asked_for_again_it_is_the_same_page(
    page: VisemePage, window: MainWindow, document: Document
) -> None:
    retype(page, "26=0.4")
    document.begin(document.project)
    assert page.weights.text() == "26=0.4"
    page.restore()
    assert page.weights.text() != "26=0.4"
    window.binding.qt["timeline.visemes"].trigger()
    assert window.findChildren(VisemePage) == [page]

"""Hint card, layout, status line, words beside the pointer, calls from other threads."""

import threading

import pytest
from hypothesis import given
from hypothesis import strategies as st
from PySide6.QtCore import QPoint, Qt, QThread, QTimer
from PySide6.QtGui import Qt as TextOf
from PySide6.QtGui import QTextDocument
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QMessageBox, QToolButton, QWidget

from ui.widgets.elided_label import ElidedLabel
from ui.widgets.hint_card import HintCard
from ui.widgets.plain_label import as_written
from ui.widgets.pointer_label import PointerLabel
from ui.window.delivery import UiThread
from ui.window.layout import Layout, layout_from, layout_text
from ui.window.status_line import StatusLine
from ui.window.unforeseen import Unforeseen


def test_a_card_goes_once_everything_is_ticked(shown, qtbot):
    card = shown(HintCard("Try", [("smile", "Smile"), ("turn", "Turn")]))
    card.tick("smile")
    assert card.left == {"turn"}
    with qtbot.waitSignal(card.dismissed):
        card.tick("turn")


def test_a_card_can_be_closed_at_once(shown, qtbot):
    card = shown(HintCard("Try", [("smile", "Smile")]))
    with qtbot.waitSignal(card.dismissed):
        QTest.mouseClick(card.findChild(QToolButton), Qt.MouseButton.LeftButton)


@given(st.binary(max_size=60), st.frozensets(st.text(max_size=8), max_size=5))
def test_a_layout_comes_back_from_its_text(docks, folded):
    assert layout_from(layout_text(Layout(docks, folded))) == Layout(docks, folded)


@given(st.text(max_size=40))
def test_a_text_that_is_no_layout_is_the_default_one(text):
    assert layout_from(text) == Layout()


def test_a_layout_of_another_version_is_the_default_one():
    assert layout_from('{"version": 0, "docks": "AAAA", "folded": []}') == Layout()
    assert layout_from('{"version": 1, "docks": "?", "folded": []}') == Layout()


def test_the_words_beside_the_pointer_stay_inside(shown):
    host = QWidget()
    host.resize(300, 200)
    label = PointerLabel(host)
    shown(host)
    for place in (QPoint(0, 0), QPoint(299, 0), QPoint(0, 199), QPoint(299, 199), QPoint(150, 100)):
        label.say("Zygomaticus major, left", place)
        assert host.rect().contains(label.geometry())
        assert not label.geometry().contains(place)
    label.say("", QPoint(5, 5))
    assert not label.isVisible()


def test_a_call_from_another_thread_runs_in_ours(qtbot, qapp):
    ran: list[bool] = []
    home = UiThread()
    worker = threading.Thread(target=lambda: home.deliver(lambda: ran.append(QThread.isMainThread())))
    worker.start()
    worker.join()
    assert ran == []
    qtbot.waitUntil(lambda: ran == [True])


def test_progress_comes_with_a_button_that_cancels_and_goes_with_it(shown, qtbot):
    line = shown(StatusLine())
    assert not line.cancel.isVisible()
    line.show_progress("Factorising", 0.4)
    assert line.bar.value() == 400
    assert not line.bar.isVisible(), "what is over in a blink does not flicker"
    qtbot.waitUntil(line.cancel.isVisible)
    with qtbot.waitSignal(line.cancel_asked):
        QTest.mouseClick(line.cancel, Qt.MouseButton.LeftButton)
    line.end_progress()
    assert not line.bar.isVisible()


def test_a_hint_waits_while_a_notice_is_shown(shown):
    line = shown(StatusLine())
    line.show_hint("Drag a bar")
    line.notify("Saved smile.risorius")
    line.show_hint("Turn the head")
    assert line.hint.text() == "Saved smile.risorius"


def test_a_long_notice_gives_way_to_the_state_of_the_face_and_can_be_read_in_full(shown):
    line = StatusLine()
    line.resize(600, line.height())
    shown(line)
    line.show_state("solved 62/62 · 12 ms · fast", "")
    line.notify("Imported take_042.csv. " + 12 * "Something was bridged. ")
    QApplication.processEvents()
    assert line.hint.geometry().right() < line.state.geometry().left()
    assert line.state.width() >= line.state.sizeHint().width()
    assert line.hint.seen.endswith("…")
    assert line.hint.seen.startswith("Imported take_042.csv")
    line.grab()
    assert line.hint.toolTip() == line.hint.text()
    line.notify("Short.")
    line.grab()
    assert (line.hint.seen, line.hint.toolTip()) == ("Short.", "")


def test_an_unforeseen_error_is_shown_once_and_the_program_goes_on(shown, qtbot, caplog):
    window = shown(QWidget())
    boxes: list[QMessageBox] = []

    def look() -> None:
        box = QApplication.activeModalWidget()
        if isinstance(box, QMessageBox):
            boxes.append(box)
            hook.tell(RuntimeError, RuntimeError("another"), None)
            box.button(QMessageBox.StandardButton.Ok).click()

    hook = Unforeseen(window)
    QTimer.singleShot(50, look)
    hook.tell(ValueError, ValueError("a bolt came loose"), None)
    assert len(boxes) == 1
    assert "a bolt came loose" in boxes[0].detailedText()
    assert [record.levelname for record in caplog.records] == ["ERROR", "ERROR"]


def read(tip: str) -> str:
    """Return what a tooltip says, as Qt makes it out."""
    document = QTextDocument()
    if TextOf.mightBeRichText(tip):
        document.setHtml(tip)
    else:
        document.setPlainText(tip)
    return document.toPlainText()


@pytest.mark.parametrize(
    "name", ["Smile", "Smile & wink", "<b>Smile</b>", "a<b", "<img src=x>", "&lt;Smile&gt;", "1 < 2"]
)
def test_a_tooltip_shows_a_name_as_it_is_written(qapp, name):
    assert read(as_written(f"Reset {name}")) == f"Reset {name}"


@given(name=st.text(st.characters(categories=("L", "N", "P", "S")), min_size=1, max_size=30))
def test_a_tooltip_shows_any_name_as_it_is_written(qapp, name):
    assert read(as_written(f"Reset {name}")) == f"Reset {name}"


def test_the_words_beside_the_pointer_and_a_cut_line_show_a_name_as_it_is_written(shown):
    host = QWidget()
    host.resize(120, 80)
    pointer, line = PointerLabel(host), ElidedLabel("A long line about <b>Smile</b>", host)
    line.resize(60, 20)
    shown(host)
    pointer.say("<b>Smile</b>", QPoint(5, 5))
    line.grab()
    assert pointer.textFormat() == line.textFormat() == Qt.TextFormat.PlainText
    assert read(line.toolTip()) == line.text()

"""What is said is typed beside a window that stays in reach, and comes to where the playhead stands then."""

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication
from pytestqt.qtbot import QtBot

from app.document import Document
from ui.timeline.dialogs.speech_page import SpeechPage
from ui.window.main_window import MainWindow

LEFT = Qt.MouseButton.LeftButton


@pytest.fixture
def page(window: MainWindow, qtbot: QtBot) -> SpeechPage:
    window.binding.qt["timeline.type-speech"].trigger()
    (page,) = window.findChildren(SpeechPage)
    qtbot.waitUntil(page.isVisible)
    page.kind.setCurrentIndex(1)
    return page


def test_the_timeline_can_be_scrubbed_while_it_is_open(
    window: MainWindow, page: SpeechPage, document: Document, qtbot: QtBot
) -> None:
    assert not page.isModal()
    ruler = window.timeline.panel.ruler
    place = QPoint(round(window.timeline.view.scale.x(0.5)), 8)
    QTest.mouseClick(ruler, LEFT, Qt.KeyboardModifier.NoModifier, place)
    QTest.keyClicks(page.text, "HH AH L OW")
    QTest.mouseClick(page.take, LEFT)
    (step,) = document.history.done
    assert step == "Type speech"
    assert document.project.animation.speech.phonemes[0].start == pytest.approx(0.5, abs=0.03)
    qtbot.waitUntil(lambda: not window.findChildren(SpeechPage))


def test_asked_for_again_it_is_the_same_page(window: MainWindow, page: SpeechPage, qtbot: QtBot) -> None:
    QTest.keyClicks(page.text, "AA")
    window.binding.qt["timeline.type-speech"].trigger()
    assert window.findChildren(SpeechPage) == [page]
    assert page.text.toPlainText() == "AA"
    QTest.keyClick(page, Qt.Key.Key_Escape)
    qtbot.waitUntil(lambda: not window.findChildren(SpeechPage))
    window.binding.qt["timeline.type-speech"].trigger()
    assert window.findChildren(SpeechPage)[0].text.toPlainText() == ""
    QApplication.processEvents()

"""Theme, room, layout, hints, keys."""

import gc
import weakref

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QOpenGLContext, QSurface
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QComboBox, QMessageBox, QToolBar, QToolButton, QWidget

from app.actions.action import shortcuts_of
from app.document import Document
from tests.ui.hands import drag
from tests.ui.window.conftest import forget
from tests.ui.window.seen import picture
from ui.theme.apply import current_theme
from ui.window.editor import make_window
from ui.window.main_window import MainWindow
from ui.window.preparation import Preparation

Button = QMessageBox.StandardButton
CTRL, SHIFT = Qt.KeyboardModifier.ControlModifier, Qt.KeyboardModifier.ShiftModifier
SMILE = 12


def test_it_changes_live_and_is_remembered(window, settings):
    before = picture(window)
    QTest.keyClick(window, Qt.Key.Key_L, CTRL | SHIFT)
    assert current_theme().name == "light"
    light = picture(window)
    assert light[2, 2].mean() > before[2, 2].mean() + 60
    assert settings.preferences.theme == "light"
    QTest.keyClick(window, Qt.Key.Key_L, CTRL | SHIFT)
    assert current_theme().name == "dark"


@pytest.mark.parametrize(("width", "height"), [(1280, 720), (1024, 600), (1600, 1000)])
def test_nothing_is_cut(window, width, height):
    window.resize(width, height)
    QApplication.processEvents()
    assert (window.width(), window.height()) == (width, height)
    cut = [
        f"{type(widget).__name__} {widget.accessibleName() or widget.toolTip()}"
        for part in (window.expression, window.status, window.menuBar())
        for widget in part.findChildren(QWidget)
        if widget.isVisible() and not isinstance(widget, QToolButton)
        if widget.width() < min(widget.minimumSizeHint().width(), 400)
    ]
    assert cut == []
    row = window.expression.rows[11]
    assert row.mapTo(window.expression, QPoint(row.width(), 0)).x() <= window.expression.width()
    assert window.viewport.width() > 500


def test_the_toolbar_fits_at_720(window):
    window.resize(1280, 720)
    QApplication.processEvents()
    extension = window.strip.findChild(QWidget, "qt_toolbar_ext_button")
    assert isinstance(window.strip, QToolBar)
    assert extension is None or not extension.isVisible()


def test_layout_and_folds_come_back_at_the_next_start(window, open_window, document):
    QTest.mouseClick(window.expression.groups["jaw"].heading, Qt.MouseButton.LeftButton)
    window.binding.perform("face.information")
    window.close()
    again = open_window(document)
    assert again.docks["information"].isVisible()
    assert again.expression.groups["jaw"].is_folded
    again.binding.perform("window.reset-layout")
    assert not again.docks["information"].isVisible()
    assert not again.expression.groups["jaw"].is_folded


def test_they_are_ticked_off_go_away_and_stay_away(window, open_window, settings, document, qtbot):
    card = window.hints.card
    assert card is not None
    assert card.isVisible()
    drag(window.expression.rows[SMILE].slider, 0.1, 0.5)
    QTest.mouseClick(window.expression.emotions.buttons["surprise"], Qt.MouseButton.LeftButton)
    assert card.left == {"turn"}
    canvas = window.viewport.canvas
    QTest.mousePress(canvas, Qt.MouseButton.RightButton, pos=QPoint(300, 300))
    QTest.mouseMove(canvas, QPoint(340, 300))
    QTest.mouseRelease(canvas, Qt.MouseButton.RightButton, pos=QPoint(340, 300))
    qtbot.waitUntil(lambda: settings.preferences.hint_done)
    assert open_window(document).hints.card is None


def test_no_keys_belong_to_two_actions(window):
    keys = [k for action in window.binding.actions for k in shortcuts_of(action, window.context.settings.preferences)]
    assert len(keys) == len(set(keys))


def test_a_changed_key_works_at_once(window, settings):
    settings.change(shortcuts={"view.skull": "Ctrl+K"})
    QApplication.processEvents()
    QTest.keyClick(window, Qt.Key.Key_K, CTRL)
    assert window.context.view.state.skull


def test_search_takes_the_keyboard(window):
    QTest.keyClick(window, Qt.Key.Key_F, CTRL)
    assert window.expression.search.hasFocus()
    QTest.keyClicks(window.expression.search, "1")
    assert window.context.view.state.view == "three-quarter"


def test_home_goes_to_the_head_of_a_list_and_only_from_the_face_to_the_whole_head(window, qtbot):
    window.show_workspace("actions")
    window.context.view.change(unit=12)
    combo = next(each for each in window.findChildren(QComboBox) if each.isVisible() and each.count() > 1)
    combo.setFocus()
    qtbot.waitUntil(combo.hasFocus)
    combo.setCurrentIndex(combo.count() - 1)
    window.context.view.change(view="free")
    QTest.keyClick(combo, Qt.Key.Key_Home)
    assert combo.currentIndex() == 0
    assert window.context.view.state.view == "free"
    window.viewport.canvas.setFocus()
    QTest.keyClick(window.viewport.canvas, Qt.Key.Key_Home)
    assert window.context.view.state.view == "three-quarter"


def test_undo_is_named_in_the_menu(window, document):
    document.set_weights({"12L": 0.5})
    window.binding.refresh()
    assert window.binding.qt["edit.undo"].text() == "Undo Lip corner puller L"


def test_a_key_acts_on_what_has_just_changed(window, document):
    document.set_weights({"12L": 0.5}, "Smile")
    QTest.keyClick(window, Qt.Key.Key_Z, CTRL)
    assert document.history.done == ()


def test_a_closed_window_keeps_nothing_that_belonged_to_its_drawing(window):
    def kept() -> set[type]:
        return {type(value) for value in vars(window.viewport.canvas).values() if isinstance(value, drawing)}

    drawing = (QSurface, QOpenGLContext)
    assert kept()
    window.close()
    assert not kept()


def test_a_closed_window_goes_with_its_document(project, settings, solution, qtbot):
    def opened_and_closed() -> weakref.ref[MainWindow]:
        document = Document(project)
        window = make_window(document, settings, Preparation(), lambda *_: solution)
        window.show()
        qtbot.waitUntil(lambda: document.solution is not None and window.viewport.shows_face)
        window.close()
        forget(window)
        return weakref.ref(window)

    left = opened_and_closed()
    gc.collect()
    assert left() is None

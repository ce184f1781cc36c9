"""The right button, Esc, undo and other keys while the left button holds something, whatever that is."""

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

import pytest
from PySide6.QtCore import QPoint, Qt
from PySide6.QtGui import QContextMenuEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QMenu, QWidget

from app.authoring.pad import arranged
from app.document import Document
from facemodel.project import Project
from tests.timeline.stage import lively, with_animation
from tests.ui.hands import move
from tests.ui.timeline.test_graph import key as key_of_curve
from tests.ui.window.seen import next_frame
from tests.ui.workspaces.conftest import at
from ui.panels.actions.panel import EXPRESSIONS
from ui.widgets.number_edit import NumberEdit
from ui.window.main_window import HELD, MainWindow

LEFT, RIGHT = Qt.MouseButton.LeftButton, Qt.MouseButton.RightButton
NONE, CTRL, SHIFT = (
    Qt.KeyboardModifier.NoModifier,
    Qt.KeyboardModifier.ControlModifier,
    Qt.KeyboardModifier.ShiftModifier,
)
Key = Qt.Key

REFUSED = (
    (Key.Key_S, CTRL),
    (Key.Key_0, NONE),
    (Key.Key_Space, NONE),
    (Key.Key_Delete, NONE),
    (Key.Key_Tab, NONE),
    (Key.Key_Right, NONE),
    (Key.Key_Return, NONE),
    (Key.Key_P, CTRL | SHIFT),
)
"""Save, neutral face, play, delete, the next workspace, a step of what is in focus, typing, and the palette."""

BACK = ((Key.Key_Escape, NONE), (Key.Key_Z, CTRL), (Key.Key_Z, CTRL | SHIFT))


@pytest.fixture
def document(project: Project, tmp_path: Path) -> Document:
    """Return a document with a file, so that to save it asks nothing, and something done and undone."""
    document = Document(arranged(with_animation(project, lively())))
    document.save(tmp_path / "face.risorius")
    document.set_weights({"17": 0.3})
    document.set_weights({"4": 0.2})
    document.undo()
    return document


@dataclass
class Held:
    """A drag under way, and what was there before it."""

    window: MainWindow
    widget: QWidget
    place: QPoint
    before: dict[str, object]

    def go_on(self, way: QPoint) -> None:
        for share in (0.4, 0.7, 1.0):
            move(self.widget, self.place + share * way)
        self.place += way
        self.window.hands.flush()
        QApplication.processEvents()

    def let_go(self) -> None:
        QTest.mouseRelease(self.widget, LEFT, pos=self.place)
        QApplication.processEvents()

    @property
    def now(self) -> dict[str, object]:
        return all_of(self.window)


def all_of(window: MainWindow) -> dict[str, object]:
    """Return everything that a key might change."""
    document, playhead = window.context.document, window.timeline.timeline.playhead
    return {
        "animation": repr(document.project.animation),
        "places": [each.place for each in document.project.emotions],
        "expression": document.project.expression,
        "shown": document.shown,
        "held": document.held,
        "done": document.history.done,
        "redo": document.history.to_redo is not None,
        "file": hash(document.path.read_bytes()),
        "playing": playhead.playing,
        "workspace": window.context.view.state.workspace,
        "palette": window.palette_box.isVisible(),
        "typing": len(window.findChildren(NumberEdit)),
    }


def slider(window: MainWindow) -> tuple[QWidget, QPoint]:
    bar = window.expression.rows[12].slider
    return bar, QPoint(bar.width() // 5, bar.height() // 2)


def emotion(window: MainWindow) -> tuple[QWidget, QPoint]:
    button = window.expression.emotions.buttons["surprise"]
    return button, QPoint(4, button.height() // 2)


def pad(window: MainWindow) -> tuple[QWidget, QPoint]:
    window.context.view.change(workspace="actions")
    panel = window.panels.panel("actions")
    panel.tabs.setCurrentIndex(EXPRESSIONS)
    QApplication.processEvents()
    return panel.blend.pad, panel.blend.pad.spot(panel.blend.pad.pointer).toPoint()


def event(window: MainWindow) -> tuple[QWidget, QPoint]:
    opened(window).view.frame(0.0, 4.0)
    QTest.qWait(150)
    view = window.timeline.view
    placed = view.layout.of("lane 0")
    return window.timeline.panel.sheet, QPoint(round(view.scale.x(0.8)), round(placed.top - view.top + 9))


def curve_key(window: MainWindow) -> tuple[QWidget, QPoint]:
    opened(window).timeline.change(mode="curves", lines=frozenset(("track 12L", "track 17")))
    QTest.qWait(150)
    graph = window.timeline.panel.graph
    graph.frame_values()
    return graph, key_of_curve(graph, "12L", 1)


def opened(window: MainWindow):
    window.timeline.dock.open()
    QTest.qWait(150)
    return window.timeline


def tool(window: MainWindow) -> tuple[QWidget, QPoint]:
    window.context.view.look_from("front")
    window.toolbox.take("pull")
    next_frame(window)
    return window.viewport.canvas, at(window, 0.575, 0.585)


@pytest.fixture(params=[slider, emotion, pad, event, curve_key, tool], ids=lambda each: each.__name__)
def held(window: MainWindow, request: pytest.FixtureRequest) -> Held:
    return take(window, request.param)


def take(window: MainWindow, what: Callable[[MainWindow], tuple[QWidget, QPoint]]) -> Held:
    widget, place = what(window)
    widget.setFocus()
    held = Held(window, widget, place, all_of(window))
    QTest.mousePress(widget, LEFT, pos=place)
    held.go_on(QPoint(26, -16))
    assert held.now != held.before
    return held


def press_right(held: Held) -> list[QWidget]:
    """Press the right button, upon which the system asks for a menu, and return what has popped up."""
    QTest.mousePress(held.widget, RIGHT, pos=held.place)
    mouse, over = QContextMenuEvent.Reason.Mouse, held.widget.mapToGlobal(held.place)
    QApplication.sendEvent(held.widget, QContextMenuEvent(mouse, held.place, over))
    QTest.mouseRelease(held.widget, RIGHT, pos=held.place)
    QApplication.sendEvent(held.widget, QContextMenuEvent(mouse, held.place, over))
    return [each for each in QApplication.topLevelWidgets() if isinstance(each, QMenu) and each.isVisible()]


def test_the_right_button_takes_it_back_and_opens_no_menu_however_often_it_is_pressed(held: Held) -> None:
    for _ in range(2):
        assert not press_right(held)
        assert held.now == held.before
    held.go_on(QPoint(20, 0))
    held.let_go()
    assert held.now == held.before


@pytest.mark.parametrize(("key", "modifiers"), BACK, ids=["esc", "undo", "redo"])
def test_escape_undo_and_redo_take_back_the_drag_and_no_step(held: Held, key: Qt.Key, modifiers) -> None:
    for _ in range(2):
        QTest.keyClick(held.widget, key, modifiers)
        assert held.now == held.before
    held.go_on(QPoint(20, 0))
    held.let_go()
    assert held.now == held.before


def test_other_keys_wait_for_the_button_and_the_drag_is_one_step(held: Held) -> None:
    under_way, document = held.now, held.window.context.document
    done = document.history.done[:1]
    for key, modifiers in REFUSED:
        QTest.keyClick(held.widget, key, modifiers)
        QApplication.processEvents()
        assert held.now == under_way, key
    held.let_go()
    assert document.history.done[:1] == done
    assert len(document.history.done) == 2
    QTest.keyClick(held.window, Key.Key_S, CTRL)
    assert not document.dirty


def test_a_key_that_waits_says_so_until_the_button_goes_up(held: Held) -> None:
    line = held.window.status.hint
    before = line.text()
    QTest.keyClick(held.widget, Key.Key_Shift)
    assert line.text() == before, "it changes the drag, and nothing was refused"
    QTest.keyClick(held.widget, Key.Key_S, CTRL)
    assert line.text() == line.seen == HELD
    held.go_on(QPoint(6, 0))
    assert line.text() == HELD
    held.let_go()
    assert line.text() not in (HELD, "")
    QTest.keyClick(held.widget, Key.Key_F9)
    assert line.text() != HELD


def test_a_key_that_waits_says_so_until_the_drag_is_taken_back(held: Held) -> None:
    line = held.window.status.hint
    QTest.keyClick(held.widget, Key.Key_Delete)
    assert line.text() == HELD
    QTest.keyClick(held.widget, Key.Key_Escape)
    assert line.text() not in (HELD, "")
    held.let_go()


@pytest.mark.parametrize("what", [slider, event], ids=lambda each: each.__name__)
def test_it_is_the_same_on_a_panel_that_floats_and_has_the_keyboard(window: MainWindow, qtbot, what) -> None:
    what(window)
    dock = window.docks["workspace" if what is slider else "timeline"]
    dock.setFloating(True)
    dock.resize(700, 500)
    dock.activateWindow()
    qtbot.waitUntil(dock.isActiveWindow)
    for key, modifiers in (*REFUSED, *BACK):
        held = take(window, what)
        assert QApplication.focusWidget() is held.widget
        under_way = held.now
        QTest.keyClick(held.widget.window().windowHandle(), key, modifiers)
        QApplication.processEvents()
        assert held.now == (held.before if (key, modifiers) in BACK else under_way), key
        assert not press_right(held)
        held.let_go()
        assert held.now == held.before


def test_what_is_typed_while_text_is_marked_is_nobody_elses(window: MainWindow) -> None:
    search = window.expression.search
    QTest.mouseClick(search, LEFT)
    QTest.mousePress(search, LEFT)
    QTest.keyClicks(search, "lip0")
    assert search.text() == "lip0"
    QTest.keyClick(search, Key.Key_Z, CTRL)
    assert search.text() == ""
    QTest.mouseRelease(search, LEFT)

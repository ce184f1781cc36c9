"""A person's first face: from a bare head to a smile, raised brows and an open jaw, with the mouse alone.

Every step is a mouse event on the real window, at the place where the thing is drawn; only names are typed.
``make pictures`` takes the pictures of the walk-through along this way, and a test goes it and looks at the face
that comes out.
"""

from __future__ import annotations

import time
from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np
from PySide6.QtCore import QEvent, QPoint, QPointF, Qt, QTimer
from PySide6.QtGui import QMouseEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QAbstractButton, QApplication, QMenu, QToolBar, QWidget

from facemodel.laying.places import on_bone
from ui.panels.actions.panel import ActionsPanel
from ui.window.main_window import MainWindow
from ui.workspaces.tabs import WorkspaceTabs

LEFT = Qt.MouseButton.LeftButton
NO_KEY = Qt.KeyboardModifier.NoModifier
PATIENCE = 120.0
"""Seconds after which the editor is not coming to rest any more."""

Photograph = Callable[[str], None]

SMILE, BROW = ((40.0, -2.0), (24.0, -46.0)), ((24.0, 78.0), (27.0, 29.0))
"""Where the fibres of the smile and of the brow begin and end: millimetres across and up, seen from in front."""

OPENING = 0.6
"""Of the bar of the jaw: 26 degrees."""


@dataclass
class Hand:
    """A hand on the mouse."""

    window: MainWindow
    photograph: Photograph = field(default=lambda _name: None)

    def click(self, widget: QWidget, at: QPoint | None = None) -> None:
        """Click a widget, in the middle unless told where."""
        QTest.mouseClick(widget, LEFT, NO_KEY, widget.rect().center() if at is None else at)
        QApplication.processEvents()

    def choose(self, *titles: str) -> None:
        """Choose from the menus of the window."""
        bar = self.window.menuBar()
        first = next(action for action in bar.actions() if _plain(action.text()) == titles[0])
        self.click(bar, bar.actionGeometry(first).center())
        menu = first.menu()
        assert isinstance(menu, QMenu)
        self.wait(menu.isVisible)
        self._descend(menu, titles[1:])

    def choose_under(self, button: QAbstractButton, *titles: str) -> None:
        """Choose from the menu that a button opens."""

        def opened() -> None:
            menu = QApplication.activePopupWidget()
            if isinstance(menu, QMenu):
                self._descend(menu, titles)
            else:
                QTimer.singleShot(20, opened)

        QTimer.singleShot(20, opened)
        self.click(button)

    def take(self, tool: str) -> None:
        """Click the tool in the strip at the left."""
        for strip in self.window.findChildren(QToolBar):
            for action in strip.actions():
                if _plain(action.text()).lower() == tool and action.isVisible():
                    button = strip.widgetForAction(action)
                    assert button is not None
                    self.click(button)
                    return
        raise LookupError(f"No tool is called {tool}.")

    def drag(self, widget: QWidget, start: QPoint, end: QPoint, steps: int = 12) -> None:
        """Drag from place to place in a widget."""
        QTest.mousePress(widget, LEFT, NO_KEY, start)
        for step in range(1, steps + 1):
            place = start + (end - start) * step / steps
            there = QPointF(widget.mapToGlobal(place))
            moved = QMouseEvent(QEvent.Type.MouseMove, QPointF(place), there, Qt.MouseButton.NoButton, LEFT, NO_KEY)
            QApplication.sendEvent(widget, moved)
            self.rest(0.02)
        QTest.mouseRelease(widget, LEFT, NO_KEY, end)
        QApplication.processEvents()

    def slide(self, bar: QWidget, start: float, end: float) -> None:
        """Drag a bar from and to shares of its width."""
        y = bar.height() // 2
        self.drag(bar, QPoint(round(bar.width() * start), y), QPoint(round(bar.width() * end), y))

    def pixel(self, place: np.ndarray) -> QPoint:
        """Where in the viewport a place (3,) of the head is drawn."""
        renderer, canvas = self.window.viewport.scene.renderer, self.window.viewport.canvas
        renderer.SetWorldPoint(*place, 1.0)
        renderer.WorldToDisplay()
        x, y, _ = renderer.GetDisplayPoint()
        scale = canvas.devicePixelRatioF()
        return QPoint(round(x / scale), round(canvas.height() - 1 - y / scale))

    def name(self, line: QWidget, text: str) -> None:
        """Type a name into a field."""
        QTest.mouseDClick(line, LEFT)
        QTest.keyClick(line, Qt.Key.Key_A, Qt.KeyboardModifier.ControlModifier)
        QTest.keyClicks(line, text)
        QTest.keyClick(line, Qt.Key.Key_Return)

    def wait(self, ready: Callable[[], bool]) -> None:
        """Let the editor work until something is the case."""
        end = time.monotonic() + PATIENCE
        while not ready():
            if time.monotonic() > end:
                raise TimeoutError("The editor did not come to rest.")
            QApplication.processEvents()
            time.sleep(0.01)

    def rest(self, seconds: float) -> None:
        """Keep still for some seconds."""
        end = time.monotonic() + seconds
        self.wait(lambda: time.monotonic() > end)

    def solved(self) -> None:
        """Wait for the fields of what the document says now."""
        document = self.window.context.document
        self.wait(lambda: document.solution is not None and not document.stale and self.window.viewport.shows_face)

    def _descend(self, menu: QMenu, titles: tuple[str, ...]) -> None:
        for title in titles:
            action = next(each for each in menu.actions() if _plain(each.text()) == title)
            place = menu.actionGeometry(action).center()
            QTest.mouseMove(menu, place)
            self.rest(0.1)
            self.click(menu, place)
            below = action.menu()
            if isinstance(below, QMenu):
                self.wait(below.isVisible)
                self.rest(0.1)
                menu = below


def _plain(text: str) -> str:
    return text.replace("&", "").split("\t")[0]


def workspace(hand: Hand, title: str) -> None:
    """Click the tab of a workspace."""
    tabs = hand.window.findChild(WorkspaceTabs)
    assert tabs is not None
    place = next(place for place in range(tabs.count()) if tabs.tabText(place) == title)
    hand.click(tabs, tabs.tabRect(place).center())
    hand.rest(0.3)


def lay(hand: Hand, origin: tuple[float, float], attachment: tuple[float, float]) -> str:
    """Press on the bone and drag to the skin; the name of the muscle that is laid."""
    face = hand.window.context.document.project.face
    skin = face.skin.positions
    in_front = skin[skin[:, 2] > 0]

    def on_skin(at: tuple[float, float]) -> np.ndarray:
        return np.asarray(in_front[np.hypot(*(in_front[:, :2] - at).T).argmin()])

    start = on_bone(face, on_skin(origin))
    hand.drag(hand.window.viewport.canvas, hand.pixel(start), hand.pixel(on_skin(attachment)))
    hand.solved()
    return hand.window.context.view.state.muscle


def new_unit(hand: Hand, number: int, name: str, *muscle: str) -> None:
    """Make an action unit that contracts a muscle, chosen by its group and title, as far as the tables say."""
    actions = hand.window.findChild(ActionsPanel)
    assert actions is not None
    hand.click(actions.new)
    head = actions.editor.head
    hand.name(head.name, name)
    hand.name(head.number, str(number))
    if muscle:
        hand.choose_under(actions.editor.muscles.add, *muscle)
        hand.solved()
        hand.click(actions.editor.fit)
    hand.solved()


def open_jaw(hand: Hand, share: float) -> None:
    """Drag the opening of the jaw in the unit in hand to a share of its bar."""
    actions = hand.window.findChild(ActionsPanel)
    assert actions is not None
    hand.slide(actions.editor.jaw.opening, 0.02, share)
    hand.solved()


def walk(hand: Hand) -> None:
    """From the editor as it opens to a face that smiles, raises its brows and opens its jaw."""
    window = hand.window
    hand.choose("File", "New bare head", "Ada")
    hand.solved()
    workspace(hand, "Muscles")
    hand.choose("View", "Front")
    hand.take("fibre")
    hand.rest(1.0)
    for way, name in ((SMILE, "first-fibre"), (BROW, "first-muscles")):
        lay(hand, *way)
        hand.photograph(name)
    workspace(hand, "Actions")
    new_unit(hand, 12, "smile", "Lip", "Lip muscle")
    new_unit(hand, 1, "brow raise", "Brow", "Brow muscle")
    new_unit(hand, 26, "jaw opening")
    open_jaw(hand, OPENING)
    hand.photograph("first-units")
    workspace(hand, "Expression")
    for number, share in ((12, 0.95), (1, 0.95), (26, 0.4)):
        hand.slide(window.expression.rows[number].slider, 0.02, share)
    hand.photograph("first-face")

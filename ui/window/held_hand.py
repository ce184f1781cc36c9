"""What the left button holds: one place takes it back, and keeps other keys from it until the button goes up."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from types import MappingProxyType
from typing import Protocol, runtime_checkable

from PySide6.QtCore import QEvent, QObject, Qt, Signal
from PySide6.QtGui import QAction, QContextMenuEvent, QGuiApplication, QKeyEvent, QKeySequence, QMouseEvent
from PySide6.QtWidgets import QApplication, QLineEdit, QWidget
from shiboken6 import isValid

from app.tools.toolbox import ToolBox
from ui.viewport.tool_hands import ToolHands

TakeBack = Callable[[], bool]
"""Puts back what was before the drag under way; says whether anything was in hand."""

TAKE_BACK = ("edit.undo", "edit.redo")
"""Ids of the actions that go from step to step, which nobody can mean while a step is still being made."""

_Kind, _Key = QEvent.Type, Qt.Key
LEFT, RIGHT = Qt.MouseButton.LeftButton, Qt.MouseButton.RightButton

PRESSES = frozenset((_Kind.MouseButtonPress, _Kind.MouseButtonDblClick))
KEYS = frozenset((_Kind.ShortcutOverride, _Kind.KeyPress, _Kind.KeyRelease))
HEARD = PRESSES | KEYS | {_Kind.MouseButtonRelease, _Kind.ContextMenu}

MODIFIERS = frozenset((_Key.Key_Shift, _Key.Key_Control, _Key.Key_Alt, _Key.Key_AltGr, _Key.Key_Meta))
"""Keys that change a gesture under way instead of meaning something by themselves."""


@runtime_checkable
class Holder(Protocol):
    """A control that is changed by dragging."""

    def take_back(self) -> bool:
        """Put back what was before the drag under way; whether anything was in hand."""


class HeldHand(QObject):
    """Hears all windows: a panel that floats is one of its own, and has the keyboard for itself.

    While the left button is down on a control that can be dragged, the right button, Esc, undo and redo take the drag
    back, and other keys do nothing: half a gesture is neither saved nor deleted, nor are its grounds changed under it.
    What holds nothing, such as a text that is being marked, a menu or a scroll bar, keeps its keys.

    Parameters
    ----------
    parent : with which it ends
    actions : by id; the keys of undo and redo are theirs
    lent : how that is taken back which something else does by dragging on a widget

    Signals
    -------
    refused() : a key was kept from what it is for
    freed() : what was held then has been let go or taken back
    """

    refused = Signal()
    freed = Signal()

    def __init__(
        self,
        parent: QObject,
        actions: Mapping[str, QAction],
        lent: Mapping[QWidget, TakeBack] = MappingProxyType({}),
    ) -> None:
        super().__init__(parent)
        self._actions, self._lent = actions, lent
        self._held: tuple[tuple[QWidget, TakeBack], ...] = ()
        self._right = False
        self._refused: set[int] = set()
        self._told = False
        QApplication.instance().installEventFilter(self)

    @property
    def holds(self) -> bool:
        """Whether the left button is down on something that can be dragged."""
        return bool(self._held) and bool(QGuiApplication.mouseButtons() & LEFT)

    def take_back(self) -> bool:
        """End the drag under way, so that all is as it was before; whether there was one."""
        return self.holds and any(isValid(widget) and take_back() for widget, take_back in self._held)

    def close(self) -> None:
        """Hear nothing any more."""
        QApplication.instance().removeEventFilter(self)

    def eventFilter(self, watched: QObject, event: QEvent) -> bool:
        """Hear presses and keys before those they are for; whether they are kept from them."""
        if event.type() not in HEARD or not isinstance(watched, QWidget):
            return False
        kept = self._keeps(watched, event)
        if kept:
            event.accept()
        return kept

    def _keeps(self, watched: QWidget, event: QEvent) -> bool:
        if isinstance(event, QContextMenuEvent):
            return self.holds or (self._right and event.reason() == QContextMenuEvent.Reason.Mouse)
        if isinstance(event, QKeyEvent) and event.type() == _Kind.KeyRelease:
            return self._keeps_release(event)
        if isinstance(event, QKeyEvent):
            return self.holds and not self._is_typed_into(watched) and self._keeps_key(event)
        if isinstance(event, QMouseEvent) and event.type() in PRESSES:
            return self._press(watched, event.button())
        if isinstance(event, QMouseEvent):
            return self._release(event.button())
        return False

    def _press(self, watched: QWidget, button: Qt.MouseButton) -> bool:
        if button == LEFT:
            self._held = tuple(self._holders(watched))
        self._right = button == RIGHT and self.holds
        if self._right:
            self.take_back()
        return self._right

    def _release(self, button: Qt.MouseButton) -> bool:
        """The menu of a right press may come after its release, so that press is forgotten only with the next."""
        if button == LEFT:
            self._held = ()
            self._free()
        return button == RIGHT and self._right

    def _is_typed_into(self, watched: QWidget) -> bool:
        """Whether it is a field that a second click has opened on what is pressed."""
        return isinstance(watched, QLineEdit) and any(each.isAncestorOf(watched) for each, _ in self._held)

    def _keeps_key(self, event: QKeyEvent) -> bool:
        if event.key() in MODIFIERS:
            return False
        if event.type() == _Kind.KeyPress:
            if not event.isAutoRepeat():
                self._refused.add(event.key())
            if self._takes_back(event):
                self.take_back()
                self._free()
            elif not event.isAutoRepeat():
                self._told = True
                self.refused.emit()
        return True

    def _free(self) -> None:
        if self._told:
            self._told = False
            self.freed.emit()

    def _keeps_release(self, event: QKeyEvent) -> bool:
        """A key that nobody heard go down is not heard to go up: on a button that is held, Space would be a click."""
        refused = event.key() in self._refused
        if refused and not event.isAutoRepeat():
            self._refused.discard(event.key())
        return refused

    def _takes_back(self, event: QKeyEvent) -> bool:
        pressed = QKeySequence(event.keyCombination())
        keys = [keys for each in TAKE_BACK if each in self._actions for keys in self._actions[each].shortcuts()]
        return event.key() == _Key.Key_Escape or pressed in keys

    def _holders(self, pressed: QWidget) -> list[tuple[QWidget, TakeBack]]:
        """Whoever may be dragged by a press on a widget: it, or what it is a part of."""
        found: list[tuple[QWidget, TakeBack]] = []
        widget: QWidget | None = pressed
        while widget is not None:
            if widget in self._lent:
                found.append((widget, self._lent[widget]))
            elif isinstance(widget, Holder):
                found.append((widget, widget.take_back))
            widget = None if widget.isWindow() else widget.parentWidget()
        return found


def tool_in_hand(hands: ToolHands, toolbox: ToolBox) -> TakeBack:
    """How the gesture of a tool on the face is taken back; what the mouse has already done is brought to it first."""

    def take_back() -> bool:
        hands.flush()
        return toolbox.cancel()

    return take_back

"""What the hand does to a bar that carries a number, whatever the number stands for."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QSize, Qt
from PySide6.QtGui import QContextMenuEvent, QEnterEvent, QFocusEvent, QKeyEvent, QMouseEvent, QWheelEvent
from PySide6.QtWidgets import QSizePolicy

from app.arithmetic import evaluate
from ui.theme.metrics import GRID, ROW
from ui.widgets.number_edit import NumberEdit
from ui.widgets.number_scale import NumberDrag
from ui.widgets.weight_gestures import Drag

OWN_KEYS = frozenset(
    {
        Qt.Key.Key_Left,
        Qt.Key.Key_Right,
        Qt.Key.Key_Up,
        Qt.Key.Key_Down,
        Qt.Key.Key_Home,
        Qt.Key.Key_End,
        Qt.Key.Key_PageUp,
        Qt.Key.Key_PageDown,
        Qt.Key.Key_Backspace,
        Qt.Key.Key_Delete,
        Qt.Key.Key_Return,
        Qt.Key.Key_Enter,
        Qt.Key.Key_F2,
    }
)
"""Keys that act on the bar in focus, whatever the window has bound them to."""


class BarHands:
    """Mixed into a widget with the signals ``committed``, ``cancelled`` and ``hovered``; the events of a bar.

    The widget says what its number is: `reset`, and the members below it that begin with an underscore and are
    not defined here: ``_written`` is the number as it is opened for typing, ``_stepped`` what a key asks for,
    ``_grasp`` the drag that a press begins, ``_restore`` shows what a drag began with, ``_show_and_tell`` shows
    and previews a number, ``_enter`` takes a typed one.  It may say how what is typed is read.
    """

    def _read(self, text: str) -> float:
        """The number that a typed text means; raises `NumberError` if it means none."""
        return evaluate(text)

    def _get_ready(self, label: str) -> None:
        """Be a bar in one row of a panel; called by the widget once it is constructed."""
        self._drag: Drag | NumberDrag | None = None
        self._stepping = False
        self._editor: NumberEdit | None = None
        self.setFocusPolicy(Qt.FocusPolicy.StrongFocus)
        self.setAttribute(Qt.WidgetAttribute.WA_Hover)
        self.setCursor(Qt.CursorShape.SizeHorCursor)
        self.setSizePolicy(QSizePolicy.Policy.Expanding, QSizePolicy.Policy.Fixed)
        self.setAccessibleName(label)

    def take_back(self) -> bool:
        """End the drag under way as if it had never been; whether there was one."""
        drag, self._drag = self._drag, None
        if drag is not None and drag.moving:
            self._restore(drag)
            self.cancelled.emit()
        self.update()
        return drag is not None

    def edit(self) -> None:
        """Open the number for typing."""
        if self._editor is None and self.isEnabled():
            self._editor = NumberEdit(self, self._written(), self._read)
            self._editor.entered.connect(self._enter)
            self._editor.dismissed.connect(self._close_editor)

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Take hold; the right button resets."""
        if event.button() == Qt.MouseButton.LeftButton:
            self._drag = self._grasp(event.position().x())
        elif event.button() == Qt.MouseButton.RightButton:
            self.reset()

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """Let go: a drag is kept."""
        if event.button() != Qt.MouseButton.LeftButton:
            return
        drag, self._drag = self._drag, None
        self.update()
        if drag is not None and drag.moving:
            self.committed.emit()

    def mouseDoubleClickEvent(self, event: QMouseEvent) -> None:
        """Edit the number."""
        if event.button() == Qt.MouseButton.LeftButton:
            self._drag = None
            self.edit()

    def contextMenuEvent(self, event: QContextMenuEvent) -> None:
        """No menu: the right button has a meaning of its own."""
        event.accept()

    def wheelEvent(self, event: QWheelEvent) -> None:
        """The wheel scrolls the panel and never changes a number by accident."""
        event.ignore()

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Step, edit or reset."""
        key = event.key()
        if key in (Qt.Key.Key_Return, Qt.Key.Key_Enter, Qt.Key.Key_F2):
            self.edit()
        elif key in (Qt.Key.Key_Backspace, Qt.Key.Key_Delete):
            self.reset()
        elif (target := self._stepped(key, event.modifiers())) is not None:
            self._stepping = True
            self._show_and_tell(target)
        else:
            event.ignore()

    def keyReleaseEvent(self, event: QKeyEvent) -> None:
        """A key held down is one gesture."""
        if not event.isAutoRepeat():
            self._finish_steps()
        event.ignore()

    def event(self, event: QEvent) -> bool:
        """Keep the keys that mean something here, before a shortcut of the window takes them."""
        override = isinstance(event, QKeyEvent) and event.type() == QEvent.Type.ShortcutOverride
        if override and event.key() in OWN_KEYS:
            event.accept()
            return True
        return super().event(event)

    def enterEvent(self, event: QEnterEvent) -> None:
        """Say that the pointer came."""
        super().enterEvent(event)
        self.hovered.emit(True)

    def leaveEvent(self, event: QEvent) -> None:
        """Say that the pointer went."""
        super().leaveEvent(event)
        self.hovered.emit(False)

    def focusOutEvent(self, event: QFocusEvent) -> None:
        """Finish what the keys began."""
        super().focusOutEvent(event)
        self._finish_steps()

    def sizeHint(self) -> QSize:
        """One row, wide enough for a short name."""
        return QSize(20 * GRID, ROW - 2)

    def _finish_steps(self) -> None:
        if self._stepping:
            self._stepping = False
            self.committed.emit()

    def _close_editor(self) -> None:
        editor, self._editor = self._editor, None
        if editor is not None:
            editor.go_away()

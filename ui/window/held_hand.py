"""Undo in the middle of a drag: the drag is what is taken back."""

from __future__ import annotations

from collections.abc import Mapping

from PySide6.QtCore import QEvent, Qt
from PySide6.QtGui import QAction, QGuiApplication, QKeyEvent, QKeySequence
from PySide6.QtWidgets import QApplication

TAKE_BACK = ("edit.undo", "edit.redo")
"""Ids of the actions that go from step to step, which nobody can mean while a step is still being made."""


def takes_back(event: QKeyEvent, actions: Mapping[str, QAction]) -> bool:
    """Whether a key would undo or redo in the middle of a drag; that is then over, see `end_drag`."""
    pressed = QKeySequence(event.keyCombination())
    keys = [keys for each in TAKE_BACK if each in actions for keys in actions[each].shortcuts()]
    return pressed in keys and end_drag()


def end_drag() -> bool:
    """End the drag under way just as Esc does, so that all is as it was before; whether a button is down at all."""
    if not QGuiApplication.mouseButtons() & Qt.MouseButton.LeftButton:
        return False
    held = QApplication.focusWidget()
    if held is not None:
        escape = QKeyEvent(QEvent.Type.KeyPress, Qt.Key.Key_Escape, Qt.KeyboardModifier.NoModifier)
        QApplication.sendEvent(held, escape)
    return True

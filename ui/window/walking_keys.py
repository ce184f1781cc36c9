"""Keys that walk within a panel, and so are not the window's while something there has the keyboard."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtGui import QKeyEvent
from PySide6.QtWidgets import QAbstractItemView, QAbstractSlider, QComboBox, QTabBar, QWidget

_Key = Qt.Key

ENDS = (_Key.Key_Home, _Key.Key_End, _Key.Key_PageUp, _Key.Key_PageDown)
ARROWS = (_Key.Key_Up, _Key.Key_Down, _Key.Key_Left, _Key.Key_Right)
WALKED = (QComboBox, QAbstractItemView, QTabBar, QAbstractSlider)
"""Widgets that go to their ends and along by these keys, but let a shortcut of the window have them first."""


def walks(event: QKeyEvent, focus: QWidget | None, face: QWidget) -> bool:
    """Whether a key that is pressed belongs to what has the keyboard, and not to the window.

    Parameters
    ----------
    event : the key
    focus : what has the keyboard
    face : where keys belong to the window: Tab goes on from there to the next workspace
    """
    if event.modifiers() & ~Qt.KeyboardModifier.KeypadModifier:
        return False
    if event.key() == _Key.Key_Tab:
        return focus is not face
    return event.key() in (*ENDS, *ARROWS) and isinstance(focus, WALKED)

"""Keys that mean something while the timeline has the focus, whatever the window has bound them to."""

from __future__ import annotations

from collections.abc import Mapping

from PySide6.QtCore import Qt
from PySide6.QtGui import QKeyEvent

Key = Qt.Key
NONE = Qt.KeyboardModifier.NoModifier
CTRL = Qt.KeyboardModifier.ControlModifier
ALT = Qt.KeyboardModifier.AltModifier

OWN: Mapping[tuple[Qt.Key, Qt.KeyboardModifier], str] = {
    (Key.Key_Delete, NONE): "timeline.delete",
    (Key.Key_Backspace, NONE): "timeline.delete",
    (Key.Key_X, NONE): "timeline.delete",
    (Key.Key_X, CTRL): "timeline.cut",
    (Key.Key_C, CTRL): "timeline.copy",
    (Key.Key_V, CTRL): "timeline.paste",
    (Key.Key_D, CTRL): "timeline.duplicate",
    (Key.Key_A, NONE): "timeline.all",
    (Key.Key_A, CTRL): "timeline.all",
    (Key.Key_I, CTRL): "timeline.others",
    (Key.Key_C, NONE): "timeline.column",
    (Key.Key_M, NONE): "timeline.mirror",
    (Key.Key_K, NONE): "timeline.key",
    (Key.Key_S, NONE): "timeline.key",
    (Key.Key_Left, NONE): "timeline.frame-back",
    (Key.Key_Right, NONE): "timeline.frame-on",
    (Key.Key_Left, CTRL): "timeline.key-back",
    (Key.Key_Right, CTRL): "timeline.key-on",
    (Key.Key_Left, ALT): "timeline.nudge-back",
    (Key.Key_Right, ALT): "timeline.nudge-on",
    (Key.Key_Home, NONE): "timeline.frame-all",
    (Key.Key_F, NONE): "timeline.frame-chosen",
}
"""Ids of actions."""


def action_of(event: QKeyEvent) -> str:
    """The id of the action that a key means here; empty if none."""
    held = event.modifiers() & ~Qt.KeyboardModifier.KeypadModifier
    return next((key for (code, keys), key in OWN.items() if code == event.key() and keys == held), "")

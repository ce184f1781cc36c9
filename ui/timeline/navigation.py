"""Moving about in time: the wheel zooms to the pointer, the middle button pans, Shift scrolls the lines."""

from __future__ import annotations

from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QMouseEvent, QWheelEvent

from ui.timeline.view import TimelineView

NOTCH = 120.0
"""Eighths of a degree that a wheel turns from one notch to the next."""

STEP = 1.2
"""Zoom of one notch."""

PAGE = 90.0
"""Pixels along which a notch pans in time."""

ROWS = 48.0
"""Pixels by which a notch scrolls the lines."""

Keys = Qt.KeyboardModifier


class Navigator:
    """What wheel and middle button do to a view, the same in all parts of the timeline.

    Parameters
    ----------
    view : what is moved about in

    Attributes
    ----------
    last : where the middle button was last; none while it is up
    about : where it went down
    zooms : whether it zooms
    """

    def __init__(self, view: TimelineView) -> None:
        self._view = view
        self.last: QPointF | None = None
        self.about = QPointF()
        self.zooms = False

    def turn(self, event: QWheelEvent) -> None:
        """Zoom to the pointer; with Ctrl go along in time, with Shift through the lines; sideways as it says."""
        across, along = event.angleDelta().x() / NOTCH, event.angleDelta().y() / NOTCH
        held = event.modifiers()
        if held & Keys.ControlModifier:
            self._view.see(self._view.scale.panned(PAGE * (along or across)))
        elif held & Keys.ShiftModifier:
            self._view.scroll(self._view.top - ROWS * (along or across))
        elif abs(across) > abs(along):
            self._view.see(self._view.scale.panned(PAGE * across))
        else:
            self._view.see(self._view.scale.zoomed(STEP**along, event.position().x()))
        event.accept()

    def press(self, event: QMouseEvent) -> bool:
        """Take hold with the middle button: pan, or zoom with Ctrl; whether it was that."""
        if event.button() != Qt.MouseButton.MiddleButton:
            return False
        self.last = self.about = event.position()
        self.zooms = bool(event.modifiers() & Keys.ControlModifier)
        return True

    def move(self, event: QMouseEvent) -> bool:
        """What is seen goes along with the hand; whether it is held."""
        if self.last is None:
            return False
        gone, self.last = event.position() - self.last, event.position()
        if self.zooms:
            self._view.see(self._view.scale.zoomed(STEP ** (gone.x() / 20.0), self.about.x()))
        else:
            self._view.see(self._view.scale.panned(gone.x()))
            self._view.scroll(self._view.top - gone.y())
        return True

    def release(self, event: QMouseEvent) -> bool:
        """Let go; whether it was held."""
        if self.last is None or event.button() != Qt.MouseButton.MiddleButton:
            return False
        self.last = None
        return True

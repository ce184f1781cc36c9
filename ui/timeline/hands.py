"""A hand on a part of the timeline: a click chooses, a drag begins a gesture."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

from PySide6.QtCore import QPointF, Qt
from PySide6.QtGui import QMouseEvent

from app.timeline.gestures import Gesture, Spot
from facemodel.errors import RisoriusError
from ui.widgets.weight_gestures import THRESHOLD

Keys = Qt.KeyboardModifier


@dataclass(frozen=True)
class Grip:
    """What a press has taken hold of.

    Attributes
    ----------
    begin : begins the gesture once the hand moves; it is given the spot of the press
    click : what a release without moving does; it is given the spot
    at_once : whether the gesture begins with the press itself
    """

    begin: Callable[[Spot], Gesture] | None = None
    click: Callable[[Spot], None] | None = None
    at_once: bool = False


class Hands:
    """Turns presses and moves into gestures.

    Parameters
    ----------
    spot : where a point of the widget is, with the keys that are held
    grasp : what a press takes hold of
    advise : is told what keys change about the gesture; empty when it is over
    failed : is told why a gesture came to nothing
    """

    def __init__(
        self,
        spot: Callable[[QPointF, Keys], Spot],
        grasp: Callable[[QPointF, Spot], Grip],
        advise: Callable[[str], None],
        failed: Callable[[str], None],
    ) -> None:
        self._spot, self._grasp = spot, grasp
        self._advise, self._failed = advise, failed
        self._grip: Grip | None = None
        self._pressed = QPointF()
        self._first: Spot | None = None
        self._last: tuple[QPointF, Keys] | None = None
        self.gesture: Gesture | None = None

    @property
    def busy(self) -> bool:
        """Whether the button is down on something."""
        return self._grip is not None

    def press(self, event: QMouseEvent) -> None:
        """The left button goes down."""
        self._pressed = event.position()
        self._grip = self._grasp(event.position(), self._spot(event.position(), event.modifiers()))
        # What is held may say how values are measured: only now is it known where the hand is.
        self._first = self._spot(event.position(), event.modifiers())
        if self._grip.at_once:
            self._begin()

    def move(self, event: QMouseEvent) -> None:
        """The pointer moves."""
        if self._grip is None:
            return
        away = (event.position() - self._pressed).manhattanLength()
        if self.gesture is None and self._grip.begin is not None and away >= THRESHOLD:
            self._begin()
        self._last = event.position(), event.modifiers()
        self._go_on()

    def keys(self, modifiers: Keys) -> None:
        """Other keys are held than before."""
        if self._last is not None:
            self._last = self._last[0], modifiers
            self._go_on()

    def release(self, event: QMouseEvent) -> None:
        """The button goes up: what was done stays, or it was a click."""
        grip, self._grip = self._grip, None
        gesture, self.gesture = self.gesture, None
        self._last = None
        if gesture is not None:
            self._try(lambda: gesture.release(self._spot(event.position(), event.modifiers())), gesture)
            self._advise("")
        elif grip is not None and grip.click is not None:
            click = grip.click
            self._try(lambda: click(self._spot(event.position(), event.modifiers())))

    def cancel(self) -> bool:
        """Let go of what is held and undo what was done with it; whether there was anything."""
        held, gesture, self.gesture = self.busy, self.gesture, None
        self._grip = self._last = None
        if gesture is not None:
            gesture.cancel()
            self._advise("")
        return held

    def _begin(self) -> None:
        assert self._grip is not None
        assert self._first is not None
        begin, first = self._grip.begin, self._first

        def start() -> None:
            if begin is not None:
                self.gesture = begin(first)
                self._advise(self.gesture.advice)

        self._try(start)

    def _go_on(self) -> None:
        gesture, last = self.gesture, self._last
        if gesture is not None and last is not None:
            self._try(lambda: gesture.move(self._spot(*last)), gesture)

    def _try(self, act: Callable[[], None], gesture: Gesture | None = None) -> None:
        """Act; what cannot be done is told, and the gesture ends without a trace."""
        try:
            act()
        except RisoriusError as error:
            if gesture is not None:
                gesture.cancel()
            self.gesture = self._grip = None
            self._advise("")
            self._failed(str(error))

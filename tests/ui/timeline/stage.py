"""Hands on the timeline: where things are, and what a mouse does there."""

from dataclasses import dataclass

from PySide6.QtCore import QEvent, QPoint, QPointF, Qt, QTimer
from PySide6.QtGui import QContextMenuEvent, QMouseEvent, QWheelEvent
from PySide6.QtTest import QSignalSpy, QTest
from PySide6.QtWidgets import QApplication, QMainWindow, QWidget
from shiboken6 import isValid

from app.actions import Context
from app.timeline.timeline import Timeline
from facemodel.animation.clip import Animation
from facemodel.animation.curve import Curve
from facemodel.animation.editing.selection import curve_of_row
from tests.ui.hands import move
from ui.timeline.panel import TimelinePanel
from ui.timeline.transport import Transport
from ui.timeline.view import TimelineView

LEFT = Qt.MouseButton.LeftButton
NONE = Qt.KeyboardModifier.NoModifier
CTRL, SHIFT, ALT = (
    Qt.KeyboardModifier.ControlModifier,
    Qt.KeyboardModifier.ShiftModifier,
    Qt.KeyboardModifier.AltModifier,
)

MOMENT = 60
"""Milliseconds for which the panel lets things change further before it follows, twice over."""


@dataclass
class Stage:
    """A window with nothing but a timeline."""

    window: QMainWindow
    context: Context
    timeline: Timeline
    view: TimelineView
    panel: TimelinePanel
    transport: Transport
    opened: list[str]

    @property
    def animation(self) -> Animation:
        return self.timeline.animation

    @property
    def steps(self) -> tuple[str, ...]:
        return self.context.document.history.done

    def curve(self, channel: str, layer: int = 0) -> Curve:
        return curve_of_row(self.animation, (channel, layer))

    def at(self, key: str, time: float, share: float = 0.5) -> QPoint:
        """Where a time lies on a line of the sheet, at a share of its height."""
        placed = self.view.layout.of(key)
        assert placed is not None, [line.key for line in self.view.lines]
        return QPoint(round(self.view.scale.x(time)), round(placed.top - self.view.top + share * placed.height))

    def x(self, time: float) -> int:
        return round(self.view.scale.x(time))

    def click(self, place: QPoint, held: Qt.KeyboardModifier = NONE, widget: QWidget | None = None) -> None:
        QTest.mouseClick(widget or self.panel.sheet, LEFT, held, place)

    def drag(
        self,
        start: QPoint,
        end: QPoint,
        held: Qt.KeyboardModifier = NONE,
        widget: QWidget | None = None,
        release: bool = True,
    ) -> None:
        target = widget or self.panel.sheet
        QTest.mousePress(target, LEFT, held, start)
        for step in range(1, 7):
            move(target, start + (end - start) * step / 6, held)
        if release:
            QTest.mouseRelease(target, LEFT, held, end)

    def press_right(self, place: QPoint, widget: QWidget | None = None) -> None:
        """Press the right button, upon which the system asks for a menu."""
        target = widget or self.panel.sheet
        QTest.mousePress(target, Qt.MouseButton.RightButton, pos=place)
        mouse = QContextMenuEvent.Reason.Mouse
        QApplication.sendEvent(target, QContextMenuEvent(mouse, place, target.mapToGlobal(place)))
        QTest.mouseRelease(target, Qt.MouseButton.RightButton, pos=place)

    def wheel(self, widget: QWidget, place: QPoint, notches: float, held: Qt.KeyboardModifier = NONE) -> None:
        spot = QPointF(place)
        delta = QPoint(0, round(120 * notches))
        event = QWheelEvent(
            spot,
            QPointF(widget.mapToGlobal(place)),
            QPoint(),
            delta,
            Qt.MouseButton.NoButton,
            held,
            Qt.ScrollPhase.NoScrollPhase,
            False,
        )
        QApplication.sendEvent(widget, event)

    def pan(self, widget: QWidget, start: QPoint, end: QPoint, held: Qt.KeyboardModifier = NONE) -> None:
        """Drag with the middle button."""
        middle = Qt.MouseButton.MiddleButton
        for kind, place, button in (
            (QEvent.Type.MouseButtonPress, start, middle),
            (QEvent.Type.MouseMove, end, Qt.MouseButton.NoButton),
            (QEvent.Type.MouseButtonRelease, end, middle),
        ):
            spot = QPointF(place)
            QApplication.sendEvent(
                widget, QMouseEvent(kind, spot, QPointF(widget.mapToGlobal(place)), button, middle, held)
            )

    def key(self, key: Qt.Key, held: Qt.KeyboardModifier = NONE, widget: QWidget | None = None) -> None:
        target = widget or self.panel.sheet
        target.setFocus()
        QTest.keyClick(target, key, held)

    def settle(self) -> None:
        """Let what comes a moment later come, however long a busy machine takes to get to it."""
        QTest.qWait(MOMENT)
        timers = [timer for timer in self.window.findChildren(QTimer) if timer.isSingleShot() and timer.isActive()]
        soon = [(timer, QSignalSpy(timer.timeout)) for timer in timers if timer.interval() <= MOMENT]
        while any(isValid(timer) and timer.isActive() and not spy.count() for timer, spy in soon):
            QTest.qWait(1)

"""Hands: what a mouse does, as events."""

from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QEnterEvent, QGuiApplication, QMouseEvent
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QApplication, QWidget


def drag(
    widget: QWidget,
    start: float,
    end: float,
    modifiers: Qt.KeyboardModifier = Qt.KeyboardModifier.NoModifier,
    release: bool = True,
    steps: int = 8,
) -> None:
    """Drag the left button across a widget, from and to shares of its width."""
    y = widget.height() // 2
    xs = [round(widget.width() * (start + (end - start) * k / steps)) for k in range(steps + 1)]
    QTest.mousePress(widget, Qt.MouseButton.LeftButton, modifiers, QPoint(xs[0], y))
    for x in xs[1:]:
        move(widget, QPoint(x, y), modifiers)
    if release:
        QTest.mouseRelease(widget, Qt.MouseButton.LeftButton, modifiers, QPoint(xs[-1], y))
    QApplication.processEvents()


def move(widget: QWidget, place: QPoint, modifiers: Qt.KeyboardModifier = Qt.KeyboardModifier.NoModifier) -> None:
    """Move the pointer with the left button held; QTest itself has no modifiers for that."""
    left = Qt.MouseButton.LeftButton
    event = QMouseEvent(
        QEvent.Type.MouseMove,
        QPointF(place),
        QPointF(widget.mapToGlobal(place)),
        Qt.MouseButton.NoButton,
        left,
        modifiers,
    )
    QApplication.sendEvent(widget, event)


def enter(widget: QWidget) -> None:
    """Bring the pointer over a widget."""
    place = QPointF(widget.rect().center())
    QApplication.sendEvent(widget, QEnterEvent(place, place, QPointF(widget.mapToGlobal(widget.rect().center()))))


def leave(widget: QWidget) -> None:
    """Take the pointer off a widget."""
    QApplication.sendEvent(widget, QEvent(QEvent.Type.Leave))


def let_go(widget: QWidget) -> None:
    """Release the buttons that other tests hold."""
    for button in (Qt.MouseButton.LeftButton, Qt.MouseButton.RightButton, Qt.MouseButton.MiddleButton):
        QTest.mouseRelease(widget, button)
    assert QGuiApplication.mouseButtons() == Qt.MouseButton.NoButton

"""The left button, and what else the hand tells the tool in hand; Alt, right and middle button are the camera's."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QObject, QPointF, Qt, QTimer
from PySide6.QtGui import QMouseEvent, QTabletEvent, QWheelEvent
from PySide6.QtWidgets import QWidget

from app.tools.pointer import Modifier, Pointer
from app.tools.toolbox import ToolBox
from ui.viewport.scene import Scene
from ui.viewport.tool_sight import ToolSight

Keys = Qt.KeyboardModifier

MODIFIERS: tuple[tuple[Keys, Modifier], ...] = ((Keys.ShiftModifier, "shift"), (Keys.ControlModifier, "control"))

NOTCH = 120.0
"""Eighths of a degree that a wheel turns from one notch to the next."""

STRIDE = 2.0
"""Pixels between two places of a stroke that are told apart; between them it is straight."""

PAINTING = frozenset(("brush", "fill", "sculpt", "bone-brush"))
"""Tools that work with a brush, whose size the wheel changes."""


class ToolHands(QObject):
    """Watches a canvas and routes the pointer to the tool in hand.

    What happens between two turns of the event loop is brought to the tool at once and in order, so that a stroke goes
    through every place where the mouse was, while of several places that it only passed over the last one counts.

    Parameters
    ----------
    canvas : the widget that the face is drawn on
    scene : the face
    toolbox : the tools
    """

    def __init__(self, canvas: QWidget, scene: Scene, toolbox: ToolBox) -> None:
        super().__init__(canvas)
        self._canvas = canvas
        self._toolbox = toolbox
        self.sight = ToolSight(scene)
        self.active = False
        self._waiting: list[tuple[QPointF, Keys, float]] = []
        self._pressure = 1.0
        self._timer = QTimer(self, singleShot=True, interval=0)
        self._timer.timeout.connect(self.flush)
        toolbox.bench.projector = self.sight
        canvas.setMouseTracking(True)
        canvas.installEventFilter(self)

    def activate(self, on: bool) -> None:
        """Listen to the pointer, or leave it to others."""
        if self.active and not on:
            self._drop()
            self._toolbox.cancel()
            self._toolbox.leave()
        self.active = on

    def flush(self) -> None:
        """Bring the tool everything that has happened."""
        self._timer.stop()
        waiting, self._waiting = self._waiting, []
        for place, modifiers, pressure in waiting:
            self._toolbox.move(self._pointer(place, modifiers, pressure))

    def eventFilter(self, _watched: QObject, event: QEvent) -> bool:
        """Hear an event; only what would mean something else to the camera is kept from it."""
        if not self.active:
            return False
        if isinstance(event, QWheelEvent):
            return self._turn(event)
        if isinstance(event, QMouseEvent):
            self._hear(event)
        elif isinstance(event, QTabletEvent):
            self._feel(event)
        elif event.type() == QEvent.Type.Leave:
            self._drop()
            self._toolbox.leave()
        return False

    def _hear(self, event: QMouseEvent) -> None:
        """Bring the tool what the mouse does."""
        left = event.button() == Qt.MouseButton.LeftButton
        alt = bool(event.modifiers() & Keys.AltModifier)
        kind = event.type()
        if kind in (QEvent.Type.MouseButtonPress, QEvent.Type.MouseButtonDblClick):
            self._drop()
            if left and not alt:
                self._toolbox.press(self._pointer(event.position(), event.modifiers(), self._pressure))
            elif not self._toolbox.busy:
                self._toolbox.leave()
        elif kind == QEvent.Type.MouseMove:
            self._moved(event)
        elif kind == QEvent.Type.MouseButtonRelease and left and self._toolbox.busy:
            self.flush()
            self._toolbox.release(self._pointer(event.position(), event.modifiers(), self._pressure))

    def _moved(self, event: QMouseEvent) -> None:
        if not self._toolbox.busy:
            if event.buttons() != Qt.MouseButton.NoButton:
                return
            self._waiting.clear()
        elif self._waiting:
            last = self._waiting[-1][0]
            if (event.position() - last).manhattanLength() < STRIDE:
                self._waiting.pop()
        self._waiting.append((event.position(), event.modifiers(), self._pressure))
        if not self._timer.isActive():
            self._timer.start()

    def _turn(self, event: QWheelEvent) -> bool:
        """The wheel with Ctrl is the size of the brush, with Shift its strength."""
        notches = event.angleDelta().y() / NOTCH
        brush = self._toolbox.tool.brush
        if not notches or self._toolbox.tool.id not in PAINTING:
            return False
        if event.modifiers() == Keys.ControlModifier:
            brush.resize(notches)
        elif event.modifiers() == Keys.ShiftModifier:
            brush.strengthen(notches)
        else:
            return False
        return True

    def _feel(self, event: QTabletEvent) -> None:
        """How hard a pen presses; Qt goes on to tell where it is as if it were a mouse."""
        lifted = event.type() == QEvent.Type.TabletRelease
        self._pressure = 1.0 if lifted else float(event.pressure())
        event.ignore()

    def _drop(self) -> None:
        self._timer.stop()
        self._waiting.clear()

    def _pointer(self, place: QPointF, held: Keys, pressure: float) -> Pointer:
        self.sight.scale = self._canvas.devicePixelRatioF()
        names = [name for key, name in MODIFIERS if held & key]
        tool = self._toolbox.tool
        return self.sight.pointer(place.x(), place.y(), names, pressure, tool.asks_skull, tool.asks_skin)

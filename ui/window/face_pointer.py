"""The pointer on the face: the muscle under it is named, a click selects it."""

from __future__ import annotations

from PySide6.QtCore import QEvent, QObject, QPoint, QPointF, Qt, QTimer, Signal
from PySide6.QtGui import QMouseEvent

from facemodel.muscles import Muscle
from ui.viewport.scene import Scene
from ui.widgets.weight_gestures import THRESHOLD
from ui.window.canvas import Canvas

REST = 60
"""Milliseconds that the pointer rests before the face is asked what lies under it: a ray against every triangle."""


class FacePointer(QObject):
    """Watches the canvas without taking anything from it.

    Signals
    -------
    pointed(object, QPoint) : the Muscle under the pointer, or None, and where the pointer is on the canvas
    clicked(object) : the Muscle that was clicked

    Attributes
    ----------
    awake : whether it listens; a tool in hand has the pointer for itself
    """

    pointed = Signal(object, QPoint)
    clicked = Signal(object)

    def __init__(self, canvas: Canvas, scene: Scene) -> None:
        super().__init__(canvas)
        self._canvas = canvas
        self._scene = scene
        self._place = QPoint()
        self._pressed_at: QPointF | None = None
        self.awake = True
        self._timer = QTimer(self, singleShot=True, interval=REST)
        self._timer.timeout.connect(lambda: self.pointed.emit(self.muscle_at(self._place), self._place))
        canvas.installEventFilter(self)

    def muscle_at(self, place: QPoint) -> Muscle | None:
        """The muscle that pulls most on the skin under a point of the canvas."""
        scale = self._canvas.devicePixelRatioF()
        return self._scene.muscle_at(place.x() * scale, (self._canvas.height() - 1 - place.y()) * scale)

    def eventFilter(self, _watched: QObject, event: QEvent) -> bool:
        """Listen to the pointer; the camera hears the same events."""
        if not self.awake:
            return False
        if event.type() == QEvent.Type.Leave:
            self._quiet()
        elif isinstance(event, QMouseEvent):
            self._hear(event)
        return False

    def _hear(self, event: QMouseEvent) -> None:
        left = event.button() == Qt.MouseButton.LeftButton
        if event.type() == QEvent.Type.MouseMove and event.buttons() == Qt.MouseButton.NoButton:
            self._place = event.position().toPoint()
            self._timer.start()
        elif event.type() == QEvent.Type.MouseButtonPress:
            self._quiet()
            plain = left and event.modifiers() == Qt.KeyboardModifier.NoModifier
            self._pressed_at = event.position() if plain else None
        elif event.type() == QEvent.Type.MouseButtonRelease and left:
            start, self._pressed_at = self._pressed_at, None
            if start is not None and (event.position() - start).manhattanLength() < THRESHOLD:
                self._click(event.position().toPoint())

    def _click(self, place: QPoint) -> None:
        muscle = self.muscle_at(place)
        if muscle is not None:
            self.clicked.emit(muscle)

    def _quiet(self) -> None:
        self._timer.stop()
        self.pointed.emit(None, self._place)

"""Hands on the camera: right drag or Alt-drag turns about the head, middle drag pans, the wheel zooms to the pointer.

The left button is for tools and is left alone. VTK's own interactor styles are put away, since they roll the head and
take keys such as ``w`` and ``q``.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import Literal

from vtkmodules.vtkRenderingCore import vtkRenderer, vtkRenderWindowInteractor

from fem.types import FloatArray
from ui.viewport.camera import orbit, pan, zoom

TURN = 0.45
"""Degrees per pixel of a drag on a picture 800 pixels high."""
STEP = 1.12
"""Zoom of one notch of the wheel."""
REFERENCE = 800.0

Gesture = Literal["orbit", "pan"]


class CameraHands:
    """Turns mouse events of an interactor into motions of its camera.

    Parameters
    ----------
    interactor : whose events are followed, be they from a window or made by a test
    renderer : whose camera moves
    pivot : where the head's centre is now
    moved : called after every motion; it asks for a picture
    """

    def __init__(
        self,
        interactor: vtkRenderWindowInteractor,
        renderer: vtkRenderer,
        pivot: Callable[[], FloatArray],
        moved: Callable[[], None],
    ) -> None:
        self._interactor, self._renderer = interactor, renderer
        self._pivot, self._moved = pivot, moved
        self._gesture: Gesture | None = None
        self._last = (0, 0)
        interactor.SetInteractorStyle(None)
        self._tags = [
            interactor.AddObserver(name, handler)
            for name, handler in (
                ("LeftButtonPressEvent", self._press_left),
                ("LeftButtonReleaseEvent", self._release),
                ("RightButtonPressEvent", lambda *_: self._press("orbit")),
                ("RightButtonReleaseEvent", self._release),
                ("MiddleButtonPressEvent", lambda *_: self._press("pan")),
                ("MiddleButtonReleaseEvent", self._release),
                ("MouseMoveEvent", self._move),
                ("MouseWheelForwardEvent", lambda *_: self._wheel(STEP)),
                ("MouseWheelBackwardEvent", lambda *_: self._wheel(1 / STEP)),
            )
        ]

    @property
    def busy(self) -> bool:
        """Whether the camera is in hand."""
        return self._gesture is not None

    def let_go(self) -> None:
        """Take the hands off the interactor for good."""
        for tag in self._tags:
            self._interactor.RemoveObserver(tag)
        self._tags.clear()

    def _press_left(self, *_: object) -> None:
        if self._interactor.GetAltKey():
            self._press("orbit")

    def _press(self, gesture: Gesture) -> None:
        self._gesture = gesture
        self._last = self._interactor.GetEventPosition()

    def _release(self, *_: object) -> None:
        self._gesture = None

    def _move(self, *_: object) -> None:
        if self._gesture is None:
            return
        x, y = self._interactor.GetEventPosition()
        dx, dy = x - self._last[0], y - self._last[1]
        self._last = (x, y)
        if dx == dy == 0:
            return
        height = max(1, self._renderer.GetSize()[1])
        camera = self._renderer.GetActiveCamera()
        if self._gesture == "orbit":
            scale = TURN * REFERENCE / height
            orbit(camera, self._pivot(), -scale * dx, -scale * dy)
        else:
            pan(camera, dx / height, dy / height)
        self._changed()

    def _wheel(self, factor: float) -> None:
        width, height = self._renderer.GetSize()
        x, y = self._interactor.GetEventPosition()
        zoom(self._renderer.GetActiveCamera(), factor, (x - width / 2) / height, (y - height / 2) / height)
        self._changed()

    def _changed(self) -> None:
        self._renderer.ResetCameraClippingRange()
        self._moved()

"""The drawing surface: VTK in a Qt widget, painted once per frame and never more."""

from __future__ import annotations

import time
from collections.abc import Callable

from PySide6.QtCore import Qt, QTimer, Signal
from PySide6.QtGui import QMouseEvent
from PySide6.QtWidgets import QWidget
from pyvistaqt import QtInteractor

FRAME = 1 / 60
"""Seconds between two frames at most; a hand moves more often than a screen can show."""


class Canvas(QtInteractor):
    """A pyvista plotter in the window.

    Whatever asks for a picture, be it pyvista, VTK's interactor or the editor, only marks the widget; Qt then paints
    it once.  Before that every function in ``before_frame`` runs, so that what is drawn is the latest state.

    Signals
    -------
    drawn(float) : milliseconds that the last frame took, drawing alone
    """

    drawn = Signal(float)
    _ready = False

    def __init__(self, parent: QWidget, multi_samples: int = 0) -> None:
        super().__init__(parent, auto_update=False, multi_samples=multi_samples)
        self.before_frame: list[Callable[[], None]] = []
        self.frames = 0
        self._painting = False
        self._last = 0.0
        self._timer = QTimer(self, singleShot=True)
        self._timer.timeout.connect(self.update)
        self.setAcceptDrops(False)
        self._ready = True
        self.iren.interactor.EnableRenderOff()
        self.iren.interactor.AddObserver("RenderEvent", lambda *_: self.ask_frame())

    def ask_frame(self) -> None:
        """Have the widget painted at the next frame; many requests make one picture."""
        if self._ready and not self._painting and not self._timer.isActive():
            wait = self._last + FRAME - time.perf_counter()
            self._timer.start(max(0, round(1000 * wait)))

    def render(self, *_args: object, **_kwargs: object) -> None:
        """What pyvista calls after every change: a frame is asked for, not drawn at once."""
        self._rendered = True
        self.ask_frame()

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Tell VTK of the Alt key too, which its Qt widget leaves out."""
        self.iren.interactor.SetAltKey(bool(event.modifiers() & Qt.KeyboardModifier.AltModifier))
        super().mousePressEvent(event)

    def paintGL(self) -> None:
        """Bring the scene up to date and draw it."""
        for prepare in self.before_frame:
            prepare()
        self._painting = True
        start = time.perf_counter()
        self.iren.interactor.EnableRenderOn()
        try:
            super().paintGL()
        finally:
            self.iren.interactor.EnableRenderOff()
            self._painting = False
        self._last = time.perf_counter()
        self.frames += 1
        self.drawn.emit(1000 * (self._last - start))

"""The drawing surface: VTK in a Qt widget, painted once per frame and never more."""

from __future__ import annotations

import time
from collections.abc import Callable

import numpy as np
from numpy.typing import NDArray
from PySide6.QtCore import Qt, QTimer, Signal
from PySide6.QtGui import QKeyEvent, QMouseEvent
from PySide6.QtWidgets import QWidget
from pyvistaqt import QtInteractor

FRAME = 1 / 60
"""Seconds between two frames at most; a hand moves more often than a screen can show."""

SAMPLES = 4
"""Samples per pixel that smooth the edges; more are not seen on skin."""

STILL = 0.25
"""Seconds without a new frame after which a processor that draws in software takes the time for smooth edges."""

SOFTWARE = ("llvmpipe", "softpipe", "swr", "basic render", "swiftshader")
"""Names of drivers that draw without a graphics card; smooth edges cost them four times the frame."""


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

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent, auto_update=False, multi_samples=0)
        self.before_frame: list[Callable[[], None]] = []
        self.frames = 0
        self._painting = False
        self._last = 0.0
        self._timer = QTimer(self, singleShot=True)
        self._timer.timeout.connect(self.update)
        self._software: bool | None = None
        self._smooth = False
        self._still = QTimer(self, singleShot=True, interval=round(1000 * STILL))
        self._still.timeout.connect(self._refine)
        self.setAcceptDrops(False)
        # Pyvista would put a style of VTK's in force at every double click, which turns and rolls the head.
        self.iren.untrack_click_position("left")
        self._ready = True
        self.iren.interactor.EnableRenderOff()
        self.iren.interactor.AddObserver("RenderEvent", lambda *_: self.ask_frame())

    def ask_frame(self) -> None:
        """Have the widget painted at the next frame; many requests make one picture."""
        if self._ready and not self._painting and not self._timer.isActive():
            self._smooth = False
            wait = self._last + FRAME - time.perf_counter()
            self._timer.start(max(0, round(1000 * wait)))

    def render(self, *_args: object, **_kwargs: object) -> None:
        """What pyvista calls after every change: a frame is asked for, not drawn at once."""
        self._rendered = True
        self.ask_frame()

    def close(self) -> None:
        """Let go of VTK's window and of Qt's context.

        The interactor keeps Qt's surface, which is no QObject: its Python name would outlive it, and whatever Qt puts
        at the same place in memory later would be taken for a surface.
        """
        super().close()
        self._forget_context()

    def mousePressEvent(self, event: QMouseEvent) -> None:
        """Tell VTK of the Alt key too, which its Qt widget leaves out."""
        self.iren.interactor.SetAltKey(bool(event.modifiers() & Qt.KeyboardModifier.AltModifier))
        super().mousePressEvent(event)

    def keyPressEvent(self, event: QKeyEvent) -> None:
        """Keys belong to the window; pyvista would quit at ``q`` and turn to wires at ``w``."""
        event.ignore()

    def keyReleaseEvent(self, event: QKeyEvent) -> None:
        """Keys belong to the window."""
        event.ignore()

    def picture(self) -> NDArray[np.uint8]:
        """What is seen, up to date and with smooth edges, (height, width, 3) in pixels of the screen."""
        self._prepare()
        self.ren_win.SetMultiSamples(SAMPLES)
        self._painting = True
        self._check_has_ren_win()
        try:
            self.ren_win.Render()
            return np.asarray(self.screenshot(return_img=True))
        finally:
            self._painting = False

    def paintGL(self) -> None:
        """Bring the scene up to date and draw it."""
        self._prepare()
        if self._software is None:
            self._software = self._drawn_in_software()
        rough = self._software and not self._smooth
        self.ren_win.SetMultiSamples(0 if rough else SAMPLES)
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
        if rough:
            self._still.start()
        self.drawn.emit(1000 * (self._last - start))

    def _prepare(self) -> None:
        for prepare in self.before_frame:
            prepare()

    def _refine(self) -> None:
        """Nothing has moved for a while: draw once more, with smooth edges."""
        self._smooth = True
        self.update()

    def _drawn_in_software(self) -> bool:
        driver = self.ren_win.ReportCapabilities().lower()
        return any(name in driver for name in SOFTWARE)

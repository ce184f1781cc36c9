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

from app.quality import Level
from ui.viewport.fineness import Fineness, Occlusion, fineness_of

FRAME = 1 / 60
"""Seconds from the begin of a frame to that of the next, at least; a hand moves more often than a screen can show."""

STILL = 0.25
"""Seconds without a new frame after which the face is drawn once more, as finely as can be."""

SOFTWARE = ("llvmpipe", "softpipe", "swr", "basic render", "swiftshader")
"""Names of drivers that draw without a graphics card; smooth edges cost them four times the frame."""


class Canvas(QtInteractor):
    """A pyvista plotter in the window.

    Whatever asks for a picture, be it pyvista, VTK's interactor or the editor, only marks the widget; Qt then paints
    it once.  Before that every function in ``before_frame`` runs, so that what is drawn is the latest state.

    Signals
    -------
    drawn(float) : milliseconds that the last frame took, drawing alone, to its last pixel
    moved(float, float) : the same for a frame that follows on another one, with what it took to prepare it, and without
    rested(float) : the same for the picture of what has come to rest
    driver_known(bool) : before the first frame; whether it draws in software

    Attributes
    ----------
    moving, resting : how finely is drawn what moves, and what has come to rest
    thin_lines : whether lines of a pixel's width are in the picture
    frames : drawn so far
    """

    drawn = Signal(float)
    moved = Signal(float, float)
    rested = Signal(float)
    driver_known = Signal(bool)
    _ready = False

    def __init__(self, parent: QWidget) -> None:
        super().__init__(parent, auto_update=False, multi_samples=0)
        self.before_frame: list[Callable[[], None]] = []
        self.frames = 0
        self.moving: Level = "balanced"
        self.resting: Level = "balanced"
        self.thin_lines = False
        self._occlusion = Occlusion(self.renderer)
        self._painting = False
        self._begun = self._last = 0.0
        self._timer = QTimer(self, singleShot=True)
        self._timer.timeout.connect(self.update)
        self._driver_known = False
        self._at_rest = False
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
            self._at_rest = False
            self._still.stop()
            self._timer.start(round(1000 * self.due))

    @property
    def due(self) -> float:
        """Seconds until the next frame may begin: what the last one took is part of its sixtieth of a second."""
        return max(0.0, self._begun + FRAME - time.perf_counter())

    def render(self, *_args: object, **_kwargs: object) -> None:
        """What pyvista calls after every change: a frame is asked for, not drawn at once."""
        self._rendered = True
        self.ask_frame()

    def close(self) -> None:
        """Let go of VTK's window and of Qt's context.

        The interactor keeps Qt's surface, which is no QObject: its Python name would outlive it, and whatever Qt puts
        at the same place in memory later would be taken for a surface.
        """
        self._occlusion.release()
        # A button that is still held goes up over an interactor that is no more; what is disabled hears no mouse.
        self.setEnabled(False)
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
        """What is seen, up to date and as fine as at rest, (height, width, 3) in pixels of the screen."""
        self._prepare()
        self._take(fineness_of(self.resting, self.thin_lines))
        self._painting = True
        self._check_has_ren_win()
        try:
            self.ren_win.Render()
            return np.asarray(self.screenshot(return_img=True))
        finally:
            self._painting = False

    def paintGL(self) -> None:
        """Bring the scene up to date and draw it."""
        if not self._driver_known:
            self._driver_known = True
            self.driver_known.emit(self._drawn_in_software())
        following = time.perf_counter() - self._last < STILL
        self._begun = start = time.perf_counter()
        self._prepare()
        prepared = time.perf_counter()
        self._draw(fineness_of(self.resting if self._at_rest else self.moving, self.thin_lines))
        self._last = time.perf_counter()
        self.frames += 1
        drawing = 1000 * (self._last - prepared)
        if self._at_rest:
            self.rested.emit(drawing)
        else:
            self._still.start()
            if following:
                self.moved.emit(1000 * (self._last - start), drawing)
        self.drawn.emit(drawing)

    def _draw(self, fineness: Fineness) -> None:
        """Draw into the widget; a picture with fewer pixels is stretched over it."""
        self._take(fineness)
        shown = self.ren_win.GetSize()
        if fineness.share < 1:
            self.ren_win.SetSize(*(max(1, round(fineness.share * side)) for side in shown))
        self._painting = True
        self.iren.interactor.EnableRenderOn()
        try:
            super().paintGL()
            self.ren_win.WaitForCompletion()
        finally:
            self.iren.interactor.EnableRenderOff()
            self._painting = False
            self.ren_win.SetSize(*shown)

    def _take(self, fineness: Fineness) -> None:
        self.ren_win.SetMultiSamples(fineness.samples)
        self._occlusion.switch(fineness.occlusion)

    def _prepare(self) -> None:
        for prepare in self.before_frame:
            prepare()

    def _refine(self) -> None:
        """Nothing has moved for a while: draw once more, as finely as can be."""
        if self.resting != self.moving:
            self._at_rest = True
            self.update()

    def _drawn_in_software(self) -> bool:
        driver = self.ren_win.ReportCapabilities().lower()
        return any(name in driver for name in SOFTWARE)

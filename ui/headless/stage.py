"""A scene off the screen that can be photographed."""

from __future__ import annotations

import os
import sys
from collections.abc import Iterator
from contextlib import contextmanager

import numpy as np
import pyvista as pv
from PIL import Image
from vtkmodules.util.numpy_support import vtk_to_numpy
from vtkmodules.vtkRenderingCore import vtkWindowToImageFilter

from ui.viewport.scene import Scene
from ui.viewport.surface import ByteArray

FINER = 2
"""Every pixel is drawn so many times as wide and high and averaged, which also smooths hair and highlights."""
SAMPLES = 4
"""Samples per drawn pixel at the edges of surfaces, where the picture is to be as fine as can be."""
BACKEND = "VTK_DEFAULT_OPENGL_WINDOW"
"""Environment variable by which VTK chooses how it reaches the graphics driver."""


class Stage:
    """A scene with a camera that takes pictures of one size.

    Parameters
    ----------
    size : width and height of the pictures in pixels
    theme : of the backdrop, ``dark`` or ``light``
    samples : per drawn pixel at the edges of surfaces; zero is faster
    finer : every pixel is drawn this many times as wide and high and averaged

    Attributes
    ----------
    scene : what is photographed
    """

    def __init__(self, size: tuple[int, int], theme: str = "dark", samples: int = SAMPLES, finer: int = FINER) -> None:
        self.size = size
        drawn = (finer * size[0], finer * size[1])
        with _screenless():
            self._plotter = pv.Plotter(off_screen=True, window_size=drawn, lighting="none")
        self._plotter.render_window.SetMultiSamples(samples)
        self.scene = Scene(self._plotter, theme)

    def picture(self) -> ByteArray:
        """What the scene shows, (height, width, 3), first row on top."""
        self.scene.before_frame()
        window = self._plotter.render_window
        window.Render()
        grab = vtkWindowToImageFilter()
        grab.SetInput(window)
        grab.SetInputBufferTypeToRGB()
        grab.ReadFrontBufferOff()
        grab.ShouldRerenderOff()
        grab.Update()
        image = grab.GetOutput()
        width, height, _ = image.GetDimensions()
        drawn = vtk_to_numpy(image.GetPointData().GetScalars()).reshape(height, width, 3)[::-1]
        if (width, height) == self.size:
            return np.ascontiguousarray(drawn)
        fine = Image.fromarray(np.ascontiguousarray(drawn))
        return np.asarray(fine.resize(self.size, Image.Resampling.BOX))

    def close(self) -> None:
        """Give the graphics memory back."""
        self._plotter.close()


@contextmanager
def stage(size: tuple[int, int], theme: str = "dark", samples: int = SAMPLES, finer: int = FINER) -> Iterator[Stage]:
    """A stage that is struck when it is no longer needed."""
    made = Stage(size, theme, samples, finer)
    try:
        yield made
    finally:
        made.close()


@contextmanager
def _screenless() -> Iterator[None]:
    """Without a display server, have VTK go to the driver at once, not by way of an X server that is not there."""
    if not sys.platform.startswith("linux") or os.environ.get("DISPLAY") or BACKEND in os.environ:
        yield
        return
    os.environ[BACKEND] = "vtkEGLRenderWindow"
    try:
        yield
    finally:
        del os.environ[BACKEND]

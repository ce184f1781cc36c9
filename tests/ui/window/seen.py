"""What is drawn in a window."""

import time

import numpy as np
from PySide6.QtCore import QPoint
from PySide6.QtTest import QTest

from ui.window.main_window import MainWindow

PATIENCE = 60.0
"""Seconds after which no frame comes any more."""


def picture(window: MainWindow) -> np.ndarray:
    """Return what is seen in the viewport after the next frame."""
    next_frame(window)
    return window.viewport.canvas.picture().astype(int)


def points(window: MainWindow) -> np.ndarray:
    """Return the drawn points of the skin after the next frame."""
    next_frame(window)
    return window.viewport.scene.figure.posed.points.copy()


def next_frame(window: MainWindow) -> None:
    """Wait until the window has drawn a frame of its own accord."""
    canvas = window.viewport.canvas
    before = canvas.frames
    canvas.ask_frame()
    end = time.monotonic() + PATIENCE
    while canvas.frames == before:
        assert time.monotonic() < end, "No frame was drawn."
        QTest.qWait(5)


def differs(one: np.ndarray, other: np.ndarray) -> bool:
    """Whether two pictures differ by more than a few stray pixels."""
    return bool((np.abs(one - other).max(axis=-1) > 8).mean() > 0.0003)


def pixel(window: MainWindow, place: np.ndarray) -> QPoint:
    """Return where on the canvas a place (3,) of the head is drawn."""
    renderer, canvas = window.viewport.scene.renderer, window.viewport.canvas
    renderer.SetWorldPoint(*place, 1.0)
    renderer.WorldToDisplay()
    x, y, _ = renderer.GetDisplayPoint()
    scale = canvas.devicePixelRatioF()
    return QPoint(round(x / scale), round(canvas.height() - 1 - y / scale))

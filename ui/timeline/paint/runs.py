"""Curves and waveforms as strips of pixels: as quick for a minute of samples as for two keys."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QRectF
from PySide6.QtGui import QColor, QImage, QPainter

from fem.types import FloatArray

LINE = 1.5
"""Width of a curve."""

FILL = 0.17
"""How much of its colour lies between a curve and its rest."""


def run_image(
    low: FloatArray, high: FloatArray, rest: float, height: int, colour: QColor, fill: float = FILL
) -> QImage:
    """A curve as a picture.

    Parameters
    ----------
    low, high : (W,) heights in pixels from the top, pixel by pixel, low the larger one; NaN where there is nothing
    rest : height of what it is filled down to
    height : pixels of the picture
    """
    top, foot = _joined(high, low)
    rows = np.arange(height)[:, None]
    line = np.clip(np.minimum(foot + LINE / 2, rows + 1) - np.maximum(top - LINE / 2, rows), 0.0, 1.0)
    upper, lower = np.minimum(top, rest), np.maximum(foot, rest)
    inside = np.clip(np.minimum(lower, rows + 1) - np.maximum(upper, rows), 0.0, 1.0)
    alpha = np.nan_to_num(np.maximum(line, fill * inside)) * colour.alphaF()
    pixels = np.empty((height, len(low), 4), dtype=np.uint8)
    for channel, part in enumerate((colour.blueF(), colour.greenF(), colour.redF())):
        pixels[..., channel] = (255.0 * part * alpha + 0.5).astype(np.uint8)
    pixels[..., 3] = (255.0 * alpha + 0.5).astype(np.uint8)
    # Qt only borrows the pixels, so they are copied before they go.
    return QImage(pixels.data, len(low), height, 4 * len(low), QImage.Format.Format_ARGB32_Premultiplied).copy()


def _joined(high: FloatArray, low: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Every pixel reaches half-way to its neighbours, so that steep parts have no gaps."""
    middle = (high + low) / 2
    halves = (middle[:-1] + middle[1:]) / 2
    top, foot = high.copy(), low.copy()
    for part, side in ((slice(None, -1), halves), (slice(1, None), halves)):
        top[part], foot[part] = np.fmin(top[part], side), np.fmax(foot[part], side)
    return top, foot


def draw_strip(painter: QPainter, area: QRectF, image: QImage) -> None:
    """Put a strip where it belongs; it has as many pixels as the screen has there."""
    painter.drawImage(area, image)

"""Several shapes drawn as one surface: every actor takes its part of a frame, however small it is."""

from __future__ import annotations

from collections.abc import Sequence
from typing import NamedTuple

import numpy as np

from fem.types import Float32Array, IntArray
from ui.viewport.surface import ByteArray, Surface


class Shape(NamedTuple):
    """Triangles to be drawn.

    Attributes
    ----------
    points, normals : (n, 3) float32
    triangles : (t, 3)
    colours : (n, 4) uint8, of all the shapes that are joined or of none
    """

    points: Float32Array
    normals: Float32Array
    triangles: IntArray
    colours: ByteArray | None = None


def joined(shapes: Sequence[Shape]) -> tuple[Surface, list[Shape]]:
    """One surface of several shapes, and each of them again as views of its arrays: what is written there is drawn."""
    starts = np.cumsum([0, *(len(shape.points) for shape in shapes)]).tolist()
    points, normals = (np.concatenate([shape[k] for shape in shapes]) for k in (0, 1))
    triangles = np.concatenate([shape.triangles + start for shape, start in zip(shapes, starts, strict=False)])
    coloured = [shape.colours for shape in shapes if shape.colours is not None]
    colours = np.concatenate(coloured) if coloured else None
    views = []
    for shape, start, stop in zip(shapes, starts, starts[1:], strict=False):
        tint = None if colours is None else colours[start:stop]
        views.append(Shape(points[start:stop], normals[start:stop], shape.triangles, tint))
    return Surface(points, normals, triangles, colours), views

"""Fill the slivers between the drawn skin and the pockets that hang on it.

The skin's openings are smooth curves, the rims of lining and sockets are polygons through the same vertices. What lies
between a curve and its chord is filled with triangles of the skin's own points, so that they move with it.
"""

from __future__ import annotations

import igl
import numpy as np
from vtkmodules.vtkRenderingCore import vtkActor

from facemodel.display import DisplaySurface
from fem.types import IntArray
from ui.viewport.complexion import Palette
from ui.viewport.shading import FLESH, apply
from ui.viewport.surface import Surface, companion

CORNER = 1 - 1e-6
"""A drawn point with a barycentric coordinate above this lies on a skin vertex."""


DARK = 0.8
"""Brightness of a seam over that of the lips it lies behind: that of the lining which it joins them to."""


def seam(skin: Surface, display: DisplaySurface, palette: Palette) -> vtkActor:
    """What closes the slivers around mouth and eyes."""
    actor = companion(skin, seam_triangles(display))
    actor.GetProperty().SetColor(*(DARK * c for c in palette.lips))
    apply(actor, FLESH)
    return actor


def seam_triangles(display: DisplaySurface) -> IntArray:
    """Triangles (n, 3) of drawn points that close the slivers of all openings but the neck's, the longest.

    They face as the skin beside them does, so that its normals are theirs too.
    """
    loops = sorted((np.array(loop) for loop in igl.boundary_loop_all(display.triangles)), key=len)
    on_vertex = display.barycentric.max(axis=1) > CORNER
    found = []
    for loop in loops[:-1]:
        corners = np.flatnonzero(on_vertex[loop])
        for start, stop in zip(corners, np.append(corners[1:], corners[0] + len(loop)), strict=True):
            chain = loop[np.arange(start, stop + 1) % len(loop)]
            found += [[chain[0], chain[k + 1], chain[k]] for k in range(1, len(chain) - 1)]
    return np.array(found, dtype=np.int64).reshape(-1, 3)

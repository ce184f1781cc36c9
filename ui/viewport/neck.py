"""The clean cut of the neck: a plane that ends the skin, and a dark cap in it, so that nobody looks into a hollow."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from vtkmodules.vtkCommonDataModel import vtkPlane

from facemodel.display import DisplaySurface
from facemodel.face import Face
from fem.types import FloatArray
from ui.viewport.shading import MATTE, apply
from ui.viewport.surface import Surface

ABOVE_RIM = 0.3
"""Millimetres between the highest point of the rim, as a wavy line about a plane, and the cut."""
INSET = 0.997
"""Size of the cap over the cut: it ends inside the skin."""
UPRIGHT = 0.7
"""Least upward share of the normal of a rim that is a neck's and not the edge of a mask."""
CAP = (0.085, 0.070, 0.066)


@dataclass(frozen=True, eq=False)
class NeckCut:
    """The plane of the cut.

    Attributes
    ----------
    origin, normal : (3,) a point of it and the unit normal towards the head
    """

    origin: FloatArray
    normal: FloatArray

    @property
    def plane(self) -> vtkPlane:
        """As VTK's mappers take it: what lies behind it is not drawn."""
        made = vtkPlane()
        made.SetOrigin(*self.origin)
        made.SetNormal(*self.normal)
        return made


def neck_cut(face: Face) -> NeckCut | None:
    """The plane through the neck just above the rim of the skin; none if the skin does not end in a neck."""
    rim = face.skin.positions[face.skin.boundary_loops[-1]]
    middle = rim.mean(axis=0)
    normal = np.linalg.svd(rim - middle)[2][2]
    normal *= np.sign(normal[1])
    height = (face.skin.positions - middle) @ normal
    if normal[1] < UPRIGHT or height.mean() < 0:
        return None
    rise = float(height[face.skin.boundary_loops[-1]].max()) + ABOVE_RIM
    return NeckCut(middle + rise * normal, normal)


def neck_cap(cut: NeckCut, display: DisplaySurface) -> Surface:
    """A disk in the cut."""
    height = (display.points - cut.origin) @ cut.normal
    edges = np.sort(display.triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    a, b = height[edges].T
    crossed = edges[a * b < 0]
    a, b = height[crossed].T
    share = (a / (a - b))[:, None]
    ring = display.points[crossed[:, 0]] * (1 - share) + display.points[crossed[:, 1]] * share
    middle = ring.mean(axis=0)
    order = np.argsort(np.arctan2(ring[:, 0] - middle[0], ring[:, 2] - middle[2]))
    ring = middle + INSET * (ring[order] - middle)
    count = len(ring)
    j = np.arange(count)
    triangles = np.stack([np.roll(j, -1), j, np.full(count, count)], axis=1)
    points = np.concatenate([ring, middle[None]]).astype(np.float32)
    normals = np.ascontiguousarray(np.broadcast_to(-cut.normal, points.shape), dtype=np.float32)
    surface = Surface(points, normals, triangles)
    surface.actor.GetProperty().SetColor(*CAP)
    apply(surface.actor, MATTE)
    return surface

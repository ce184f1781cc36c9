"""What lies behind the skin: lining of the mouth, sockets behind the lids, tongue."""

from __future__ import annotations

import igl
import numpy as np

from facemodel.face import Part
from facemodel.mesh import Mesh
from fem.types import Float32Array, FloatArray
from ui.viewport.complexion import Colour, Palette, smooth
from ui.viewport.look import bytes_of
from ui.viewport.shading import FLESH, TOOTH, apply
from ui.viewport.surface import Surface
from ui.viewport.teeth import ENAMEL

MUCOSA: Colour = (0.52, 0.20, 0.19)
THROAT: Colour = (0.10, 0.02, 0.025)
TONGUE: Colour = (0.58, 0.33, 0.32)
TONGUE_LIGHT = 0.32
"""Openness of the tip of the tongue: lips and teeth keep most of the light away."""
DEEP = 34.0
"""Millimetres behind the lips at which the mouth is black."""


def _graded(mesh: Mesh, near: Colour, far: Colour, front: float, deep: float) -> FloatArray:
    """Colours and openness (n, 4) that darken from ``front`` (z) backwards over ``deep`` millimetres."""
    back = smooth(front - mesh.positions[:, 2], 0.0, deep)[:, None]
    colours = np.array(near) * (1 - back) + np.array(far) * back
    return np.concatenate([colours, 1 - 0.85 * back], axis=1)


def lining(part: Part, posed: Float32Array, palette: Palette) -> Surface:
    """The inside of the lips and cheeks, dark towards the throat."""
    mesh = part.mesh
    front = float(mesh.positions[:, 2].max())
    colours = _graded(mesh, MUCOSA, THROAT, front - 2.0, DEEP)
    lips = smooth(front - mesh.positions[:, 2], 16.0, 2.0)[:, None]
    colours[:, :3] += (0.8 * np.array(palette.lips) - colours[:, :3]) * 0.7 * lips
    surface = Surface(posed, mesh.normals.astype(np.float32), mesh.triangles, bytes_of(colours))
    return _flesh(surface)


def socket(part: Part, posed: Float32Array, palette: Palette) -> Surface:
    """The inside of the lids, moist and pink at their margin."""
    mesh = part.mesh
    front = float(np.quantile(mesh.positions[:, 2], 0.95))
    colours = _graded(mesh, palette.flush, THROAT, front, 9.0)
    surface = Surface(posed, mesh.normals.astype(np.float32), mesh.triangles, bytes_of(colours))
    return _flesh(surface)


def tongue(part: Part) -> Surface:
    """The tongue at rest; the jaw's motion is given to its actor."""
    mesh = rounded(part.mesh)
    colours = _graded(mesh, TONGUE, THROAT, float(mesh.positions[:, 2].max()), 1.4 * DEEP)
    colours[:, 3] *= TONGUE_LIGHT
    surface = Surface(
        mesh.positions.astype(np.float32), mesh.normals.astype(np.float32), mesh.triangles, bytes_of(colours)
    )
    return _flesh(surface)


def rounded(mesh: Mesh) -> Mesh:
    """A mesh with every triangle parted in four, twice, as Loop's smooth surface has it."""
    points, triangles = igl.loop(mesh.positions, mesh.triangles, ROUNDS)
    return Mesh(np.asarray(points), np.asarray(triangles, dtype=np.int64))


ROUNDS = 2
"""Subdivisions after which the tongue of the base mesh, which has some two hundred points, looks round."""


def enamel(part: Part) -> Surface:
    """Teeth of another shape than a strip, drawn as they are."""
    mesh = part.mesh
    colours = _graded(mesh, ENAMEL, ENAMEL, float(mesh.positions[:, 2].max()), DEEP)
    surface = Surface(
        mesh.positions.astype(np.float32), mesh.normals.astype(np.float32), mesh.triangles, bytes_of(colours)
    )
    apply(surface.actor, TOOTH, openness=True)
    surface.actor.ForceOpaqueOn()
    return surface


def _flesh(surface: Surface) -> Surface:
    """Dress a pocket; it is seen from inside only, so what bulges through the skin in a wide pose stays unseen."""
    apply(surface.actor, FLESH, openness=True)
    surface.actor.GetProperty().BackfaceCullingOn()
    surface.actor.ForceOpaqueOn()
    return surface

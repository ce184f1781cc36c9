"""What lies behind the skin: lining of the mouth, sockets behind the lids, tongue."""

from __future__ import annotations

import igl
import numpy as np

from facemodel.face import Part
from facemodel.mesh import Mesh
from facemodel.smooth import smooth
from facemodel.superposition import Superposition
from fem.types import FloatArray
from ui.viewport.complexion import Colour, Palette
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


def pockets(posed: Superposition, palette: Palette) -> Surface | None:
    """All that the skin carries and that is seen from inside only; one surface, as each takes its part of a frame."""
    colours = np.full((len(posed.carried), 4), 255, dtype=np.uint8)
    normals, triangles, first = np.zeros_like(posed.carried), [], 0
    parts = {part.name: part for part in posed.face.parts}
    for name, count in posed.basis.display.carried:
        part, rows = parts[name], slice(first, first + count)
        if part.kind in POCKETS:
            colours[rows] = bytes_of(POCKETS[part.kind](part.mesh, palette))
            normals[rows] = part.mesh.normals
            triangles.append(part.mesh.triangles + first)
        first += count
    if not triangles:
        return None
    return _flesh(Surface(posed.carried, normals, np.concatenate(triangles), colours))


def _lining(mesh: Mesh, palette: Palette) -> FloatArray:
    """Colours and openness (n, 4) of the inside of the lips and cheeks, dark towards the throat."""
    front = float(mesh.positions[:, 2].max())
    colours = _graded(mesh, MUCOSA, THROAT, front - 2.0, DEEP)
    lips = smooth(front - mesh.positions[:, 2], 16.0, 2.0)[:, None]
    colours[:, :3] += (0.8 * np.array(palette.lips) - colours[:, :3]) * 0.7 * lips
    return colours


def _socket(mesh: Mesh, palette: Palette) -> FloatArray:
    """Colours and openness (n, 4) of the inside of the lids, moist and pink at their margin."""
    front = float(np.quantile(mesh.positions[:, 2], 0.95))
    return _graded(mesh, palette.flush, THROAT, front, 9.0)


POCKETS = {"lining": _lining, "socket": _socket}
"""How the parts that the skin carries behind it are coloured, by their kind."""


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
    """A mesh with every triangle parted in four, as Loop's smooth surface has it."""
    points, triangles = igl.loop(mesh.positions, mesh.triangles, ROUNDS)
    return Mesh(np.asarray(points), np.asarray(triangles, dtype=np.int64))


ROUNDS = 1
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

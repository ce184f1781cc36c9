"""How much of its volume the tissue under cheeks and lips keeps where a face has them keep it."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from benchmarks.figure import Figure
from facemodel.basis import Basis
from facemodel.cache import solve_cached
from facemodel.face import Face
from facemodel.mesh import Mesh
from facemodel.projects import new_project
from facemodel.sampling import points_of_vertices
from facemodel.tissue import tissue_thickness
from fem.types import FloatArray

KEPT = 0.5
"""Share of the highest stiffness that is painted from which on the layer is on."""

MOST_CHANGE = 0.02
"""Share of the volume under the skin by which it may change there."""

UNITS = {12: "a pulled cheek", 18: "pursed lips"}
"""Action units at which it is measured, both sides at full strength."""


def figures() -> Iterator[Figure]:
    """Measure the default face."""
    project = new_project()
    basis = solve_cached(project).basis
    for number, what in UNITS.items():
        change = abs(volume_change(project.face, basis, number))
        against = f"{MOST_CHANGE:.0%}"
        yield Figure(f"volume under {what}, AU {number}", 100 * change, "%", against, change / MOST_CHANGE, 1.0)


def volume_change(face: Face, basis: Basis, number: int) -> float:
    """By which share the volume between skin and skull changes where it is kept, at an action unit of two sides.

    A column of tissue of thickness h whose outer end moves by u, and its inner one not, grows by u . n + h / 2 div u:
    in thickness, and with the area in its middle.
    """
    points = points_of_vertices(face, basis.display)
    moved = sum(basis.field(f"{number}{side}")[points].astype(np.float64) for side in "LR")
    thickness, areas = tissue_thickness(face), face.skin.vertex_areas
    change = np.einsum("ij,ij->i", moved, face.skin.normals) + thickness / 2 * divergence(face.skin, moved)
    kept = face.layers.volume > KEPT * face.layers.volume.max()
    return float((areas * change)[kept].sum() / (areas * thickness)[kept].sum())


def divergence(skin: Mesh, field: FloatArray) -> FloatArray:
    """Divergence along the surface (n,) of a field (n, 3) that is linear in every triangle, averaged about vertices."""
    corners = skin.positions[skin.triangles]
    normals = skin.triangle_normals
    square = np.einsum("ij,ij->i", normals, normals)
    # The gradient of a corner's share is its opposite edge, turned by a right angle in the plane, over twice the area.
    opposite = np.roll(corners, -2, axis=1) - np.roll(corners, -1, axis=1)
    gradients = np.cross(normals[:, None], opposite) / square[:, None, None]
    own = np.einsum("tkc,tkc->t", gradients, field[skin.triangles])
    around = np.repeat(np.sqrt(square) / 6, 3)
    total = np.bincount(skin.triangles.ravel(), around * np.repeat(own, 3), len(skin.positions))
    return np.asarray(total / np.maximum(skin.vertex_areas, np.finfo(np.float64).tiny))

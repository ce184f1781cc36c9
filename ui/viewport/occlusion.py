"""How much of the surroundings each point of the resting skin sees: nostrils, lip line and neck lie in shade."""

from __future__ import annotations

import igl
import numpy as np

from facemodel.mesh import Mesh
from fem.types import FloatArray

RAYS = 96
"""Directions per vertex; with them spread evenly the shade is smooth to the eye."""
REACH = 70.0
"""Millimetres beyond which a neighbour no longer shades."""
LIFT = 0.15
"""Millimetres that a ray starts above the skin, so that it does not hit the triangle it leaves."""


def cosine_directions(count: int) -> FloatArray:
    """Unit vectors (count, 3) about +z, as dense as the cosine of their angle to it (a Fibonacci spiral)."""
    k = np.arange(count) + 0.5
    radius, turn = np.sqrt(k / count), np.pi * (1 + np.sqrt(5)) * k
    return np.stack([radius * np.cos(turn), radius * np.sin(turn), np.sqrt(1 - radius**2)], axis=1)


def openness(skin: Mesh, blockers: Mesh, rays: int = RAYS) -> FloatArray:
    """Share (N,) of the light from all around that reaches each vertex of the skin, 0..1.

    Parameters
    ----------
    skin : the surface to be shaded
    blockers : what casts the shade; usually the skin with what lies in its openings
    rays : directions per vertex
    """
    normals = skin.normals
    helper = np.where(np.abs(normals[:, :1]) < 0.9, [[1.0, 0.0, 0.0]], [[0.0, 1.0, 0.0]])
    first = np.cross(normals, helper)
    first /= np.linalg.norm(first, axis=1, keepdims=True) + 1e-12
    frame = np.stack([first, np.cross(normals, first), normals], axis=1)
    directions = np.einsum("rk,nkc->nrc", cosine_directions(rays), frame)
    origins = np.repeat((skin.positions + LIFT * normals)[:, None], rays, axis=1)
    tree = igl.AABB()
    tree.init(blockers.positions, blockers.triangles)
    hit, distance, _ = tree.intersect_ray_first(
        blockers.positions, blockers.triangles, origins.reshape(-1, 3), directions.reshape(-1, 3)
    )
    near = np.where(hit >= 0, np.clip(1 - distance / REACH, 0.0, 1.0), 0.0)
    return np.asarray(1 - near.reshape(-1, rays).mean(axis=1))

"""From action units to loads on the skin: muscle forces, turned along the bone, and the pull of a turned jaw."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

import numpy as np

from facemodel.actions import ActionUnit
from facemodel.face import Face
from facemodel.mesh import Mesh
from facemodel.muscles import Muscle
from facemodel.muscles.models import muscle_forces
from facemodel.superposition import jaw_motion
from fem import SpringSet
from fem.types import FloatArray


def along_bone(forces: FloatArray, normals: FloatArray) -> FloatArray:
    """Turn the forces (N, 3) that point into the bone along it, with their size kept (design section 4).

    Parameters
    ----------
    forces : per area
    normals : (N, 3) outward unit normals of the skin over the bone
    """
    inward = np.minimum(np.einsum("ij,ij->i", forces, normals), 0.0)
    turned = forces - inward[:, None] * normals
    size, left = np.linalg.norm(forces, axis=1), np.linalg.norm(turned, axis=1)
    scale = np.divide(size, left, out=np.ones_like(size), where=left > STEEP * size)
    return np.asarray(turned * scale[:, None])


STEEP = 0.3
"""A force within 17 degrees of the bone's normal keeps only its tangential part: it has no side to turn to."""


def field_forces(
    units: Sequence[ActionUnit], muscles: Sequence[Muscle], skin: Mesh
) -> tuple[tuple[str, ...], FloatArray]:
    """Force per area on the skin of every displacement field, N/mm^2.

    A muscle across the midline acts with half its strength in each side of a paired unit, so that left and right
    together are the whole.

    Returns
    -------
    names : M field names
    forces : (M, N, 3)
    """
    known: dict[str, FloatArray] = {m.key: along_bone(muscle_forces(m, skin), skin.normals) for m in muscles}
    names: list[str] = []
    forces: list[FloatArray] = []
    for unit in units:
        for name in unit.fields:
            side = name[-1] if unit.paired else ""
            names.append(name)
            forces.append(_unit_force(unit, side, known, len(skin.positions)))
    return tuple(names), np.array(forces)


def _unit_force(unit: ActionUnit, side: str, known: Mapping[str, FloatArray], count: int) -> FloatArray:
    total = np.zeros((count, 3))
    for muscle, weight in unit.muscles.items():
        if muscle in known:
            total += weight * (0.5 if side else 1.0) * known[muscle]
            continue
        for each in (side,) if side else ("L", "R"):
            total += weight * known[f"{muscle}_{each}"]
    return total


def jaw_forces(
    face: Face, unit: ActionUnit, springs: SpringSet, anchors: FloatArray, jawbone: FloatArray
) -> FloatArray:
    """Force per area (n, 3) with which the tissue pulls the skin when the jaw moves as the unit says.

    Parameters
    ----------
    springs, anchors, jawbone : as `facemodel.tissue.tissue_springs` returns them
    """
    count = int(springs.vertices.max()) + 1
    if unit.jaw is None:
        return np.zeros((count, 3))
    motion = jaw_motion(face.skull.jaw, unit.jaw.degrees, unit.jaw.slide)
    moved = anchors @ motion[:3, :3].T + motion[:3, 3] - anchors
    return springs.anchor_forces(jawbone[:, None] * moved, count)

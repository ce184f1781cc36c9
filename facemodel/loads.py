"""From action units to loads on the skin: muscle forces, turned along the bone, and the pull of a turned jaw."""

from __future__ import annotations

from collections.abc import Container, Mapping, Sequence

import numpy as np

from facemodel.actions import ActionUnit, skin_units
from facemodel.errors import FaceError
from facemodel.face import Face
from facemodel.jaw.modes import JawMode, mode_motion
from facemodel.muscles import Muscle
from facemodel.muscles.models import MODELS, muscle_forces
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
    units: Sequence[ActionUnit], muscles: Sequence[Muscle], face: Face
) -> tuple[tuple[str, ...], FloatArray]:
    """Force per area on the skin of every displacement field, N/mm^2.

    A muscle across the midline acts with half its strength in each side of a paired unit, so that left and right
    together are the whole.  A muscle that lies on one side only has no part in the other.  Muscles that displace
    have none at all; see `facemodel.displaced`.

    Returns
    -------
    names : M field names
    forces : (M, N, 3)

    Raises
    ------
    FaceError
        If a unit names a muscle that is not there on any side.
    """
    return field_sums(units, muscles, {m.key: bone_forces(m, face) for m in muscles}, face)


def bone_forces(muscle: Muscle, face: Face) -> FloatArray:
    """Force per area (N, 3) of a muscle on the skin of a face, turned along the bone where its model slides."""
    forces = muscle_forces(muscle, face)
    return along_bone(forces, face.skin.normals) if MODELS[muscle.model].slides else forces


def field_sums(
    units: Sequence[ActionUnit], muscles: Sequence[Muscle], actions: Mapping[str, FloatArray], face: Face
) -> tuple[tuple[str, ...], FloatArray]:
    """Actions (N, 3) of muscles by key, summed over what every displacement field contracts.

    Returns
    -------
    names : M field names
    sums : (M, N, 3)

    Raises
    ------
    FaceError
        If a unit names a muscle that is not there on any side.
    """
    contracted = contractions(units, muscles)
    sums = np.zeros((len(contracted), len(face.skin.positions), 3))
    for total, weights in zip(sums, contracted.values(), strict=True):
        for key, weight in weights.items():
            total += weight * actions[key]
    return tuple(contracted), sums


def contractions(units: Sequence[ActionUnit], muscles: Sequence[Muscle]) -> dict[str, dict[str, float]]:
    """Activation of every muscle by its key that every displacement field contracts, by the field's name.

    Raises
    ------
    FaceError
        If a unit names a muscle that is not there on any side.
    """
    keys = {muscle.key for muscle in muscles}
    there = {muscle.name for muscle in muscles}
    fields: dict[str, dict[str, float]] = {}
    for unit in skin_units(units):
        for missing in sorted(unit.muscles.keys() - there):
            raise FaceError(
                f"Action unit {unit.number} ({unit.name}) contracts the muscle “{missing}”, which is not there; "
                "lay it, or take it out of the unit."
            )
        for name in unit.fields:
            fields[name] = _contracted(unit, name[-1] if unit.paired else "", keys)
    return fields


def _contracted(unit: ActionUnit, side: str, keys: Container[str]) -> dict[str, float]:
    weights: dict[str, float] = {}
    for muscle, weight in unit.muscles.items():
        if muscle in keys:
            weights[muscle] = weights.get(muscle, 0.0) + weight * (0.5 if side else 1.0)
            continue
        for key in (f"{muscle}_{each}" for each in ((side,) if side else ("L", "R"))):
            if key in keys:
                weights[key] = weights.get(key, 0.0) + weight
    return weights


def springs_carry_jaw(unit: ActionUnit, muscles: Sequence[Muscle]) -> bool:
    """Whether the tissue's springs pull the skin along with a turned jaw; a muscle of the jaw force does it else."""
    pushed = {muscle.name for muscle in muscles if muscle.model == "jaw"}
    return unit.jaw is not None and not pushed & unit.muscles.keys()


def jaw_forces(face: Face, mode: JawMode, springs: SpringSet, anchors: FloatArray, jawbone: FloatArray) -> FloatArray:
    """Force per area (n, 3) with which the tissue pulls the skin when the jaw moves in one of its modes.

    Parameters
    ----------
    springs, anchors, jawbone : as `facemodel.tissue.tissue_springs` returns them
    """
    moved = mode_motion(face.skull.jaw, mode, anchors)
    return springs.anchor_forces(jawbone[:, None] * moved, int(springs.vertices.max()) + 1)

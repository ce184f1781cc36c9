"""Lay a skull so that bone is as deep under the landmarks as the tables say."""

from __future__ import annotations

from dataclasses import dataclass

import igl
import numpy as np

from facemodel.errors import SkullError
from facemodel.face import Face, Pose, Skull
from facemodel.mesh import Mesh
from facemodel.skull.depths import whole
from facemodel.skull.placement import LARGEST, SMALLEST, carried, checked, pivot_of, pose_matrix, way_between
from facemodel.skull.tissue_depths import table
from fem.types import FloatArray

FEWEST = 6
"""Landmarks with a known depth; fewer do not say where a skull lies."""

ROUNDS = 40
"""Steps at most; from a centimetre off a skull has settled after some ten."""

SETTLED = 0.01
"""Millimetres that a landmark's depth changes in a step after which the skull has settled."""

COMMON = 3.0
"""Millimetres by which a depth may miss and still count fully: cheeks of other people are so much thicker."""

RELUCTANCE = np.array([0.05, 0.05, 0.05, 0.10, 0.10, 0.10, 40.0, 40.0, 40.0])
"""What holds back a step, per millimetre, degree and factor of scale: where the depths do not tell, nothing moves."""

TOUCHING = 1e-6
"""Millimetres between skin and bone below which there is no way from one to the other."""

NUDGE = np.array([1e-3, 1e-3, 1e-3, 1e-3, 1e-3, 1e-3, 1e-5, 1e-5, 1e-5])
"""Differences of shift, turn and scale over which their effect is measured."""


@dataclass(frozen=True, eq=False)
class Targets:
    """Places (n, 3) of the skin and the depths (n,) that are wanted there."""

    places: FloatArray
    depths: FloatArray


def targets_of(face: Face) -> Targets:
    """The landmarks of a face whose depth the tables know.

    Raises
    ------
    SkullError
        If there are too few.
    """
    wanted = {name: depth for name, depth in table().items() if name in face.landmarks}
    if len(wanted) < FEWEST:
        raise SkullError(
            f"“{face.title}” has {len(wanted)} landmarks whose depth is known and at least {FEWEST} are needed; "
            "place its skull by hand."
        )
    return Targets(face.skin.positions[[face.landmarks[name] for name in wanted]], np.array(list(wanted.values())))


def snapped(face: Face, scales: bool = True) -> Pose:
    """The pose in which the bone of a face lies as near to the depths of the tables as it can.

    From where the skull lies, Gauss-Newton on the depths: in every step the nearest places of the bone are held fixed
    on it, and the pose goes where their depths, weighted so that a few odd ones do not count more than the many, miss
    least.

    Parameters
    ----------
    scales : whether the skull may grow and shrink along its axes; else it is moved and turned alone

    Raises
    ------
    SkullError
        If the face has too few landmarks, or the skull would have to leave the head.
    """
    targets, skull = targets_of(face), face.skull
    at_rest = _pose_back(skull)
    numbers, free = _numbers(skull.placement.pose), slice(None, None if scales else 6)
    for _ in range(ROUNDS):
        missed, slope = _linearised(skull, at_rest, targets, numbers)
        weight = 1 / np.sqrt(np.maximum(np.abs(missed) / max(COMMON, 2 * float(np.median(np.abs(missed)))), 1.0))
        rows = np.concatenate([weight[:, None] * slope[:, free], np.diag(RELUCTANCE[free])])
        goal = np.concatenate([-weight * missed, np.zeros(rows.shape[1])])
        step = np.linalg.lstsq(rows, goal, rcond=None)[0]
        numbers[free] += step
        numbers[6:] = np.clip(numbers[6:], SMALLEST, LARGEST)
        if np.abs(slope[:, free] @ step).max() < SETTLED:
            break
    return checked(_pose(np.round(numbers, 4)))


def _pose_back(skull: Skull) -> Mesh:
    """Both bones as they lie when nothing is moved."""
    bone = whole(skull)
    return bone.moved(carried(bone.positions, way_between(skull, Pose())))


def _linearised(skull: Skull, at_rest: Mesh, targets: Targets, numbers: FloatArray) -> tuple[FloatArray, FloatArray]:
    """By how much depths (n,) miss in a pose, and how they change (n, 9) with its numbers."""
    pivot = pivot_of(skull)
    way = pose_matrix(_pose(numbers), pivot)
    bone = at_rest.moved(carried(at_rest.positions, way))
    kind = igl.SignedDistanceType.SIGNED_DISTANCE_TYPE_FAST_WINDING_NUMBER
    depth, _, places, _ = igl.signed_distance(targets.places, bone.positions, bone.triangles, kind)
    depth = np.reshape(depth, -1)
    outward = (targets.places - places) / np.where(np.abs(depth) > TOUCHING, depth, TOUCHING)[:, None]
    local = carried(np.asarray(places), np.asarray(np.linalg.inv(way), dtype=np.float64))
    slope = np.empty((len(depth), 9))
    for number, nudge in enumerate(NUDGE):
        nudged = numbers.copy()
        nudged[number] += nudge
        moved = carried(local, pose_matrix(_pose(nudged), pivot)) - places
        slope[:, number] = -np.einsum("ij,ij->i", moved, outward) / nudge
    return depth - targets.depths, slope


def _numbers(pose: Pose) -> FloatArray:
    return np.array([*pose.shift, *pose.turn, *pose.scale])


def _pose(numbers: FloatArray) -> Pose:
    shift, turn, scale = (tuple(float(number) for number in part) for part in numbers.reshape(3, 3))
    return Pose(shift, turn, scale)  # type: ignore[arg-type]

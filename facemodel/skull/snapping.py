"""Lay a skull so that bone is as deep under the landmarks as the tables say."""

from __future__ import annotations

from dataclasses import dataclass

import igl
import numpy as np

from facemodel.errors import SkullError
from facemodel.face import AT_REST, Face, Pose, Skull
from facemodel.mesh import Mesh
from facemodel.skull.depths import whole
from facemodel.skull.placement import LARGEST, SMALLEST, carried, checked, pivot_of, pose_matrix, way_between
from facemodel.skull.tissue_depths import table
from facemodel.system import solved_vertices
from fem.types import FloatArray

FEWEST = 6
"""Landmarks with a known depth; fewer do not say where a skull lies."""

ROUNDS = 30
"""Steps at most; from a centimetre off a skull has settled after some ten."""

SETTLED = 0.01
"""Millimetres that a landmark's depth changes in a step after which the skull has settled."""

COMMON = 3.0
"""Millimetres by which a depth may miss and still count fully: cheeks of other people are so much thicker."""

COVERED, COVERED_STEP, COVERED_WEIGHT = 1.5, 7, 0.5
"""Millimetres that bone must lie under all of the face, every how manieth vertex is looked at for it, and how much one
counts against a landmark."""

RELUCTANCE = np.array([0.05, 0.05, 0.05, 0.10, 0.10, 0.10, 40.0, 40.0, 40.0])
"""What holds back a step, per millimetre, degree and factor of scale: where the depths do not tell, nothing moves."""

TOUCHING = 1e-6
"""Millimetres between skin and bone below which there is no way from one to the other."""

NUDGE = np.array([1e-3, 1e-3, 1e-3, 1e-3, 1e-3, 1e-3, 1e-5, 1e-5, 1e-5])
"""Differences of shift, turn and scale over which their effect is measured."""


@dataclass(frozen=True, eq=False)
class Targets:
    """Places of the skin under which bone is wanted.

    Attributes
    ----------
    places : (n, 3)
    depths : (n,) millimetres
    known : how many of them, the first ones, are landmarks; bone may lie deeper than it should under all others
    """

    places: FloatArray
    depths: FloatArray
    known: int

    def missed(self, depth: FloatArray) -> FloatArray:
        """By how much (n,) depths (n,) are not what they should be."""
        off = depth - self.depths
        off[self.known :] = np.minimum(off[self.known :], 0.0)
        return off


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
    marks, covered = [face.landmarks[name] for name in wanted], solved_vertices(face)[::COVERED_STEP]
    depths = np.concatenate([list(wanted.values()), np.full(len(covered), COVERED)])
    return Targets(face.skin.positions[[*marks, *covered]], depths, len(marks))


def snapped(face: Face, scales: bool = True) -> Pose:
    """The pose in which the bone of a face lies as near to the depths of the tables as it can.

    Gauss-Newton on the depths, from where the skull lies and from where it was made; the one that ends nearer is taken.
    In every step the nearest places of the bone are held fixed on it, and the pose goes where their depths, weighted so
    that a few odd ones do not count more than the many, miss least.

    Parameters
    ----------
    scales : whether the skull may grow and shrink along its axes; else it is moved and turned alone

    Raises
    ------
    SkullError
        If the face has too few landmarks, or the skull would have to leave the head.
    """
    targets, pose = targets_of(face), face.skull.placement.pose
    starts = (pose, Pose(scale=AT_REST.scale if scales else pose.scale))
    ends = [_settled(face.skull, targets, start, scales) for start in dict.fromkeys(starts)]
    return checked(_pose(np.round(min(ends, key=lambda end: end[1])[0], 4)))


def _settled(skull: Skull, targets: Targets, start: Pose, scales: bool) -> tuple[FloatArray, float]:
    """The numbers (9,) of a pose that has settled, and by how much its depths miss, rms."""
    at_rest = _pose_back(skull)
    numbers, free = _numbers(start), slice(None, None if scales else 6)
    for _ in range(ROUNDS):
        missed, slope = _linearised(skull, at_rest, targets, numbers)
        weight = _weights(missed, targets.known)
        rows = np.concatenate([weight[:, None] * slope[:, free], np.diag(RELUCTANCE[free])])
        goal = np.concatenate([-weight * missed, np.zeros(rows.shape[1])])
        step = np.linalg.lstsq(rows, goal, rcond=None)[0]
        numbers[free] += step
        numbers[6:] = np.clip(numbers[6:], SMALLEST, LARGEST)
        if np.abs(slope[:, free] @ step).max() < SETTLED:
            break
    missed = _linearised(skull, at_rest, targets, numbers)[0]
    return numbers, float(np.sqrt(((_weights(missed, targets.known) * missed) ** 2).mean()))


def _weights(missed: FloatArray, known: int) -> FloatArray:
    """How much (n,) each place counts: landmarks that miss far more than most count less than they would."""
    usual = max(COMMON, 2 * float(np.median(np.abs(missed[:known]))))
    weight = np.full(len(missed), COVERED_WEIGHT)
    weight[:known] = 1 / np.sqrt(np.maximum(np.abs(missed[:known]) / usual, 1.0))
    return weight


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
    missed = targets.missed(depth)
    slope[targets.known :][missed[targets.known :] == 0] = 0.0
    return missed, slope


def _numbers(pose: Pose) -> FloatArray:
    return np.array([*pose.shift, *pose.turn, *pose.scale])


def _pose(numbers: FloatArray) -> Pose:
    shift, turn, scale = (tuple(float(number) for number in part) for part in numbers.reshape(3, 3))
    return Pose(shift, turn, scale)  # type: ignore[arg-type]

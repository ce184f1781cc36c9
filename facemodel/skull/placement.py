"""Where a skull lies: moved, turned about its own middle and scaled along its own axes, with all that hangs on it."""

from __future__ import annotations

from dataclasses import replace

import numpy as np
from scipy.spatial.transform import Rotation

from facemodel.errors import SkullError
from facemodel.face import AT_REST, Face, Jaw, Placement, Pose, Skull
from facemodel.laying.places import nearest
from facemodel.mesh import Mesh
from fem.types import FloatArray

FARTHEST = 200.0
"""Millimetres that a skull may be moved along one axis; beyond it has left the head."""

SMALLEST, LARGEST = 0.25, 4.0
"""Times its size that a skull may be scaled along one axis."""


def middle_of(skull: Skull) -> FloatArray:
    """The middle (3,) of the box about both bones."""
    points = np.concatenate([skull.cranium.positions, skull.mandible.positions])
    return np.asarray((points.min(axis=0) + points.max(axis=0)) / 2)


def pivot_of(skull: Skull) -> FloatArray:
    """The point (3,) that a skull is turned about and scaled from, where it is when nothing is moved."""
    return skull.placement.centre if len(skull.placement.feet) else middle_of(skull)


def turned(pose: Pose) -> FloatArray:
    """The rotation (3, 3) of a pose: about x, then y, then z of the head."""
    return np.asarray(Rotation.from_euler("xyz", pose.turn, degrees=True).as_matrix())


def pose_matrix(pose: Pose, pivot: FloatArray) -> FloatArray:
    """The affine map (4, 4) of a pose about a point (3,): scaled along the skull's axes, turned, moved."""
    linear = turned(pose) * np.array(pose.scale)
    matrix = np.eye(4)
    matrix[:3, :3] = linear
    matrix[:3, 3] = pivot + np.array(pose.shift) - linear @ pivot
    return matrix


def way_between(skull: Skull, pose: Pose) -> FloatArray:
    """The affine map (4, 4) that takes a skull from where it lies to another pose."""
    pivot = pivot_of(skull)
    back = np.linalg.inv(pose_matrix(skull.placement.pose, pivot))
    return np.asarray(pose_matrix(pose, pivot) @ back)


def carried(points: FloatArray, way: FloatArray) -> FloatArray:
    """Points (n, 3) under an affine map (4, 4)."""
    return np.asarray(points @ way[:3, :3].T + way[:3, 3])


def checked(pose: Pose) -> Pose:
    """The pose itself.

    Raises
    ------
    SkullError
        If it is nowhere, or far beyond any head.
    """
    numbers = np.array([pose.shift, pose.turn, pose.scale])
    if not np.isfinite(numbers).all():
        raise SkullError("The skull’s place has a number that is none; give millimetres, degrees and percent.")
    if np.abs(pose.shift).max() > FARTHEST:
        raise SkullError(f"The skull cannot be moved farther than {FARTHEST:g} mm; it would leave the head.")
    if min(pose.scale) < SMALLEST or max(pose.scale) > LARGEST:
        raise SkullError(
            f"The skull cannot be scaled to {100 * min(pose.scale):.0f} or {100 * max(pose.scale):.0f} %; "
            f"keep between {100 * SMALLEST:.0f} and {100 * LARGEST:.0f} %."
        )
    return pose


def placed(face: Face, pose: Pose) -> Skull:
    """The skull of a face in another pose; bones, teeth, the hinge of the jaw and the feet of the springs go along.

    The same pose gives the same skull whatever lies between, to rounding: it is always reckoned from how the skull lay
    before it was moved at all.  Springs are laid anew, see `feet_under`; which vertices of the skin hang on the jaw
    stays, since that is a question of the skin.

    Raises
    ------
    SkullError
        If it cannot lie there.
    """
    skull, way = face.skull, way_between(face.skull, checked(pose))
    before = skull.placement
    at_rest = before.feet if len(before.feet) else skull.anchors
    home = pose == AT_REST
    return replace(
        with_bones_moved(skull, way),
        anchors=at_rest if home else feet_under(face.skin, at_rest, pose_matrix(pose, pivot_of(skull))),
        placement=Placement() if home else Placement(pose, pivot_of(skull), at_rest),
    )


def with_bones_moved(skull: Skull, way: FloatArray) -> Skull:
    """Bones and hinge under an affine map (4, 4); what belongs to the skin stays."""
    return replace(
        skull,
        cranium=skull.cranium.moved(carried(skull.cranium.positions, way)),
        mandible=skull.mandible.moved(carried(skull.mandible.positions, way)),
        jaw=Jaw(carried(skull.jaw.axis, way), carried(skull.jaw.teeth[None], way)[0]),
    )


def feet_under(skin: Mesh, feet: FloatArray, way: FloatArray) -> FloatArray:
    """Where the springs of a skin end (N, 3) when the bone has moved.

    Feet lie on one smooth surface, with the triangles of the skin.  It moves with the bone, and every spring then
    goes to the place of it that is nearest to its own vertex; how far off that place the foot lay before (springs
    beside nose and ears run aslant) is kept.  A bone that moves along the skin does not drag the springs askew.

    Parameters
    ----------
    skin : of N vertices
    feet : (N, 3) where the springs ended before
    way : (4, 4) how the bone moved
    """
    before, after = skin.moved(feet), skin.moved(carried(feet, way))
    aslant = feet - nearest(before, skin.positions)[0]
    return np.asarray(nearest(after, skin.positions)[0] + aslant @ way[:3, :3].T)

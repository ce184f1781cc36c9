"""The jaw force of Choe, Lee and Ko 2001, eq. 3: the skin over the mandible is pushed round the jaw's axis."""

from __future__ import annotations

import numpy as np

from facemodel.face import Face
from facemodel.muscles.muscle import Muscle
from fem.types import FloatArray


def jaw_force(muscle: Muscle, face: Face) -> FloatArray:
    """Force per area (N, 3) on the skin, N/mm^2, of an opening jaw.

    f_ij = a_i f_i |e_j| d_ij (eq. 3): e_j is the vector to the nearest point of the axis and d_ij the unit
    vector perpendicular to both, towards opening.  The unit force f_i is given by the muscle's strength, which
    is that at the lower incisors, so that it compares with other muscles.  The vertices that form the jaw
    carry the mandible's share of the bone beneath them, where the paper picks them by hand.
    """
    right, axis = _hinge(face)
    reach = np.linalg.norm(np.cross(axis, face.skull.jaw.teeth - right))
    turn = np.cross(axis, face.skin.positions - right)
    return np.asarray(muscle.strength / reach * face.skull.jawbone[:, None] * turn)


def opening_at_teeth(face: Face) -> FloatArray:
    """Unit vector (3,) along which the lower incisors begin to go when the jaw opens."""
    right, axis = _hinge(face)
    way = np.cross(axis, face.skull.jaw.teeth - right)
    return np.asarray(way / np.linalg.norm(way))


def _hinge(face: Face) -> tuple[FloatArray, FloatArray]:
    """A point (3,) of the jaw's axis, and the unit vector (3,) along it to the subject's left."""
    right, left = face.skull.jaw.axis
    return right, (left - right) / np.linalg.norm(left - right)

"""The rigid motion of the mandible: it opens about its condyles, which slide along the articular eminence."""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from scipy.spatial.transform import Rotation

from facemodel.face import Jaw
from fem.types import FloatArray

STEEPEST = 42.0
"""Degrees below the horizontal in which a condyle sets out from its fossa: the sagittal condylar inclination of
adults is 30 to 50."""

EMINENCE = 24.0
"""Millimetres, radius of the eminence's slope: the path of the condyle flattens as it comes to the crest."""

CREST = 15.0
"""Millimetres along the path after which the condyle rides on the crest and the path is straight."""

LEAST_REACH = 1e-3
"""Millimetres in front of the condyles below which a mandible cannot swing sideways."""


@lru_cache(maxsize=8)
def hinge_frame(jaw: Jaw) -> tuple[FloatArray, FloatArray]:
    """The point (3,) midway between the condyles, and a frame (3, 3) there.

    Its rows are unit vectors: to the left condyle, upwards square to it, and forward.  Both are remembered, as every
    pose asks for them.
    """
    right, left = jaw.axis
    along = (left - right) / np.linalg.norm(left - right)
    up = np.array([0.0, 1.0, 0.0]) - along[1] * along
    if np.linalg.norm(up) < LEAST_REACH:  # an axis that stands upright has no up of its own
        up = np.array([0.0, 0.0, 1.0]) - along[2] * along
    up /= np.linalg.norm(up)
    middle, frame = (right + left) / 2, np.stack([along, up, np.cross(along, up)])
    for kept in (middle, frame):
        kept.setflags(write=False)
    return middle, frame


def condylar_path(slide: float) -> tuple[float, float]:
    """How far upwards and forwards a condyle has come on its way along the eminence, millimetres.

    The eminence is a circular arc that starts steep and ends nearly level; beyond its crest, and behind the fossa,
    the path goes on straight.

    Parameters
    ----------
    slide : millimetres along the path
    """
    start = np.radians(STEEPEST)
    on_arc = min(max(slide, 0.0), CREST)
    angle = start - on_arc / EMINENCE
    beyond = slide - on_arc
    up = EMINENCE * (np.cos(start) - np.cos(angle)) - beyond * np.sin(angle)
    forward = EMINENCE * (np.sin(start) - np.sin(angle)) + beyond * np.cos(angle)
    return float(up), float(forward)


def jaw_motion(jaw: Jaw, degrees: float, slide: float = 0.0, side: float = 0.0) -> FloatArray:
    """Rigid motion (4, 4) of the mandible: it turns about its condyles, they slide forward, and it goes aside.

    Parameters
    ----------
    jaw : the hinge
    degrees : opening
    slide : how far the condyles slide along the articular eminence, millimetres
    side : how far the lower incisors go to the subject's left, millimetres
    """
    middle, frame = hinge_frame(jaw)
    up, forward = condylar_path(slide)
    slid = up * frame[1] + forward * frame[2]
    motion = np.eye(4)
    motion[:3, :3] = Rotation.from_rotvec(np.radians(degrees) * frame[0]).as_matrix()
    motion[:3, 3] = middle - motion[:3, :3] @ middle + slid
    return aside(jaw, side, slid) @ motion if side else motion


def aside(jaw: Jaw, side: float, slid: FloatArray) -> FloatArray:
    """Rigid motion (4, 4) of a mandible that goes to one side: it turns about the condyle of that side.

    The other condyle slides forward, so that the incisors go forward as well as aside, some 60 degrees off the
    midline to either side: the Gothic arch that they are known to draw.

    Parameters
    ----------
    side : of the incisors to the subject's left, millimetres
    slid : (3,) how far the condyles were brought forward before
    """
    middle, frame = hinge_frame(jaw)
    reach = jaw.teeth - middle - (jaw.teeth - middle) @ frame[0] * frame[0]
    length = max(float(np.linalg.norm(reach)), LEAST_REACH)
    turn = Rotation.from_rotvec(side / length**2 * np.cross(reach, frame[0])).as_matrix()
    resting = jaw.axis[1 if side > 0 else 0] + slid
    motion = np.eye(4)
    motion[:3, :3] = turn
    motion[:3, 3] = resting - turn @ resting
    return motion

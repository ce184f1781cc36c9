"""A face that does what landmarks did, as a capture: head motion out, and weights for what is left."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from scipy.spatial.transform import Rotation

from facemodel.actions import ActionUnit
from facemodel.animation.capture import Capture
from facemodel.animation.landmarks.alignment import similarity
from facemodel.animation.landmarks.aspect import squared
from facemodel.animation.landmarks.felt import Felt
from facemodel.animation.landmarks.fit import fitted
from facemodel.animation.landmarks.gaze import gaze
from facemodel.animation.landmarks.lids import with_shut_eyes
from facemodel.animation.landmarks.neutral import calmest, moment_at
from facemodel.animation.landmarks.places import places_on
from facemodel.animation.landmarks.track import LandmarkTrack
from facemodel.basis import Basis
from facemodel.errors import FaceError, ProjectError
from facemodel.face import Face
from facemodel.solution import Progress, silent
from fem.types import FloatArray

UPRIGHT = np.array([1.0, -1.0, -1.0])
"""From the axes of a picture to those of a face."""

FEWEST, FEWEST_STILL = 12, 4
"""Places, and still ones among them, that a face has to have for landmarks to say what it does."""


def captured(
    track: LandmarkTrack,
    face: Face,
    basis: Basis,
    units: Sequence[ActionUnit],
    neutral: float | None = None,
    progress: Progress = silent,
) -> Capture:
    """What a face has to do to move as landmarks did: weights of its fields, and turns of head and eyes in degrees.

    Parameters
    ----------
    track : what a tracker saw
    face, basis, units : of the face
    neutral : when the face was at rest, seconds; the calmest moment of the first second if not given
    progress : is told how far it is, and may raise `Cancelled`

    Raises
    ------
    ProjectError
        If the recording ends before the moment of rest.
    FaceError
        If the face has not the landmarks to be compared by.
    """
    places = places_on(face, basis.display)
    if len(places.indices) < FEWEST or places.still.sum() < FEWEST_STILL:
        raise FaceError(
            f"Landmarks of a tracker are compared with those of the face, and {face.title} has only "
            f"{len(places.indices)} of them; place its landmarks at eyes, nose, mouth and jaw first."
        )
    upright, notes = squared(track.points * UPRIGHT, places)
    still = places.indices[places.still]
    steady = similarity(upright[:, still], upright[:1, still], np.ones(len(still))).of(upright)
    rest = _rest(steady[:, places.indices], track.rate, neutral)
    fit = fitted(upright, steady[rest].mean(axis=0), rest, places, Felt.on(places, basis, units), progress)
    channels = {**_turned(fit.heads), **(gaze(steady, rest) if track.irises else {})}
    moment = (rest.start + rest.stop - 1) / 2 / track.rate
    note = (
        f"The face is at rest at {moment:.2f} s; what its weights leave of the landmarks’ motion is {fit.error:.1f} mm."
    )
    notes = (*track.notes, *notes, note)
    weights = with_shut_eyes(fit.names, fit.weights, steady, rest)
    values = np.column_stack([weights, *channels.values()])
    names = (*fit.names, *channels)
    return Capture("landmarks", names, values.astype(np.float32), track.rate, 0.0, notes, moment)


def _rest(steady: FloatArray, rate: float, neutral: float | None) -> slice:
    """The frames in which the face is at rest, of (N, K, 3) without head motion."""
    if neutral is None:
        return calmest(steady, rate)
    end = (len(steady) - 1) / rate
    if not 0.0 <= neutral <= end:
        raise ProjectError(f"The face cannot be at rest at {neutral:g} s: the recording ends at {end:.2f} s.")
    return moment_at(neutral, rate, len(steady))


def _turned(heads: FloatArray) -> dict[str, FloatArray]:
    """Channels of the head (N,) in degrees, of rotations (N, 3, 3): as `facemodel.kinematics` composes them."""
    turn, lift, tilt = Rotation.from_matrix(heads).as_euler("YXZ", degrees=True).T
    return {"head.yaw": turn, "head.pitch": -lift, "head.roll": -tilt}

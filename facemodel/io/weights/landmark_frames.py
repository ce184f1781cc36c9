"""Frames of landmarks, checked: how many points, gaps bridged and told, at even steps of time."""

from __future__ import annotations

from typing import Any

import numpy as np
from numpy.typing import NDArray

from facemodel.animation.landmarks import MESH, WITH_IRISES, LandmarkTrack
from facemodel.io.damage import DamageError
from facemodel.io.weights.timing import even
from fem.types import BoolArray, FloatArray

AGAIN = "write it again as frames of 468 or 478 points x, y, z of MediaPipe’s face mesh"

FARTHEST = 1e6
"""Pixels; a point that is farther away is none."""

FLAT = 1e-6
"""Share of the face's own place that its points have to be spread over; less is one point, which trackers write when
they see no face."""


def tracked(points: FloatArray, times: NDArray[Any] | None, rate: float | None) -> LandmarkTrack:
    """Landmarks (N, 468 or 478, 3) at even steps; frames without a face are bridged.

    Parameters
    ----------
    points : not a number where one is missing
    times : (N,) seconds; none if they are not noted
    rate : frames per second, if somebody says so; noted times are then not looked at

    Raises
    ------
    DamageError
        If they have another shape, no frame shows a face, or the times go back or are not one for each frame.
    """
    if points.ndim != 3 or points.shape[1] not in (MESH, WITH_IRISES) or points.shape[2] != 3:
        shape = " × ".join(str(count) for count in points.shape)
        raise DamageError("the file", f"holds {shape} numbers of landmarks", AGAIN)
    if times is not None and times.shape != points.shape[:1]:
        raise DamageError("the file", f"has not one time for each of its {len(points)} frames", AGAIN)
    known = np.where(np.abs(points) <= FARTHEST, points, np.nan)
    lost = _faceless(known)
    if lost.all():
        raise DamageError("the file", "shows no face in any of its frames", "record again with the face in the picture")
    known[lost] = np.nan
    notes = (f"In {lost.sum()} of {len(lost)} frames no face was found; they were bridged.",) if lost.any() else ()
    stamps = None if times is None else times.astype(np.float64)
    partly = bool(np.isnan(known[~lost]).any())
    found = even(stamps, known.reshape(len(known), -1), range(1, len(known) + 1), rate)
    if np.isnan(found.values).any():
        raise DamageError("the file", "has a point without a number in every frame", AGAIN)
    told = [note for note in found.notes if partly or not note.endswith("numbers are missing and were bridged.")]
    return LandmarkTrack(found.values.reshape(-1, *points.shape[1:]), found.rate, (*notes, *told))


def _faceless(points: FloatArray) -> BoolArray:
    """The frames (N,) in which nothing is seen, or all points in one place."""
    seen = np.asarray(np.isfinite(points).all(axis=2))
    lost = np.asarray(~np.any(seen, axis=1))
    spread = np.zeros(len(points))
    place = np.ones(len(points))
    spread[~lost] = np.nanstd(points[~lost], axis=1).max(axis=1)
    place[~lost] = np.abs(np.nanmean(points[~lost], axis=1)).max(axis=1)
    return np.asarray(lost | (spread <= FLAT * place))

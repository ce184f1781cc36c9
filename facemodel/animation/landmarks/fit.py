"""Weights and turns of the head that bring a face where landmarks went."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.spatial.transform import Rotation

from facemodel.animation.landmarks.alignment import similarity
from facemodel.animation.landmarks.felt import Felt
from facemodel.animation.landmarks.fitting import Fitter
from facemodel.animation.landmarks.places import Places, measures
from facemodel.solution import Progress
from fem.types import FloatArray

DEPTH = 0.3
"""How much the square of what a picture hides counts beside one of what it shows: trackers guess the depth."""

ROUNDS = 3
"""Times that the head is fitted and then the weights: first by still places, then by all, what weights moved of them
taken off."""

RESTLESS = 0.2
"""How much a place that expressions move counts beside a still one then: with none of it brows pull at each other for
what a forehead is seen to move, with as much of it a head turns for a jaw."""

SMALLEST, LARGEST = 0.5, 2.0
"""A mouth or an eye is at most so much smaller or larger, beside the head, than those of the face."""


@dataclass(frozen=True, eq=False)
class Fit:
    """What the points of a performance say.

    Attributes
    ----------
    names : (M,) fields
    weights : (N, M) of them
    heads : (N, 3, 3) how the head is turned against the moment of rest
    error : root mean square of what weights leave of the motion, across the picture, millimetres
    """

    names: tuple[str, ...]
    weights: FloatArray
    heads: FloatArray
    error: float


def fitted(upright: FloatArray, shape: FloatArray, rest: slice, places: Places, felt: Felt, progress: Progress) -> Fit:
    """Weights and heads of a performance.

    Parameters
    ----------
    upright : (N, P, 3) points of the mesh, y up
    shape : (P, 3) the face at rest in their space
    rest : the frames of that moment
    places, felt : of the face
    progress : is told how far it is, and may raise `Cancelled`
    """
    seen, own = upright[:, places.indices], shape[places.indices]
    still = places.still
    laid = similarity(own[None, still], places.rest[None, still], places.weights[still]).of(own[None])[0]
    alike = _alike(laid, places)[:, None]
    trust = places.weights[:, None] * np.array([1.0, 1.0, DEPTH])
    fitter = Fitter(felt.fields, trust, felt.peaks, felt.high)
    explained, weights = np.zeros_like(seen), np.zeros((len(seen), len(felt.names)))
    for done in range(ROUNDS):
        progress("Following the landmarks", done / ROUNDS)
        counts = places.weights * np.where(still, 1.0, RESTLESS if done else 0.0)
        heads = similarity(seen, laid + explained / alike, counts)
        moved = (heads.of(seen) - laid) * alike
        weights = fitter.weights(moved, weights)
        explained = np.einsum("nm,mkc->nkc", weights, felt.fields)
    left = float(np.sqrt(((moved - explained)[:, :, :2] ** 2).sum(axis=2).mean()))
    ahead = Rotation.from_matrix(heads.turn[rest]).mean().as_matrix()
    return Fit(felt.names, weights, ahead @ np.swapaxes(heads.turn, 1, 2), left)


def _alike(laid: FloatArray, places: Places) -> FloatArray:
    """How much larger (K,) the region of each place is on the face than on who was seen, whose places are laid on it.

    A mouth twice as wide opens twice as far, and lids that are shut have gone all of their way on either face.
    """
    row = {int(index): k for k, index in enumerate(places.indices)}
    found = np.ones(len(laid))
    for region, pairs in measures().items():
        known = [(row[one], row[other]) for one, other in pairs if one in row and other in row]
        ours, theirs = (sum(float(np.linalg.norm(at[i] - at[j])) for i, j in known) for at in (places.rest, laid))
        if theirs > 0:
            found[[each == region for each in places.regions]] = np.clip(ours / theirs, SMALLEST, LARGEST)
    return found

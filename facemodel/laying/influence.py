"""What a muscle does, for the viewport: its area of influence and its arrows, and models side by side."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, replace

import numpy as np

from facemodel.face import Face
from facemodel.loads import bone_forces
from facemodel.muscles import Muscle
from facemodel.muscles.cosine import cosine_of
from facemodel.muscles.models import MODELS, Action, comparable_models, muscle_action
from facemodel.muscles.muscle import Model
from fem.types import FloatArray, IntArray

COARSE = 12
"""Generated fibres that are enough to see where a muscle acts while it is dragged."""

FAINT = 1e-3
"""Share of a muscle's largest action below which an arrow says nothing."""


@dataclass(frozen=True, eq=False)
class Arrows:
    """What a muscle does at full contraction where it does anything.

    Attributes
    ----------
    vertices : (n,) of the skin
    places : (n, 3) of them, millimetres
    vectors : (n, 3) force per area, N/mm^2, or displacement, mm
    action : which of both
    """

    vertices: IntArray
    places: FloatArray
    vectors: FloatArray
    action: Action


def coarse(muscle: Muscle) -> Muscle:
    """The same muscle with few generated fibres, quick enough to follow the mouse."""
    return replace(muscle, count=min(muscle.count, COARSE))


def influence(muscle: Muscle, face: Face) -> FloatArray:
    """How strongly (N,) a muscle acts on each vertex, from 0 to 1 where it acts most; however strong it is."""
    whole = replace(muscle, strength=1.0, cosine=replace(cosine_of(muscle), share=1.0))
    size = np.linalg.norm(muscle_action(whole, face), axis=1)
    most = float(size.max())
    return np.asarray(size / most if most > 0 else size)


def arrows(muscle: Muscle, face: Face) -> Arrows:
    """What a muscle does to the skin as it is solved: forces are turned along the bone under them."""
    action = MODELS[muscle.model].action
    vectors = bone_forces(muscle, face) if action == "force" else muscle_action(muscle, face)
    size = np.linalg.norm(vectors, axis=1)
    vertices = np.flatnonzero(size > FAINT * size.max())
    return Arrows(vertices, face.skin.positions[vertices], vectors[vertices], action)


def side_by_side(muscle: Muscle) -> Mapping[Model, Muscle]:
    """The same muscle under every model that can work on what it is made of."""
    return {model: replace(muscle, model=model) for model in comparable_models(muscle)}

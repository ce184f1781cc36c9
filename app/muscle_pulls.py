"""Which muscle lies at a place of the skin, kept as long as the muscles are the same."""

from __future__ import annotations

from dataclasses import replace
from weakref import WeakKeyDictionary

import numpy as np

from facemodel.face import Face
from facemodel.muscles import Muscle
from facemodel.muscles.models import muscle_action
from facemodel.project import Project
from facemodel.sameness import Kept
from facemodel.sources import acting
from fem.types import FloatArray

FAINTEST = 0.05
"""Share of its largest pull below which a muscle is not felt at a place."""

SMALLEST = 1e-12
"""Pull of a muscle that has none."""

BELT = 0.55
"""The same of a ring, which has no ends: it lies where it is strong, and its force fades far beyond."""

ALL_ALONG, BROADER = 0.7, 1.5
"""Kappa of fibres that pull much the same along their whole length, and how much wider a belly is than the strip of
skin that it pulls: a muscle lies where its belly is, even if it moves the skin only where it is attached, as frontalis
does at the brow."""


class MusclePulls:
    """Where muscles lie under the skin; painting the face does not change it."""

    def __init__(self) -> None:
        self._kept: WeakKeyDictionary[Muscle, Kept[FloatArray]] = WeakKeyDictionary()

    def of(self, muscle: Muscle, face: Face) -> FloatArray:
        """How strongly (N,) a muscle would act if its fibres pulled all along, N/mm^2 or mm as its model says."""
        kept = self._kept.setdefault(muscle, Kept())
        return kept.get(acting(muscle, face), lambda: np.linalg.norm(muscle_action(_belly(muscle), face), axis=1))

    def strongest(self, project: Project, vertex: int, hidden: frozenset[str] = frozenset()) -> Muscle | None:
        """The muscle that lies most under a skin vertex, measured by its own largest pull; None where none does."""
        best, most = None, 0.0
        for muscle in project.muscles:
            pull = self.of(muscle, project.face)
            share = float(pull[vertex]) / max(float(pull.max()), SMALLEST)
            if muscle.key not in hidden and share > max(most, FAINTEST if muscle.fibres else BELT):
                best, most = muscle, share
        return best


def _belly(muscle: Muscle) -> Muscle:
    """A muscle of fibres as wide as its belly and pulling all along it; any other as it is."""
    if not muscle.fibres:
        return muscle
    return replace(muscle, kappa=min(muscle.kappa, ALL_ALONG), width=BROADER * muscle.width)

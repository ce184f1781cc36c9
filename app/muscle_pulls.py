"""Where muscles pull on the skin, kept as long as they act the same."""

from __future__ import annotations

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


class MusclePulls:
    """How strongly muscles act on every vertex; painting the face does not change it."""

    def __init__(self) -> None:
        self._kept: WeakKeyDictionary[Muscle, Kept[FloatArray]] = WeakKeyDictionary()

    def of(self, muscle: Muscle, face: Face) -> FloatArray:
        """How strongly (N,) a muscle acts at full contraction, N/mm^2 or mm as its model says."""
        kept = self._kept.setdefault(muscle, Kept())
        return kept.get(acting(muscle, face), lambda: np.linalg.norm(muscle_action(muscle, face), axis=1))

    def strongest(self, project: Project, vertex: int, hidden: frozenset[str] = frozenset()) -> Muscle | None:
        """The muscle that pulls most at a skin vertex, measured by its own largest pull; None where none does."""
        best, share = None, FAINTEST
        for muscle in project.muscles:
            pull = self.of(muscle, project.face)
            top = float(pull.max())
            if muscle.key not in hidden and top > 0 and pull[vertex] / top > share:
                best, share = muscle, float(pull[vertex] / top)
        return best

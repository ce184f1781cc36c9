"""Fit all muscles of one head to another one, and say how well that went."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from facemodel.face import Face
from facemodel.laying.checks import complaints
from facemodel.laying.fitting import fitted_atlas
from facemodel.laying.warp import control_points, landmark_warp
from facemodel.muscles import Muscle
from fem.types import FloatArray


@dataclass(frozen=True, eq=False)
class AtlasFit:
    """Muscles on another head.

    Attributes
    ----------
    muscles : as they were fitted
    landmarks : how many places both heads share
    scale : (3,) how much wider, higher and deeper the new head is
    bend : millimetres of the landmarks, root mean square, that scaling alone misses and the rest of the warp bends
    settled : millimetres that an end went at most to lie again on what it lay on
    furthest : key of the muscle whose end that was; empty without fibres
    complaints : why muscles cannot be used as they lie, one sentence each
    """

    muscles: tuple[Muscle, ...]
    landmarks: int
    scale: FloatArray
    bend: float
    settled: float
    furthest: str
    complaints: tuple[str, ...]

    @property
    def sentences(self) -> tuple[str, ...]:
        """What a person has to know of it."""
        wide, high, deep = self.scale
        said = [
            f"{len(self.muscles)} muscles by {self.landmarks} landmarks.",
            f"The head is {wide:.2f} times as wide, {high:.2f} times as high and {deep:.2f} times as deep; "
            f"beyond that the landmarks bend by {self.bend:.1f} mm (rms).",
        ]
        if self.furthest:
            said.append(f"Ends went {self.settled:.1f} mm at most to lie on bone and skin again (“{self.furthest}”).")
        if not self.complaints:
            said.append("All of them can be used as they lie.")
        return (*said, *self.complaints)


def fit_atlas(muscles: Sequence[Muscle], source: Face, target: Face) -> AtlasFit:
    """All muscles of the head ``source`` on the head ``target``, with a report.

    Raises
    ------
    MuscleError
        If the heads share too few landmarks, or these lie in a plane.
    """
    fitted = fitted_atlas(muscles, source, target)
    here, there = control_points(source), control_points(target)
    shared = [name for name in here if name in there]
    start, goal = (np.concatenate([places[name] for name in shared]) for places in (here, there))
    map_, bend = _affine(start, goal)
    settled, furthest = _settling(muscles, fitted, source, target)
    return AtlasFit(
        muscles=fitted,
        landmarks=len(set(shared) & source.landmarks.keys()),
        scale=np.linalg.norm(map_, axis=0),
        bend=bend,
        settled=settled,
        furthest=furthest,
        complaints=tuple(complaint for muscle in fitted for complaint in complaints(muscle, target)),
    )


def _affine(start: FloatArray, goal: FloatArray) -> tuple[FloatArray, float]:
    """The linear part (3, 3) of the affine map that meets places best, and by how much it misses them, rms."""
    table = np.column_stack([start, np.ones(len(start))])
    solution = np.linalg.lstsq(table, goal, rcond=None)[0]
    missed = np.linalg.norm(table @ solution - goal, axis=1)
    return np.asarray(solution[:3].T), float(np.sqrt(np.mean(missed**2)))


def _settling(muscles: Sequence[Muscle], fitted: Sequence[Muscle], source: Face, target: Face) -> tuple[float, str]:
    """How far ends went from where the warp took them, at most, and of which muscle that end is."""
    warp = landmark_warp(control_points(source), control_points(target))
    most, furthest = 0.0, ""
    for before, after in zip(muscles, fitted, strict=True):
        for old, new in zip(before.fibres, after.fibres, strict=True):
            moved = warp(np.array([old.origin, old.attachment]))
            away = float(np.linalg.norm(moved - [new.origin, new.attachment], axis=1).max())
            if away > most:
                most, furthest = away, after.key
    return most, furthest

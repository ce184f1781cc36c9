"""What knobs do to the goals of a face, to first order: one factorisation tells of them all.

A knob of a muscle changes its load alone, so that its effect is one more solve.  A knob of the tissue changes the
matrix K; there K u = f gives  K du = df - dK u  for the field u of every goal's best mixture.
"""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from scipy.linalg import cholesky, solve_triangular
from scipy.optimize import nnls

from facemodel.anatomy.recipe import Anatomy
from facemodel.calibration.knobs import Knob
from facemodel.calibration.trial import TINY, Met, Trial, named_keys
from facemodel.columns import Told
from facemodel.muscles import Muscle
from fem.types import FloatArray, IntArray

SMALL = 0.35
"""Steps of a knob that tell its slope: small against the bend of its effect, large against the grain of a mesh."""

FIRM = 1e-10
"""Share of a Gram matrix's diagonal that keeps it definite where two muscles do the same."""

WHOLE = -1
"""In place of a muscle: the whole mixture changes."""


@dataclass(frozen=True, eq=False)
class Slope:
    """One goal about where the knobs stand now: inner products of all vectors that make up its field.

    Attributes
    ----------
    products : (v, v) of the k muscles' fields first, then of what turning knobs adds
    onto : (v,) of all of them with the measured field
    size : norm of the measured field
    knob : (v - k,) which knob adds each vector
    muscle : (v - k,) to which of the k muscles, or `WHOLE`
    """

    products: FloatArray
    onto: FloatArray
    size: float
    knob: IntArray
    muscle: IntArray

    def cosine(self, turns: FloatArray) -> tuple[float, FloatArray]:
        """Cosine of the best mixture when the knobs are turned so far from here, and its slope by each of them."""
        count, whole = len(self.onto) - len(self.knob), self.muscle == WHOLE
        rows = np.arange(count, len(self.onto))
        fixed, mixing = np.zeros(len(self.onto)), np.eye(len(self.onto), count)
        fixed[rows[whole]] = turns[self.knob[whole]]
        mixing[rows[~whole], self.muscle[~whole]] = turns[self.knob[~whole]]
        pulls = _nearest(mixing.T @ self.products @ mixing, mixing.T @ (self.onto - self.products @ fixed))
        mixed = fixed + mixing @ pulls
        along, pulled = float(mixed @ self.onto), self.products @ mixed
        length = max(float(np.sqrt(max(float(mixed @ pulled), 0.0))), TINY)
        by_vector = (self.onto - along / length**2 * pulled) / (length * self.size)
        by_turn = by_vector[rows] * np.where(whole, 1.0, pulls[np.where(whole, 0, self.muscle)])
        return along / (length * self.size), np.bincount(self.knob, by_turn, len(turns)).astype(np.float64)


def _nearest(gram: FloatArray, onto: FloatArray) -> FloatArray:
    """Contractions (k,), not below zero, of least squares, from the inner products of the columns."""
    scale = np.sqrt(np.maximum(np.diag(gram), TINY))
    upper = cholesky(gram / np.outer(scale, scale) + FIRM * np.eye(len(gram)))
    return np.asarray(nnls(upper, solve_triangular(upper, onto / scale, trans="T"))[0] / scale)


def small_turns(knobs: Sequence[Knob], steps: FloatArray) -> FloatArray:
    """By how much to turn each knob (n,) from where it stands to feel its slope: upwards, unless that is its end."""
    most = np.array([knob.most for knob in knobs])
    return np.where(steps + SMALL > most, -SMALL, SMALL)


def slopes(trial: Trial, anatomy: Anatomy, knobs: Sequence[Knob], smalls: FloatArray, told: Told) -> list[Slope]:
    """The slopes of all goals of a face where the knobs stand now.

    Parameters
    ----------
    smalls : steps (n,) by which each knob is turned to feel its slope
    told : how many knobs have been tried and of how many; whatever it raises ends it
    """
    met = list(trial.met(anatomy))
    added: list[list[_Added]] = [[] for _ in met]
    of_tissue = [number for number, knob in enumerate(knobs) if not knob.muscle]
    for number, key, change in _of_muscles(trial, anatomy, knobs, smalls, lambda done: told(done, len(knobs))):
        name = knobs[number].muscle
        for goal, own in zip(met, added, strict=True):
            if key in goal.goal.groups.get(name, ()):
                own.append(_Added(number, goal.names.index(name), trial.sign(goal.goal, name) * change))
    mixtures = [trial.mixture(anatomy, goal) for goal in met]
    for done, number in enumerate(of_tissue):
        told(len(knobs) - len(of_tissue) + done, len(knobs))
        other = knobs[number].turned(anatomy, float(smalls[number])).tissue
        for own, change in zip(added, trial.forward.changes(anatomy.tissue, other, mixtures), strict=True):
            own.append(_Added(number, WHOLE, change / smalls[number]))
    return [_slope(trial, goal, own) for goal, own in zip(met, added, strict=True)]


@dataclass(frozen=True, eq=False)
class _Added:
    """Displacement (N, 3) that one step of a knob adds to one of a goal's muscles, or to its whole mixture."""

    knob: int
    muscle: int
    change: FloatArray


def _of_muscles(
    trial: Trial, anatomy: Anatomy, knobs: Sequence[Knob], smalls: FloatArray, told: Callable[[int], None]
) -> Iterator[tuple[int, str, FloatArray]]:
    """Number of a knob, key of a muscle that it turns, and what one step changes of its field (N, 3)."""
    named = named_keys([trial])
    turned: list[tuple[int, Muscle]] = []
    for number, knob in enumerate(knobs):
        if knob.muscle in named:
            other = knob.turned(anatomy, float(smalls[number]))
            turned += [(number, muscle) for muscle in trial.forward.muscles(other, named[knob.muscle])]
    now = trial.forward.muscle_fields(anatomy, {muscle.key for _, muscle in turned})
    of_muscles = sum(bool(knob.muscle) for knob in knobs)
    fields = trial.forward.fields_of(
        [muscle for _, muscle in turned], anatomy.tissue, lambda done, all_: told(of_muscles * done // max(all_, 1))
    )
    for (number, muscle), field in zip(turned, fields, strict=True):
        yield number, muscle.key, (field - now[muscle.key]) / smalls[number]


def _slope(trial: Trial, met: Met, added: Sequence[_Added]) -> Slope:
    # A muscle that acts on both sides is turned on both at once; its vectors may stay apart.
    vectors = np.concatenate([met.columns, *(trial.weighted(each.change)[:, None] for each in added)], axis=1)
    return Slope(
        vectors.T @ vectors,
        vectors.T @ met.target,
        float(np.linalg.norm(met.target)),
        np.array([each.knob for each in added], dtype=np.int64),
        np.array([each.muscle for each in added], dtype=np.int64),
    )

"""Learn anatomy from measured expressions: turn the knobs of the recipe as long as the fields come nearer.

There is no parameter per vertex.  What is learned are the numbers of the recipe, in words of landmarks, so that it
carries over to every head; and how strongly each action unit contracts its muscles.

In every round the slope of every goal by every knob is found at the cost of one factorisation (`slopes`).  The small
problem that they make is solved at once for all knobs, none farther than a radius from where it stands; then the new
recipe is solved in full.  If it is not better, the slopes did not hold that far, and the radius is halved.
"""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np
from scipy.optimize import minimize

from facemodel.anatomy.recipe import Anatomy
from facemodel.calibration.knobs import Knob, knobs, turned
from facemodel.calibration.slopes import Slope, slopes, small_turns
from facemodel.calibration.trial import Trial, named_keys
from facemodel.solution import Cancelled, Progress
from fem.types import BoolArray, FloatArray

GAIN = 3e-4
"""Least rise of the mean cosine for which knobs are turned: less is noise of the mesh."""

ENOUGH = 2e-3
"""Rise of the mean cosine in a round below which the next one is not worth its minute."""

CAUTION = 2e-3
"""Loss of mean cosine that one step away from where all knobs stood has to win back: what one face has measured must
not bend the anatomy of all."""

RADIUS, LEAST_RADIUS = 1.0, 0.25
"""Steps that a knob goes in one round, at first and at least: below that nothing is gained that is more than noise."""

ROUNDS = 4
"""Most rounds: each wins about half of what the one before it has left."""

STEADY = 1e-2
"""Steps below which a knob counts as not turned."""


@dataclass(frozen=True)
class Change:
    """Cosine of one goal before and after something was learned."""

    name: str
    before: float
    after: float


@dataclass(frozen=True)
class Learned:
    """What was learned.

    Attributes
    ----------
    anatomy : the recipe with its knobs turned
    mixtures : contraction of each muscle by the number of the action unit, the strongest 1
    turns : steps by the name of each knob that was turned
    goals : what it was learned from, in their order
    at_bounds : how many knobs were turned as far as they go
    stopped : whether it was ended before there was nothing left to gain
    """

    anatomy: Anatomy
    mixtures: Mapping[int, Mapping[str, float]]
    turns: Mapping[str, float]
    goals: tuple[Change, ...]
    at_bounds: int = 0
    stopped: bool = False

    @property
    def before(self) -> float:
        """Mean cosine of all goals at first."""
        return float(np.mean([goal.before for goal in self.goals]))

    @property
    def after(self) -> float:
        """Mean cosine of all goals at last."""
        return float(np.mean([goal.after for goal in self.goals]))


def learned(
    trials: Sequence[Trial],
    anatomy: Anatomy,
    progress: Progress,
    rounds: int = ROUNDS,
    turnable: Callable[[Knob], bool] = lambda _: True,
) -> Learned:
    """Turn all knobs that move the goals of some faces, as long as the mean cosine rises by more than it costs.

    Parameters
    ----------
    trials : the faces; all goals of all of them weigh the same
    progress : if it raises `Cancelled`, what was learned until then is returned, marked as stopped
    rounds : at most
    turnable : which knobs may be turned

    Raises
    ------
    Cancelled
        If that is raised before the faces are solved for the first time.
    """
    search = _Search(trials, anatomy, turnable, progress)
    before, stopped = search.cosines, False
    try:
        _turn(search, progress, rounds)
    except Cancelled:
        stopped = True
    result = search.anatomy
    mixtures: dict[int, dict[str, float]] = {}
    for trial in trials:
        mixtures |= trial.cosines(result)[1]
    names = [aim.name for trial in trials for aim in trial.aims]
    changes = tuple(map(Change, names, before.tolist(), search.cosines.tolist()))
    turns = {k.name: float(s) for k, s in zip(search.knobs, search.steps, strict=True) if abs(s) > STEADY}
    return Learned(result, mixtures, turns, changes, search.at_bounds, stopped)


class _Search:
    """The knobs where they stand, and how near the goals are there."""

    def __init__(
        self, trials: Sequence[Trial], anatomy: Anatomy, turnable: Callable[[Knob], bool], progress: Progress
    ) -> None:
        named = named_keys(trials)
        self._trials, self._start = trials, anatomy
        own = (knob for knob in knobs(anatomy) if not knob.muscle or knob.muscle in named)
        self.knobs: tuple[Knob, ...] = tuple(filter(turnable, own))
        self._least, self._most = (np.array([getattr(k, end) for k in self.knobs]) for end in ("least", "most"))
        self.steps = np.zeros(len(self.knobs))
        self.cosines = self._cosines(self.steps, progress)

    @property
    def anatomy(self) -> Anatomy:
        """The recipe with the knobs turned."""
        return turned(self._start, self.knobs, self.steps)

    @property
    def at_bounds(self) -> int:
        """How many knobs are turned as far as they go."""
        ended = (self.steps < self._least + STEADY) | (self.steps > self._most - STEADY)
        return int((ended & (np.abs(self.steps) > STEADY)).sum())

    @property
    def worth(self) -> float:
        """Mean cosine less what caution costs."""
        return _worth(self.cosines, self.steps)

    def slopes(self, progress: Progress) -> list[Slope]:
        """The slopes of all goals here."""
        found: list[Slope] = []
        for number, trial in enumerate(self._trials):

            def told(done: int, total: int, face: int = number) -> None:
                progress("Trying all knobs", (face + done / total) / len(self._trials))

            found += slopes(trial, self.anatomy, self.knobs, small_turns(self.knobs, self.steps), told)
        return found

    def best(self, found: Sequence[Slope], radius: float) -> FloatArray:
        """Where (n,) the knobs do best by slopes that were found here, none farther than a radius from here."""
        here = self.steps

        def loss(other: FloatArray) -> tuple[float, FloatArray]:
            cosines, rises = zip(*(slope.cosine(other - here) for slope in found), strict=True)
            rise = np.mean(rises, axis=0) - 2 * CAUTION * other / len(other)
            return -_worth(np.array(cosines), other), -rise

        bounds = np.stack([np.maximum(here - radius, self._least), np.minimum(here + radius, self._most)], axis=1)
        return np.asarray(minimize(loss, here, jac=True, method="L-BFGS-B", bounds=bounds).x)

    def go(self, steps: FloatArray, progress: Progress) -> bool:
        """Turn the knobs there if that is worth it, or those of them that it is worth it for."""
        tried = [(steps, self._cosines(steps, progress))]
        some = np.where(self._fared_worse(tried[0][1]), self.steps, steps)
        if (some != steps).any():
            tried.append((some, self._cosines(some, progress)))
        there, cosines = max(tried, key=lambda each: _worth(each[1], each[0]))
        if _worth(cosines, there) < self.worth + GAIN:
            return False
        self.steps, self.cosines = there, cosines
        return True

    def _fared_worse(self, cosines: FloatArray) -> BoolArray:
        """Knobs (n,) of muscles whose own goals are met less well than now, all of them together."""
        gain: dict[str, float] = {}
        aims = [aim for trial in self._trials for aim in trial.aims]
        for aim, change in zip(aims, cosines - self.cosines, strict=True):
            for name in aim.groups:
                gain[name] = gain.get(name, 0.0) + float(change)
        return np.array([gain.get(knob.muscle, 0.0) < 0 for knob in self.knobs])

    def _cosines(self, steps: FloatArray, progress: Progress) -> FloatArray:
        here, found = turned(self._start, self.knobs, steps), []
        for trial in self._trials:
            progress("Solving all goals", 0.0)
            for met in trial.met(here):
                found.append(met.cosine)
                progress("Solving all goals", len(found) / sum(len(each.aims) for each in self._trials))
        return np.array(found)


SLOPES = 0.85
"""Share of a round's time that its slopes take; the rest is for going there."""


def _turn(search: _Search, progress: Progress, rounds: int) -> None:
    radius = RADIUS
    for number in range(rounds):
        at = search.worth
        found = search.slopes(_part(search, progress, number, rounds, 0.0))
        while not search.go(search.best(found, radius), _part(search, progress, number, rounds, SLOPES)):
            radius /= 2
            if radius < LEAST_RADIUS:
                return
        if search.worth < at + ENOUGH:
            return


def _part(search: _Search, progress: Progress, number: int, rounds: int, start: float) -> Progress:
    """Progress of the first or the second part of a round."""
    length = (1 - SLOPES) if start else SLOPES
    said = f"round {number + 1} of at most {rounds}, mean cosine {search.cosines.mean():.3f}"

    def told(text: str, share: float) -> None:
        progress(f"{text}, {said}", (number + start + length * share) / rounds)

    return told


def _worth(cosines: FloatArray, steps: FloatArray) -> float:
    return float(cosines.mean()) - CAUTION * float(np.mean(steps**2))

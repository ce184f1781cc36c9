"""Learn anatomy from measured expressions: turn the knobs of the recipe one by one as long as the fields come nearer.

There is no parameter per vertex.  What is learned are the numbers of the recipe, in words of landmarks, so that it
carries over to every head; and how strongly each action unit contracts its muscles.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy.optimize import nnls

from facemodel.actions import ActionUnit, JawMotion
from facemodel.anatomy.recipe import Anatomy
from facemodel.calibration.forward import Forward
from facemodel.calibration.knobs import MOST_TURNS, Knob, knobs, turned
from facemodel.solution import Progress
from fem.types import FloatArray

GAIN = 3e-4
"""Least rise of the mean cosine for which a knob is turned: less is noise of the mesh."""

CAUTION = 2e-3
"""Loss of mean cosine that one step away from where all knobs stood has to win back: what one face has measured must
not bend the anatomy of all."""

STRIDES = (1.0, 0.5)
"""Steps by which knobs are turned, one sweep over all of them each."""


@dataclass(frozen=True, eq=False)
class Goal:
    """One measured expression.

    Attributes
    ----------
    name : of the expression
    unit : number of the action unit that answers it
    groups : names of its muscles with the keys that contract together
    jaw : motion of the mandible
    field : (N, 3) what was measured, millimetres
    """

    name: str
    unit: int
    groups: Mapping[str, tuple[str, ...]]
    jaw: JawMotion | None
    field: FloatArray


@dataclass(frozen=True)
class Learned:
    """What was learned.

    Attributes
    ----------
    anatomy : the recipe with its knobs turned
    mixtures : contraction of each muscle by the number of the action unit, the strongest 1
    turns : steps by the name of each knob that was turned
    before, after : mean cosine
    """

    anatomy: Anatomy
    mixtures: Mapping[int, Mapping[str, float]]
    turns: Mapping[str, float]
    before: float
    after: float


def goals(
    measured: Mapping[str, FloatArray], wanted: Mapping[str, Mapping[str, float]], units: Sequence[ActionUnit]
) -> tuple[Goal, ...]:
    """The expressions that one action unit alone answers, which can be learned from.

    Parameters
    ----------
    measured : fields (N, 3) by the name of the expression
    wanted : weights of displacement fields that answer each, see `facemodel.calibration.report.wanted_fields`
    units : the action units of those fields
    """
    made = []
    for name, weights in wanted.items():
        unit = next((u for u in units if set(weights) <= set(u.fields)), None)
        if unit is None or not (unit.muscles or unit.jaw):
            continue
        sides = [field[-1] if unit.paired else "" for field in weights]
        both = sides if sides != [""] else ["L", "R"]
        groups = {m: (m, *(f"{m}_{side}" for side in both)) for m, w in unit.muscles.items() if w}
        jaw = unit.jaw_of(next(iter(weights))) if unit.jaw else None
        made.append(Goal(name, unit.number, groups, jaw, measured[name]))
    return tuple(made)


class Trial:
    """How near a recipe comes to some goals on one face."""

    def __init__(self, forward: Forward, aims: Sequence[Goal], units: Sequence[ActionUnit]) -> None:
        self._forward, self.aims = forward, aims
        self._signs = {u.number: {m: float(np.sign(w)) for m, w in u.muscles.items()} for u in units}
        self._root = np.sqrt(forward.face.skin.vertex_areas)[:, None]

    def cosines(self, anatomy: Anatomy) -> tuple[list[float], dict[int, dict[str, float]]]:
        """Cosine of every goal with the best mixture of its muscles, and the mixtures by action unit."""
        found, mixtures = [], {}
        for aim in self.aims:
            names, columns = self._columns(anatomy, aim)
            target = (aim.field * self._root).ravel()
            sizes = np.maximum(np.linalg.norm(columns, axis=0), np.finfo(np.float64).tiny)
            weights, _ = nnls(columns / sizes, target)
            mixed = (columns / sizes) @ weights
            scale = np.linalg.norm(mixed) * np.linalg.norm(target)
            found.append(float(mixed @ target / scale) if scale > 0 else 0.0)
            pulls = {n: w for n, w in zip(names, weights / sizes, strict=True) if n}
            most = max(pulls.values(), default=0.0)
            signs = self._signs[aim.unit]
            mixtures[aim.unit] = {n: signs[n] * w / most for n, w in pulls.items()} if most > 0 else {}
        return found, mixtures

    def _columns(self, anatomy: Anatomy, aim: Goal) -> tuple[list[str], FloatArray]:
        """Fields (3 N, k) of the muscles of a goal, and of its jaw under no name, weighted by the root of the area."""
        known = self._forward.muscle_fields(anatomy, {key for keys in aim.groups.values() for key in keys})
        names: list[str] = []
        columns = []
        for name, keys in aim.groups.items():
            own = [known[key] for key in keys if key in known]
            if own:
                names.append(name)
                columns.append(self._signs[aim.unit][name] * np.sum(own, axis=0))
        if aim.jaw is not None:
            names.append("")
            columns.append(self._forward.jaw_field(anatomy, aim.jaw))
        return names, np.stack([(field * self._root).ravel() for field in columns], axis=1)


def learned(trial: Trial, anatomy: Anatomy, progress: Progress) -> Learned:
    """Turn every knob that moves the goals, one by one, as long as the mean cosine rises by more than it costs."""
    muscles = {name for aim in trial.aims for name in aim.groups}
    own = tuple(knob for knob in knobs(anatomy) if not knob.muscle or knob.muscle in muscles)
    steps = np.zeros(len(own))
    best = before = _worth(trial, anatomy, own, steps)
    order = [(stride, number) for stride in STRIDES for number in range(len(own))]
    for done, (stride, number) in enumerate(order):
        progress(f"Turning {own[number].name}, mean cosine {best:.3f}", done / len(order))
        for other in _ways(steps, number, stride):
            worth = _worth(trial, anatomy, own, other)
            if worth > best + GAIN:
                steps, best = other, worth
                break
    result = turned(anatomy, own, steps)
    after, mixtures = trial.cosines(result)
    turns = {knob.name: float(step) for knob, step in zip(own, steps, strict=True) if step}
    return Learned(result, mixtures, turns, before, float(np.mean(after)))


def _ways(steps: FloatArray, number: int, stride: float) -> Iterator[FloatArray]:
    for way in (stride, -stride):
        other = steps.copy()
        other[number] += way
        if abs(other[number]) <= MOST_TURNS:
            yield other


def _worth(trial: Trial, anatomy: Anatomy, own: Sequence[Knob], steps: FloatArray) -> float:
    cosines, _ = trial.cosines(turned(anatomy, own, steps))
    return float(np.mean(cosines)) - CAUTION * float(np.mean(steps**2))


def with_mixtures(units: Sequence[ActionUnit], mixtures: Mapping[int, Mapping[str, float]]) -> tuple[ActionUnit, ...]:
    """Action units that contract their muscles as was learned; the others stay as they are."""
    return tuple(
        replace(unit, muscles={**unit.muscles, **mixtures[unit.number]}) if mixtures.get(unit.number) else unit
        for unit in units
    )

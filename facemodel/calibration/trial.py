"""How near a recipe comes to the measured expressions of one face, whatever mixture of muscles serves each best."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy.optimize import nnls

from facemodel.actions import ActionUnit
from facemodel.anatomy.recipe import Anatomy
from facemodel.calibration.assembled import Source
from facemodel.calibration.forward import Forward, Mixture
from facemodel.calibration.goals import Goal, signs
from fem.types import FloatArray

TINY = float(np.finfo(np.float64).tiny)


@dataclass(frozen=True, eq=False)
class Met:
    """A goal, and how its muscles meet it.

    Attributes
    ----------
    goal : the measured expression
    names : k muscles, and the jaw under no name
    columns : (3 N, k) their fields, weighted by the root of the area that each vertex stands for
    target : (3 N,) the measured field, weighted so, too
    pulls : (k,) the contractions, not below zero, that come nearest to it
    """

    goal: Goal
    names: tuple[str, ...]
    columns: FloatArray
    target: FloatArray
    pulls: FloatArray

    @property
    def cosine(self) -> float:
        """Area-weighted cosine of the best mixture with what was measured."""
        mixed = self.columns @ self.pulls
        scale = float(np.linalg.norm(mixed) * np.linalg.norm(self.target))
        return float(mixed @ self.target) / scale if scale > 0 else 0.0


class Trial:
    """One face with its goals, on which recipes are tried out."""

    def __init__(self, forward: Forward, aims: Sequence[Goal], units: Sequence[ActionUnit]) -> None:
        self.forward, self.aims = forward, tuple(aims)
        self._units, self._signs = tuple(units), signs(units)
        self._root = np.sqrt(forward.face.skin.vertex_areas)[:, None]

    def cosines(self, anatomy: Anatomy) -> tuple[list[float], dict[int, dict[str, float]]]:
        """Cosine of every goal with the best mixture of its muscles, and the mixtures by action unit."""
        found, mixtures = [], {}
        for met in self.met(anatomy):
            found.append(met.cosine)
            mixtures[met.goal.unit] = self._mixture(met)
        return found, mixtures

    def met(self, anatomy: Anatomy) -> Iterator[Met]:
        """Every goal with the best mixture of its muscles."""
        for aim in self.aims:
            names, fields = self._fields(anatomy, aim)
            columns, target = np.stack([self.weighted(field) for field in fields], axis=1), self.weighted(aim.field)
            # What the columns span tells all, and is small.
            span, small = np.linalg.qr(columns)
            sizes = np.maximum(np.linalg.norm(columns, axis=0), TINY)
            pulls, _ = nnls(small / sizes, span.T @ target)
            yield Met(aim, tuple(names), columns, target, pulls / sizes)

    def contracted(self, anatomy: Anatomy, units: Sequence[ActionUnit]) -> list[float]:
        """Cosine of every goal with its muscles contracted as action units say, whatever would serve best."""
        weights, found = {unit.number: unit.muscles for unit in units}, []
        for met in self.met(anatomy):
            # The jaw alone has no weight; it moves as its unit has it, as no unit of the jaw has muscles beside it.
            own = [abs(weights[met.goal.unit].get(name, 0.0)) if name else 1.0 for name in met.names]
            found.append(replace(met, pulls=np.array(own)).cosine)
        return found

    def only(self, wanted: Callable[[Goal], bool]) -> Trial:
        """The same face with some of its goals."""
        return Trial(self.forward, [aim for aim in self.aims if wanted(aim)], self._units)

    def weighted(self, field: FloatArray) -> FloatArray:
        """A field (N, 3) as a vector (3 N,) whose products with others are integrals over the skin."""
        return np.asarray((field * self._root).ravel())

    def sign(self, aim: Goal, muscle: str) -> float:
        """Whether a muscle contracts or yields, 1 or -1, for a goal."""
        return self._signs[aim.unit][muscle] if muscle else 1.0

    def mixture(self, anatomy: Anatomy, met: Met) -> Mixture:
        """The best mixture for a goal as what its sources are and the coefficients of its field."""
        aim = met.goal
        muscles = {muscle.key: muscle for muscle in self.forward.muscles(anatomy, _keys(aim))}
        columns = self.forward.columns(anatomy, _keys(aim))
        sources: dict[Source, float] = {}
        parts: list[FloatArray] = []
        for name, pull in zip(met.names, met.pulls, strict=True):
            if not name and aim.jaw is not None:
                sources |= {mode: pull * share for mode, share in self.forward.modes(aim.jaw).items()}
                parts.append(pull * self.forward.jaw_column(anatomy, aim.jaw))
                continue
            weight = self.sign(aim, name) * pull
            own = [key for key in aim.groups[name] if key in columns]
            sources |= {muscles[key]: weight for key in own}
            parts += [weight * columns[key] for key in own]
        return Mixture(sources, np.sum(parts, axis=0))

    def _fields(self, anatomy: Anatomy, aim: Goal) -> tuple[list[str], list[FloatArray]]:
        """Fields (N, 3) of the muscles of a goal, and of its jaw under no name."""
        known = self.forward.muscle_fields(anatomy, _keys(aim))
        names: list[str] = []
        fields = []
        for name, keys in aim.groups.items():
            own = [known[key] for key in keys if key in known]
            if own:
                names.append(name)
                fields.append(self.sign(aim, name) * np.sum(own, axis=0))
        if aim.jaw is not None:
            names.append("")
            fields.append(self.forward.jaw_field(anatomy, aim.jaw))
        return names, fields

    def _mixture(self, met: Met) -> dict[str, float]:
        """Contractions by muscle, the strongest 1."""
        pulls = {name: float(pull) for name, pull in zip(met.names, met.pulls, strict=True) if name}
        most = max(pulls.values(), default=0.0)
        return {name: self.sign(met.goal, name) * pull / most for name, pull in pulls.items()} if most > 0 else {}


def _keys(aim: Goal) -> set[str]:
    return {key for keys in aim.groups.values() for key in keys}


def named_keys(trials: Sequence[Trial]) -> Mapping[str, set[str]]:
    """Keys of the muscles that the goals of some faces contract, by the name of the muscle."""
    found: dict[str, set[str]] = {}
    for trial in trials:
        for aim in trial.aims:
            for name, keys in aim.groups.items():
                found.setdefault(name, set()).update(keys)
    return found

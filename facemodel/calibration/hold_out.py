"""What was learned, told on expressions that nothing was learned from: those left out, and those of another head."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from facemodel.actions import ActionUnit
from facemodel.anatomy.recipe import Anatomy
from facemodel.calibration.adjust import Change, Learned, learned
from facemodel.calibration.goals import with_mixtures
from facemodel.calibration.trial import Trial
from facemodel.solution import Cancelled, Progress

FOLDS = 3
"""Parts of the action units; each is left out once."""

ROUNDS_HELD_OUT = 2
"""Rounds of learning for a cross-check: most is won in them, and there are several to learn."""


@dataclass(frozen=True)
class HeldOut:
    """A cross-check.

    Attributes
    ----------
    learned_from, told_on : in words
    changes : of the expressions that were not learned from, with the mixtures that were known without them
    """

    learned_from: str
    told_on: str
    changes: tuple[Change, ...]

    @property
    def before(self) -> float:
        """Mean cosine with the anatomy that was there at first."""
        return float(np.mean([change.before for change in self.changes]))

    @property
    def after(self) -> float:
        """Mean cosine with what was learned elsewhere."""
        return float(np.mean([change.after for change in self.changes]))


def cross_checks(
    measured: Trial, sculpted: Trial, units: Sequence[ActionUnit], anatomy: Anatomy, found: Learned, progress: Progress
) -> tuple[HeldOut, ...]:
    """Tell what is learned where it was not learned.

    Parameters
    ----------
    measured, sculpted : the measured face, and the default head with what an artist sculpted
    units, anatomy : as they were at first
    found : what was learned on the measured face
    progress : if it raises `Cancelled`, the checks that were done until then are returned
    """

    def told(part: int) -> Progress:
        return lambda text, done: progress(
            f"Cross-check {part + 1} of {FOLDS + 1}: {text}", (part + done) / (FOLDS + 1)
        )

    try:
        checks = [HeldOut(MEASURED, SCULPTED, _changes(sculpted, found, units, anatomy))]
        other = _finished(learned([sculpted], anatomy, told(0), ROUNDS_HELD_OUT))
        checks.append(HeldOut(SCULPTED, MEASURED, _changes(measured, other, units, anatomy)))
        left_out: list[Change] = []
        for fold in range(FOLDS):
            kept, out = parted(measured, fold)
            if kept.aims and out.aims:
                rest = _finished(learned([kept], anatomy, told(fold + 1), ROUNDS_HELD_OUT))
                left_out += _changes(out, rest, units, anatomy)
    except Cancelled:
        return tuple(checks)
    return (*checks, HeldOut(OTHERS, LEFT_OUT, tuple(left_out))) if left_out else tuple(checks)


MEASURED, SCULPTED = "all measured expressions", "the units sculpted on the default head"
OTHERS = f"the measured expressions of other action units, in {FOLDS} turns"
LEFT_OUT = "those of the action units left out"


def parted(trial: Trial, fold: int) -> tuple[Trial, Trial]:
    """The goals of a face without every third action unit, and with these alone; both sides of a unit stay together."""
    numbers = list(dict.fromkeys(aim.unit for aim in trial.aims))
    out = set(numbers[fold::FOLDS])
    return trial.only(lambda aim: aim.unit not in out), trial.only(lambda aim: aim.unit in out)


def _finished(found: Learned) -> Learned:
    if found.stopped:
        raise Cancelled
    return found


def _changes(trial: Trial, found: Learned, units: Sequence[ActionUnit], anatomy: Anatomy) -> tuple[Change, ...]:
    """Cosines before and after with mixtures that the goals themselves had no part in."""
    before = trial.contracted(anatomy, units)
    after = trial.contracted(found.anatomy, with_mixtures(units, found.mixtures))
    return tuple(map(Change, (aim.name for aim in trial.aims), before, after))

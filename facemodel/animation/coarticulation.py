"""Coarticulation by dominance functions (Cohen & Massaro 1993): every sound pulls the lips towards its shape.

Channel by channel, F(t) = sum D_p(t) T_p / (R + sum D_p(t)), where T_p is the target of phoneme p and
D_p(t) = a_p exp(-(e/w)^2) its dominance, e the distance of t from the core of the phoneme, within which it is full,
and w how long before and after it is felt.  R pulls the mouth to rest where nothing is said.  Cohen and Massaro have
the exponent 1; with 2 there is no kink in the middle of a sound.

A weighted mean never quite reaches a target, but lips that say m, b or p do meet.  Around such a sound a share k(t)
rises to 1, and F becomes (1 - k) F + k T.
"""

from __future__ import annotations

from collections.abc import Sequence
from weakref import WeakKeyDictionary

import numpy as np

from facemodel.actions import ActionUnit, resolve
from facemodel.animation.ease import least_jerk
from facemodel.animation.speech import Phoneme, Speech, Viseme, VisemeTable
from facemodel.animation.visemes import mouth_table, parts_of
from facemodel.errors import UnknownNameError
from fem.types import FloatArray

BEFORE, AFTER = 0.11, 0.08
"""Seconds within which a sound is felt ahead of itself and after; lips prepare farther than they linger."""

REST = 0.04
"""Dominance of rest: small beside any sound that is near, large beside all that are 0.2 s away."""

CORE = 0.5
"""Share of a sound, around its middle, in which it is itself."""

CLOSING = 0.07
"""Seconds in which lips come together and part again for m, b and p."""

FELT = 1.0
"""Seconds beyond which a dominance is below 1e-30 and is left out."""

AT_ONCE = 256
"""Times evaluated together, so that only sounds near them are looked at."""


_known: WeakKeyDictionary[Speech, tuple[Sequence[ActionUnit], Mouth]] = WeakKeyDictionary()


def mouth_of(speech: Speech, units: Sequence[ActionUnit]) -> Mouth:
    """Speech as curves, made once as long as it is said with the same units."""
    found = _known.get(speech)
    if found is None or found[0] is not units:
        found = _known[speech] = (units, Mouth(speech, units))
    return found[1]


class Mouth:
    """Speech as curves.

    Attributes
    ----------
    channels : the fields that speech moves
    opening : fields of this face that part the lips, whether speech moves them or not
    """

    def __init__(self, speech: Speech, units: Sequence[ActionUnit]) -> None:
        table = mouth_table()
        visemes = speech.visemes or table.visemes
        sounds = _sounds(speech.phonemes, visemes, () if speech.muted else units)
        seen = {viseme.name: viseme for _, viseme in sounds}
        known = {name: _fields(viseme, units) for name, viseme in seen.items()}
        fields = [known[viseme.name] for _, viseme in sounds]
        self.channels = tuple(sorted({name for each in fields for name in each}))
        self.opening = frozenset(name for unit in table.opens for name in _resolved(unit, units))
        spans = np.array([(sound.start, sound.end) for sound, _ in sounds]).reshape(-1, 2)
        self._starts, self._ends = spans.T
        self._targets = np.array([[each.get(name, 0.0) for name in self.channels] for each in fields])
        self._targets = speech.strength * self._targets.reshape(len(sounds), len(self.channels))
        self._dominance = np.array([viseme.dominance for _, viseme in sounds])
        self._closes = np.array([viseme.closes for _, viseme in sounds], dtype=np.bool_)
        self._latest_end = np.maximum.accumulate(self._ends) if len(sounds) else self._ends

    def at(self, times: FloatArray) -> tuple[FloatArray, FloatArray]:
        """Values (T, C) at times (T,), and how far lips are made to meet (T,), 0 to 1."""
        values, closed = np.zeros((len(times), len(self.channels))), np.zeros(len(times))
        for begin in range(0, len(times), AT_ONCE):
            part = slice(begin, begin + AT_ONCE)
            values[part], closed[part] = self._near(times[part])
        return values, closed

    def _near(self, times: FloatArray) -> tuple[FloatArray, FloatArray]:
        first = np.searchsorted(self._latest_end, times.min() - FELT)
        last = np.searchsorted(self._starts, times.max() + FELT)
        near = slice(int(first), int(last))
        starts, ends, closes = self._starts[near], self._ends[near], self._closes[near]
        if not len(starts):
            return np.zeros((len(times), len(self.channels))), np.zeros(len(times))
        targets = self._targets[near]
        ahead, behind = _distances(times, starts, ends)
        felt = self._dominance[near] * np.exp(-((ahead / BEFORE) ** 2) - (behind / AFTER) ** 2)
        spoken = (felt @ targets) / (REST + felt.sum(axis=1, keepdims=True))
        if not closes.any():
            return spoken, np.zeros(len(times))
        met = 1.0 - least_jerk((ahead + behind)[:, closes] / CLOSING)
        closed = met.max(axis=1)
        sums = met.sum(axis=1, keepdims=True)
        meeting = (met @ targets[closes]) / np.where(sums > 0, sums, 1.0)
        return spoken + closed[:, None] * (meeting - spoken), closed


def _distances(times: FloatArray, starts: FloatArray, ends: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Seconds (T, P) until the core of each sound, and since it; both nothing within."""
    middle, half = (starts + ends) / 2.0, CORE * (ends - starts) / 2.0
    off = times[:, None] - middle
    return np.maximum(-off - half, 0.0), np.maximum(off - half, 0.0)


def _sounds(
    phonemes: Sequence[Phoneme], visemes: Sequence[Viseme], units: Sequence[ActionUnit]
) -> list[tuple[Phoneme, Viseme]]:
    """Every sound with its viseme, glides as one after the other; symbols that nobody knows keep the mouth at rest."""
    if not units:
        return []
    find = VisemeTable(visemes).find
    rest = find("sil") or Viseme("sil")
    found: list[tuple[Phoneme, Viseme]] = []
    for sound in sorted(phonemes, key=lambda each: each.start):
        parts = parts_of(sound.symbol)
        length = (sound.end - sound.start) / len(parts)
        for number, part in enumerate(parts):
            begin = sound.start + number * length
            found.append((Phoneme(part, begin, begin + length), find(part) or rest))
    return found


def _fields(viseme: Viseme, units: Sequence[ActionUnit]) -> dict[str, float]:
    return {field: weight for name, weight in viseme.weights.items() for field in _resolved(name, units)}


def _resolved(name: str, units: Sequence[ActionUnit]) -> tuple[str, ...]:
    """Fields of a unit; none on a face without it, which speaks with the units that it has."""
    try:
        return resolve(name, units)
    except UnknownNameError:
        return ()

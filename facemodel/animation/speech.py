"""Speech: phonemes over time, and the visemes that they are seen as."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping
from dataclasses import dataclass, field


@dataclass(frozen=True)
class Phoneme:
    """One sound.

    Attributes
    ----------
    symbol : ARPAbet (``AH0``) or IPA, or the name of a viseme
    start, end : seconds of the clip
    """

    symbol: str
    start: float
    end: float


@dataclass(frozen=True)
class Word:
    """A word over its phonemes, only to be read; seconds of the clip."""

    text: str
    start: float
    end: float


@dataclass(frozen=True)
class Viseme:
    """What some sounds look like.

    Attributes
    ----------
    name : unique
    symbols : the sounds, in ARPAbet without stress and in IPA
    weights : of action units, by any name that `facemodel.actions.resolve` knows
    dominance : how much it decides against its neighbours, 0 to 1; consonants made behind the lips leave these to the
        vowels beside them
    closes : whether the lips have to meet, whatever is said or felt around it
    """

    name: str
    symbols: tuple[str, ...] = ()
    weights: Mapping[str, float] = field(default_factory=dict)
    dominance: float = 0.5
    closes: bool = False


@dataclass(frozen=True, eq=False)
class Speech:
    """What is said.

    Attributes
    ----------
    phonemes, words : in the order of time
    visemes : the project's own; the shipped set if empty
    strength : how clearly it is spoken; every viseme is multiplied by it
    muted : whether the mouth keeps still
    """

    phonemes: tuple[Phoneme, ...] = ()
    words: tuple[Word, ...] = ()
    visemes: tuple[Viseme, ...] = ()
    strength: float = 1.0
    muted: bool = False


_MARKS = re.compile(r"[ˈˌːˑ.ˑ'‿͡\u0303\u0329\u032f\u0325\u030d\u02b0ʲʷˠ0-9]")
"""Stress, length, syllables, ties and fine points of articulation that no lips show."""


def plain(symbol: str) -> str:
    """A symbol without stress, length and the like: ``AH`` for ``AH0``, ``i`` for ``iː``."""
    return _MARKS.sub("", symbol.strip())


class VisemeTable:
    """Finds the viseme of a symbol: as it is written, then without its marks, then in capitals."""

    def __init__(self, visemes: Iterable[Viseme]) -> None:
        self._by_symbol: dict[str, Viseme] = {}
        for viseme in visemes:
            for symbol in (viseme.name, *viseme.symbols):
                self._by_symbol.setdefault(symbol, viseme)

    def find(self, symbol: str) -> Viseme | None:
        """The viseme of a symbol; none if no viseme has it."""
        bare = plain(symbol)
        for each in (symbol, bare, bare.upper(), bare.lower()):
            if each in self._by_symbol:
                return self._by_symbol[each]
        return None

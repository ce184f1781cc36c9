"""What a file says is said, and when."""

from __future__ import annotations

import math
from collections.abc import Iterable
from dataclasses import dataclass

from facemodel.animation.speech import Phoneme, Word
from facemodel.io.damage import DamageError

AGAIN = "write it again with the program that it comes from"

LATEST = 86_400.0
"""Seconds; a day, beyond which nothing is spoken."""


@dataclass(frozen=True)
class Spoken:
    """Sounds and words.

    Attributes
    ----------
    phonemes, words : in the order of time
    notes : one sentence each for what was left out
    """

    phonemes: tuple[Phoneme, ...]
    words: tuple[Word, ...] = ()
    notes: tuple[str, ...] = ()


def seconds(text: str, where: str) -> float:
    """A time from text.

    Raises
    ------
    DamageError
        If it is no number of seconds.
    """
    try:
        found = float(text)
    except ValueError:
        raise DamageError(where, f"says “{text[:30]}” where a time has to be", AGAIN) from None
    if not math.isfinite(found) or abs(found) > LATEST:
        raise DamageError(where, f"says “{text[:30]}” where a time has to be", AGAIN)
    return found


def lasting(starts: Iterable[tuple[str, float, str]], end: float) -> tuple[Phoneme, ...]:
    """Sounds that each last until the next begins, the last until an end; of no length, none.

    Parameters
    ----------
    starts : symbol, time and place in the file, in the order of the file
    end : of the last one, seconds

    Raises
    ------
    DamageError
        If one begins before the one before it.
    """
    cues = list(starts)
    found: list[Phoneme] = []
    for number, (symbol, start, where) in enumerate(cues):
        stop = cues[number + 1][1] if number + 1 < len(cues) else end
        if stop < start:
            raise DamageError(cues[number + 1][2] if number + 1 < len(cues) else where, "goes back in time", AGAIN)
        if stop > start:
            found.append(Phoneme(symbol, start, stop))
    return tuple(found)

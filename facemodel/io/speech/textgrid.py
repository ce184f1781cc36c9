"""Praat's TextGrid, long or short, as the Montreal Forced Aligner and others write it."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import dataclass

from facemodel.animation.speech import Phoneme, Word
from facemodel.io.damage import DamageError
from facemodel.io.speech.spoken import AGAIN, Spoken, seconds
from facemodel.io.weights.table import decoded

TOKEN = re.compile(r'"(?:[^"]|"")*"|<exists>|<absent>|[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?(?![\w.])')
"""What a TextGrid consists of: text in quotes (doubled inside), flags and free-standing numbers; all else is comment.
Long files write ``xmin = 0`` for the ``0`` of short ones, and ``intervals [3]:`` for nothing."""

COMMENT = re.compile(r"!.*|\[[^\]]*\]")

MOST_TIERS = 1000

PHONES = ("phones", "phonemes", "phoneme", "phone", "segments", "mau", "sounds")
WORDS = ("words", "word", "ort", "orthography")


@dataclass(frozen=True)
class Tier:
    """One tier of intervals: its name, and start, end and text of each."""

    name: str
    intervals: tuple[tuple[float, float, str], ...]


def is_textgrid(data: bytes) -> bool:
    """Whether the bytes are those of a TextGrid."""
    return "TextGrid" in data[:400].replace(b"\0", b"").decode("latin-1")


def read_textgrid(data: bytes) -> Spoken:
    """Sounds and words from a TextGrid: the tier of phones, or the only or last one, and the tier of words.

    Raises
    ------
    DamageError
        If it is no TextGrid, is cut short, has no tier of intervals, or an interval ends before it begins.
    """
    tiers = read_tiers(data)
    if not tiers:
        raise DamageError("the file", "has no tier of intervals", "align it again with a tier of phones")
    words = _named(tiers, WORDS)
    phones = _named(tiers, PHONES) or (tiers[-1] if tiers[-1] is not words or len(tiers) == 1 else None)
    if phones is None:
        raise DamageError("the file", "has no tier of phones", "align it again with a tier of phones")
    sounds = tuple(Phoneme(text or "sil", start, end) for start, end, text in phones.intervals if end > start)
    spoken = tuple(Word(text, start, end) for start, end, text in (words.intervals if words else ()) if text)
    notes = (f"It has {len(tiers)} tiers; the sounds are those of “{phones.name}”.",) if len(tiers) > 2 else ()
    return Spoken(sounds, spoken, notes)


def _named(tiers: Sequence[Tier], names: Sequence[str]) -> Tier | None:
    """The first tier of a name; aligners write the speaker before it: ``Ann - phones``."""
    for name in names:
        for tier in tiers:
            if re.split(r"[-/:]", tier.name.casefold())[-1].strip() == name:
                return tier
    return None


def read_tiers(data: bytes) -> tuple[Tier, ...]:
    """All tiers of intervals; tiers of points are passed over.

    Raises
    ------
    DamageError
        If it is no TextGrid or is cut short.
    """
    if not is_textgrid(data):
        raise DamageError("the file", "is no TextGrid", "choose another file")
    text = "\n".join(_without_comments(line) for line in decoded(data).splitlines())
    reader = _Reader(TOKEN.findall(text))
    while reader.next() != '"TextGrid"':
        pass
    reader.number("its start")
    reader.number("its end")
    if reader.next() != "<exists>":
        return ()
    count = int(reader.number("its number of tiers"))
    if not 0 <= count <= MOST_TIERS:
        raise DamageError("the file", f"would have {count} tiers", AGAIN)
    tiers = [_tier(reader, number) for number in range(1, count + 1)]
    return tuple(tier for tier in tiers if tier is not None)


def _without_comments(line: str) -> str:
    """A line without what stands in brackets or behind an exclamation mark, outside of quotes."""
    parts = re.split(r'("(?:[^"]|"")*"?)', line)
    return "".join(part if part.startswith('"') else COMMENT.sub(" ", part) for part in parts)


def _tier(reader: _Reader, number: int) -> Tier | None:
    kind, name = reader.text(f"tier {number}"), reader.text(f"tier {number}")
    reader.number(f"tier {number}")
    reader.number(f"tier {number}")
    count = int(reader.number(f"tier {number}"))
    if count < 0:
        raise DamageError(f"tier {number}", f"would have {count} intervals", AGAIN)
    found: list[tuple[float, float, str]] = []
    for k in range(1, count + 1):
        where = f"tier {number}, interval {k}"
        start = reader.number(where)
        if kind == "TextTier":
            reader.text(where)
            continue
        end, text = reader.number(where), reader.text(where)
        if end < start or (found and start < found[-1][0]):
            raise DamageError(where, "goes back in time", AGAIN)
        found.append((start, end, text.strip()))
    return None if kind == "TextTier" else Tier(name, tuple(found))


class _Reader:
    """Hands out the tokens of a file one by one."""

    def __init__(self, tokens: Sequence[str]) -> None:
        self._tokens = tokens
        self._at = 0

    def next(self, where: str = "the file") -> str:
        if self._at >= len(self._tokens):
            raise DamageError(where, "is cut short", "read a whole copy of it")
        self._at += 1
        return self._tokens[self._at - 1]

    def number(self, where: str) -> float:
        return seconds(self.next(where), where)

    def text(self, where: str) -> str:
        token = self.next(where)
        if not token.startswith('"'):
            raise DamageError(where, f"has “{token[:30]}” where text in quotes has to be", AGAIN)
        return token[1:-1].replace('""', '"')

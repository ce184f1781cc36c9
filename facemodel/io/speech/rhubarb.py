"""Mouth shapes of Rhubarb Lip Sync: TSV, XML or JSON.  Its shapes A to H and X become visemes."""

from __future__ import annotations

import json
from itertools import pairwise
from xml.etree import ElementTree

from facemodel.animation.speech import Phoneme
from facemodel.io.damage import DamageError
from facemodel.io.speech.spoken import AGAIN, Spoken, lasting, seconds
from facemodel.io.weights.table import decoded

VISEMES = {
    "A": "PP",
    "B": "SS",
    "C": "E",
    "D": "aa",
    "E": "oh",
    "F": "ou",
    "G": "FF",
    "H": "nn",
    "X": "sil",
}
"""Closed for p, b, m; teeth together; open; wide open; a little rounded; puckered; f and v; tongue up; rest."""

TAIL = 0.1
"""Seconds of the last shape of a TSV, which does not say when it ends."""


def read_rhubarb_tsv(data: bytes) -> Spoken:
    """Shapes from lines of a time and a letter.

    Raises
    ------
    DamageError
        If a line is something else, or goes back in time.
    """
    cues: list[tuple[str, float, str]] = []
    for number, line in enumerate(decoded(data).splitlines(), start=1):
        parts = line.split()
        if parts:
            where = f"line {number}"
            if len(parts) != 2:
                raise DamageError(where, "is not a time and a mouth shape", AGAIN)
            cues.append((_viseme(parts[1], where), seconds(parts[0], where), where))
    return _spoken(lasting(cues, cues[-1][1] + TAIL if cues else 0.0))


def read_rhubarb_json(data: bytes) -> Spoken:
    """Shapes from an object with ``mouthCues``.

    Raises
    ------
    DamageError
        If it is something else.
    """
    try:
        raw = json.loads(decoded(data))
    except (ValueError, RecursionError) as error:
        raise DamageError("the file", "is no JSON", AGAIN) from error
    cues = raw.get("mouthCues") if isinstance(raw, dict) else None
    if not isinstance(cues, list):
        raise DamageError("the file", "has no list “mouthCues”", AGAIN)
    found: list[Phoneme] = []
    for number, cue in enumerate(cues):
        where = f"mouthCues[{number}]"
        if not isinstance(cue, dict) or not {"start", "end", "value"} <= cue.keys():
            raise DamageError(where, "has no start, end and value", AGAIN)
        found.append(_cue(str(cue["start"]), str(cue["end"]), str(cue["value"]), where))
    return _spoken(tuple(found))


def read_rhubarb_xml(data: bytes) -> Spoken:
    """Shapes from elements ``mouthCue``.

    Raises
    ------
    DamageError
        If it is something else.
    """
    text = decoded(data)
    if "<!DOCTYPE" in text or "<!ENTITY" in text:
        raise DamageError("the file", "declares entities, which Rhubarb never does", AGAIN)
    try:
        root = ElementTree.fromstring(text)
    except ElementTree.ParseError as error:
        raise DamageError("the file", f"is no XML ({error})", AGAIN) from error
    found: list[Phoneme] = []
    for number, cue in enumerate(root.iter("mouthCue")):
        start, end = cue.get("start", ""), cue.get("end", "")
        found.append(_cue(start, end, cue.text or "", f"mouthCue {number + 1}"))
    return _spoken(tuple(found))


def _cue(start: str, end: str, shape: str, where: str) -> Phoneme:
    begin, stop = seconds(start, where), seconds(end, where)
    if stop < begin:
        raise DamageError(where, "ends before it begins", AGAIN)
    return Phoneme(_viseme(shape, where), begin, stop)


def _viseme(shape: str, where: str) -> str:
    found = VISEMES.get(shape.strip().upper())
    if found is None:
        raise DamageError(where, f"has the mouth shape “{shape.strip()[:20]}”, and Rhubarb has A to H and X", AGAIN)
    return found


def _spoken(phonemes: tuple[Phoneme, ...]) -> Spoken:
    kept = tuple(sound for sound in phonemes if sound.end > sound.start)
    if not kept:
        raise DamageError("the file", "has no mouth shape", AGAIN)
    for before, after in pairwise(kept):
        if after.start < before.start:
            raise DamageError(f"the shape at {after.start:g} s", "goes back in time", AGAIN)
    return Spoken(kept)

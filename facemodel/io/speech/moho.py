"""Papagayo's and Moho's switch data (``.dat``): a frame and a mouth shape of Preston Blair on every line."""

from __future__ import annotations

from facemodel.io.damage import DamageError
from facemodel.io.speech.spoken import AGAIN, Spoken, lasting
from facemodel.io.weights.table import decoded

HEAD = "MohoSwitch1"

USUAL_RATE = 24.0
"""Frames per second; the file does not say them, and Papagayo begins with 24."""

VISEMES = {
    "ai": "aa",
    "e": "E",
    "o": "oh",
    "u": "ou",
    "wq": "ou",
    "etc": "DD",
    "cdgknrsthyz": "DD",
    "l": "nn",
    "mbp": "PP",
    "fv": "FF",
    "rest": "sil",
}
"""Preston Blair's shapes, by their names in small letters."""

TAIL = 3
"""Frames of the last shape, which has no end."""


def is_moho(data: bytes) -> bool:
    """Whether the bytes are those of switch data."""
    return data.lstrip(b"\xef\xbb\xbf").startswith(HEAD.encode())


def read_moho(data: bytes, rate: float | None = None) -> Spoken:
    """Shapes from switch data; its first frame is 1.

    Parameters
    ----------
    rate : frames per second; `USUAL_RATE` if not given, with a note

    Raises
    ------
    DamageError
        If it is no switch data, a line is something else, or it goes back in time.
    """
    lines = decoded(data).splitlines()
    if not lines or lines[0].strip() != HEAD:
        raise DamageError("line 1", f"is not “{HEAD}”", AGAIN)
    own = USUAL_RATE if rate is None else rate
    cues: list[tuple[str, float, str]] = []
    last = 0
    for number, line in enumerate(lines[1:], start=2):
        parts = line.split()
        if not parts:
            continue
        where = f"line {number}"
        if len(parts) != 2 or not parts[0].isdigit() or len(parts[0]) > 9:
            raise DamageError(where, "is not a frame and a mouth shape", AGAIN)
        shape = VISEMES.get(parts[1].casefold())
        if shape is None:
            raise DamageError(where, f"has the mouth shape “{parts[1][:20]}”, which Preston Blair has not", AGAIN)
        last = int(parts[0])
        cues.append((shape, (last - 1) / own, where))
    if not cues:
        raise DamageError("the file", "has no mouth shape", AGAIN)
    notes = () if rate else (f"It does not say how many frames a second it has; they are counted as {own:g}.",)
    return Spoken(lasting(cues, (last - 1 + TAIL) / own), (), notes)

"""Landmarks in the words of people."""

from __future__ import annotations

SIDES = {"_L": "left", "_R": "right"}


def spoken(name: str) -> str:
    """The name of a landmark as it is read: ``chin_lip_fold`` is “chin lip fold”, ``zygion_L`` “zygion, left”."""
    side = SIDES.get(name[-2:])
    words = (name[:-2] if side else name).replace("_", " ")
    return f"{words}, {side}" if side else words

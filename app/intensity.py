"""Intensities of action units as FACS writes them: A for a trace, E for the most there is."""

from __future__ import annotations

import re
from collections.abc import Sequence
from itertools import pairwise

from app.arithmetic import evaluate
from app.errors import NumberError
from facemodel.actions import ActionUnit, resolve

NAMES = "ABCDE"

FULL = 1.0

CODE = re.compile(r"\s*([LR])?\s*(\d{1,3})\s*([LR])?\s*([A-E])?\s*", re.IGNORECASE)
"""One scored unit: ``12C``, ``L12C`` or ``12LC``; without a letter at its maximum."""

OWN = re.compile(r"\s*(\d{1,3})?\s*([A-E])\s*", re.IGNORECASE)
"""A letter typed into the field of one unit, with its number or without."""


def letter_of(weight: float, unit: ActionUnit) -> str:
    """The letter of a weight; empty below where A begins."""
    return NAMES[: sum(weight >= begin for begin in unit.letters)][-1:]


def weight_of(letter: str, unit: ActionUnit) -> float:
    """The weight that a letter stands for: the middle of what is scored so, and for E full contraction.

    Raises
    ------
    NumberError
        If there is no such letter.
    """
    if len(letter) != 1 or letter.upper() not in NAMES:
        raise NumberError(f"“{letter[:10]}” is no intensity; choose one of A, B, C, D and E.")
    middles = [(begin + end) / 2 for begin, end in pairwise(unit.letters)]
    most = max(FULL, unit.letters[-1])
    return round(min((*middles, most)[NAMES.index(letter.upper())], unit.limit), 6)


def typed_weight(text: str, unit: ActionUnit) -> float:
    """The weight that is meant by what was typed into a field of a unit: a letter, a score such as ``12C``, or a sum.

    Raises
    ------
    NumberError
        If it is none of these, or the score of another unit.
    """
    found = OWN.fullmatch(text)
    if found is None:
        return evaluate(text)
    if found[1] and int(found[1]) != unit.number:
        raise NumberError(f"This is action unit {unit.number}, not {found[1]}; type {found[2].upper()} alone.")
    return weight_of(found[2], unit)


def parse_code(text: str, units: Sequence[ActionUnit]) -> dict[str, float]:
    """Weights by field of a score such as ``1B+2C+L12D``.

    Raises
    ------
    UnknownNameError
        If a number is no action unit, or a side is named that it does not have.
    NumberError
        If the text is no score.
    """
    owners = {field: unit for unit in units for field in unit.fields}
    weights: dict[str, float] = {}
    for part in text.split("+"):
        found = CODE.fullmatch(part)
        if found is None or (found[1] and found[3]):
            raise NumberError(f"“{part.strip()[:30]}” is no scored action unit; write them as 1B+2C+L12D.")
        side = (found[1] or found[3] or "").upper()
        for field in resolve(f"{found[2]}{side}", units):
            weights[field] = weight_of(found[4] or "E", owners[field])
    return weights

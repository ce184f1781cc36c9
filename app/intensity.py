"""Intensities of action units as FACS writes them: A for a trace, E for the most there is."""

from __future__ import annotations

import re
from collections.abc import Mapping, Sequence

from app.errors import NumberError
from facemodel.actions import ActionUnit, resolve

INTENSITIES: Mapping[str, float] = {"A": 0.2, "B": 0.4, "C": 0.6, "D": 0.8, "E": 1.0}
"""Weight of each letter, in even steps."""

CODE = re.compile(r"\s*([LR])?\s*(\d{1,3})\s*([LR])?\s*([A-E])?\s*", re.IGNORECASE)
"""One scored unit: ``12C``, ``L12C`` or ``12LC``; without a letter at its maximum."""


def letter_of(weight: float) -> str:
    """The nearest letter of a weight; empty for a weight nearer to nothing than to a trace."""
    if weight < INTENSITIES["A"] / 2:
        return ""
    return min(INTENSITIES, key=lambda letter: abs(INTENSITIES[letter] - weight))


def parse_code(text: str, units: Sequence[ActionUnit]) -> dict[str, float]:
    """Weights by field of a score such as ``1B+2C+L12D``.

    Raises
    ------
    UnknownNameError
        If a number is no action unit, or a side is named that it does not have.
    NumberError
        If the text is no score.
    """
    weights: dict[str, float] = {}
    for part in text.split("+"):
        found = CODE.fullmatch(part)
        if found is None or (found[1] and found[3]):
            raise NumberError(f"“{part.strip()[:30]}” is no scored action unit; write them as 1B+2C+L12D.")
        side = (found[1] or found[3] or "").upper()
        for field in resolve(f"{found[2]}{side}", units):
            weights[field] = INTENSITIES[(found[4] or "E").upper()]
    return weights

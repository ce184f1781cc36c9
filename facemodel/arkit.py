"""The names of ARKit's face units, and the action units that answer them."""

from __future__ import annotations

import json
import re
from collections.abc import Collection, Mapping
from dataclasses import dataclass, field
from functools import lru_cache
from typing import Literal

from resources import resource

Sided = Literal["L", "R", ""]

SIDES: Mapping[str, Sided] = {"left": "L", "_left": "L", "_l": "L", "right": "R", "_right": "R", "_r": "R"}
"""What a name may end with, in lower case."""


@dataclass(frozen=True)
class ArkitUnit:
    """One of ARKit's face units, without its side.

    Attributes
    ----------
    name : as ARKit writes it, for example ``mouthSmile``
    units : weight of each action unit by number; with a side where it has one of its own, as ``30L``
    note : what it is instead, if no action unit moves the skin that way
    """

    name: str
    units: Mapping[str, float] = field(default_factory=dict)
    note: str = ""


@lru_cache(maxsize=1)
def arkit_units() -> Mapping[str, ArkitUnit]:
    """All of them by name in lower case."""
    table = json.loads(resource("facs", "arkit.json").read_text(encoding="utf-8"))["names"]
    return {name.lower(): ArkitUnit(name, row["units"], row.get("note", "")) for name, row in table.items()}


def find_arkit(name: str) -> tuple[ArkitUnit, Sided] | None:
    """The face unit that a name means, and the side it names; none if ARKit knows no such name.

    Case does not matter, nor whether sides are written ``_L`` or ``Left``.  A side may also be named where ARKit has
    none, as in ``browInnerUp_L``.
    """
    asked = re.sub(r"[\s.-]+", "_", name.strip()).lower()
    known = arkit_units()
    if asked in known:
        return known[asked], ""
    for ending, side in SIDES.items():
        if asked.endswith(ending) and asked.removesuffix(ending) in known:
            return known[asked.removesuffix(ending)], side
    return None


def answering_fields(unit: ArkitUnit, side: Sided, fields: Collection[str]) -> dict[str, float]:
    """Weights of the displacement fields that answer a face unit, among those that there are.

    Without a side both sides of a paired action unit answer, with one that side alone, or the whole of a unit that
    has no sides.
    """
    weights: dict[str, float] = {}
    for number, weight in unit.units.items():
        own = [number] if number in fields else [f"{number}{each}" for each in ((side,) if side else ("L", "R"))]
        for name in own:
            if name in fields:
                weights[name] = weights.get(name, 0.0) + weight
    return weights

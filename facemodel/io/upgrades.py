"""How documents of older versions become those of the next one.  What an upgrade does never changes again."""

from __future__ import annotations

from typing import Any

EYES_AND_HEAD: tuple[tuple[int, str, str, dict[str, float]], ...] = (
    (61, "eyes turn left", "eyes", {"turn": 35.0}),
    (62, "eyes turn right", "eyes", {"turn": -35.0}),
    (63, "eyes up", "eyes", {"lift": 25.0}),
    (64, "eyes down", "eyes", {"lift": -35.0}),
    (65, "walleye", "eyes", {"spread": 15.0}),
    (66, "cross-eye", "eyes", {"spread": -25.0}),
    (51, "head turn left", "head", {"turn": 45.0}),
    (52, "head turn right", "head", {"turn": -45.0}),
    (53, "head up", "head", {"lift": 30.0}),
    (54, "head down", "head", {"lift": -30.0}),
    (55, "head tilt left", "head", {"tilt": 25.0}),
    (56, "head tilt right", "head", {"tilt": -25.0}),
    (57, "head forward", "head", {"forward": 35.0}),
    (58, "head back", "head", {"forward": -30.0}),
)
"""The units that version 2 knew first: number, name, group and motion."""


def with_eyes_and_head(document: dict[str, Any]) -> dict[str, Any]:
    """From version 1 to 2: a project gets the units that turn eyes and head, as far as their numbers are free."""
    upgraded = {**document, "schema": 2}
    units = document.get("units")
    if not isinstance(units, list):
        return upgraded
    taken = {unit.get("number") for unit in units if isinstance(unit, dict)}
    added = [_unit(*row) for row in EYES_AND_HEAD if row[0] not in taken]
    return {**upgraded, "units": [*units, *added]}


def _unit(number: int, name: str, group: str, motion: dict[str, float]) -> dict[str, Any]:
    return {
        "number": number,
        "name": name,
        "group": group,
        "paired": False,
        "muscles": {},
        "amplitude": 0.0,
        "jaw": None,
        "note": "",
        "limit": 1.0,
        group: motion,
    }

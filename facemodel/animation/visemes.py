"""The visemes that ship, and what else is known of English mouths."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache

from facemodel.animation.speech import Viseme
from resources import resource


@dataclass(frozen=True)
class MouthTable:
    """Data about speech that belongs to no project.

    Attributes
    ----------
    visemes : the English set
    glides : sounds that move from one viseme to another, by symbol
    opens : action units that part the lips, held back while lips have to meet
    """

    visemes: tuple[Viseme, ...]
    glides: Mapping[str, tuple[str, ...]]
    opens: tuple[str, ...]


@cache
def mouth_table() -> MouthTable:
    """What `resources/animation/visemes.json` holds."""
    raw = json.loads(resource("animation", "visemes.json").read_text("utf-8"))
    visemes = tuple(
        Viseme(each["name"], tuple(each["symbols"]), each["weights"], each["dominance"], each.get("closes", False))
        for each in raw["visemes"]
    )
    return MouthTable(visemes, {name: tuple(parts) for name, parts in raw["glides"].items()}, tuple(raw["opens"]))

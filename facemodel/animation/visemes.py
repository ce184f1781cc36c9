"""The visemes that ship, and what else is known of English mouths."""

from __future__ import annotations

import json
from collections.abc import Mapping
from dataclasses import dataclass
from functools import cache

from facemodel.animation.speech import Viseme, plain
from resources import resource


@dataclass(frozen=True)
class MouthTable:
    """Data about speech that belongs to no project.

    Attributes
    ----------
    visemes : the English set
    glides : sounds that move from one viseme to another, by symbol
    opens : action units that part the lips, held back while lips have to meet
    lengths : seconds that sounds of a viseme usually take, by its name; of any other under the empty name
    """

    visemes: tuple[Viseme, ...]
    glides: Mapping[str, tuple[str, ...]]
    opens: tuple[str, ...]
    lengths: Mapping[str, float]


def parts_of(symbol: str) -> tuple[str, ...]:
    """The symbols that a sound is seen as: of a glide the two it moves between, else its own."""
    glides = mouth_table().glides
    bare = plain(symbol)
    return glides.get(bare) or glides.get(bare.upper()) or (symbol,)


@cache
def mouth_table() -> MouthTable:
    """What `resources/animation/visemes.json` holds."""
    raw = json.loads(resource("animation", "visemes.json").read_text("utf-8"))
    visemes = tuple(
        Viseme(each["name"], tuple(each["symbols"]), each["weights"], each["dominance"], each.get("closes", False))
        for each in raw["visemes"]
    )
    glides = {name: tuple(parts) for name, parts in raw["glides"].items()}
    return MouthTable(visemes, glides, tuple(raw["opens"]), raw["lengths"])

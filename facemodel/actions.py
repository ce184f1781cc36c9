"""Action units, emotions and expressions: names, weights and nothing else."""

from __future__ import annotations

import re
from collections.abc import Iterable, Mapping, Sequence
from dataclasses import dataclass, field, replace
from typing import Literal

from facemodel.errors import UnknownNameError
from facemodel.motions import EyeMotion, HeadMotion, TongueMotion

Side = Literal["L", "R"]
Group = Literal["upper", "horizontal", "vertical", "diagonal", "orbital", "jaw", "eyes", "head"]

GROUP_TITLES: Mapping[Group, str] = {
    "upper": "Upper face",
    "vertical": "Lower face · vertical",
    "horizontal": "Lower face · horizontal",
    "diagonal": "Lower face · diagonal",
    "orbital": "Lower face · orbital",
    "jaw": "Jaw",
    "eyes": "Eyes and lids",
    "head": "Head",
}
"""The groups of FACS in the order in which they are shown."""

Expression = Mapping[str, float]
"""Weights of field names (``12L``, ``12R``, ``17``); a name that is absent weighs zero."""


EXAGGERATED = 2.0
"""How far a slider goes past 1; beyond twice its contraction skin folds and nothing is to be seen."""


LETTERS = (0.1, 0.3, 0.5, 0.7, 0.9)
"""Weights at which the intensities A, B, C, D and E of FACS begin, where a unit has none of its own: even steps."""

WINK = 46
"""The FACS number of what is done with one eye."""

Place = tuple[float, float]
"""Where on the pad, from 0 to 1 to the right and up."""


@dataclass(frozen=True)
class JawMotion:
    """What an action unit does to the mandible at activation 1.

    Attributes
    ----------
    degrees : opening
    slide : of the condyles forward along the articular eminence, millimetres
    side : of the lower incisors to the subject's left, millimetres; below zero to the right
    """

    degrees: float
    slide: float = 0.0
    side: float = 0.0

    def __bool__(self) -> bool:
        return bool(self.degrees or self.slide or self.side)

    @property
    def mirrored(self) -> JawMotion:
        """Its mirror image: the jaw goes to the other side, and opens and slides as before."""
        return replace(self, side=-self.side) if self.side else self


@dataclass(frozen=True)
class ActionUnit:
    """A weighted sum of muscle activations, and what it does to jaw, eyes, head and tongue.

    Attributes
    ----------
    number : FACS number
    name : FACS name, for example ``lip corner puller``
    group : where it is listed
    paired : whether it exists as left and right alone
    muscles : activation of each muscle by its name without side
    jaw : motion of the mandible
    amplitude : largest displacement of the skin at activation 1, millimetres
    note : one line for people
    limit : the largest weight that its sliders take; 1 is full, `EXAGGERATED` as far as any goes
    letters : the weights at which the intensities A, B, C, D and E of FACS begin, in increasing order
    eyes : how the eyes turn
    head : how the head moves
    tongue : how the tongue moves
    """

    number: int
    name: str
    group: Group
    paired: bool
    muscles: Mapping[str, float]
    amplitude: float
    jaw: JawMotion | None = None
    note: str = ""
    limit: float = EXAGGERATED
    letters: tuple[float, ...] = LETTERS
    eyes: EyeMotion | None = None
    head: HeadMotion | None = None
    tongue: TongueMotion | None = None

    @property
    def fields(self) -> tuple[str, ...]:
        """Names of its sliders, and of its displacement fields if it has any: ``("12L", "12R")`` or ``("17",)``."""
        return (f"{self.number}L", f"{self.number}R") if self.paired else (str(self.number),)

    @property
    def opposed(self) -> bool:
        """Whether left and right undo each other, as a jaw cannot go both ways at once."""
        return self.paired and self.jaw is not None and self.jaw.side != 0

    @property
    def full(self) -> dict[str, float]:
        """Weights that show all of it: both sides at 1, or the left one where they undo each other."""
        return dict.fromkeys(self.fields[:1] if self.opposed else self.fields, 1.0)

    @property
    def portrait(self) -> dict[str, float]:
        """Weights under which a picture shows it: all of it, but a wink with one eye, or it were a blink."""
        return dict.fromkeys(self.fields[:1], 1.0) if self.number == WINK else self.full

    @property
    def moves_skin(self) -> bool:
        """Whether it has displacement fields: one that only moves eyes, head or tongue has none to be solved."""
        return bool(self.muscles) or self.jaw is not None or not (self.eyes or self.head or self.tongue)

    def jaw_of(self, field_name: str) -> JawMotion | None:
        """What one of its fields does to the mandible: the right one of a pair is the mirror image of the left one."""
        if self.jaw is None or not self.paired or field_name == self.fields[0]:
            return self.jaw
        return self.jaw.mirrored


@dataclass(frozen=True)
class Emotion:
    """A named expression.

    Attributes
    ----------
    name : lower case, for example ``happiness``
    weights : weight of each action unit, by any name that `resolve` knows
    place : where it lies on the pad that blends expressions; none if it is not on it
    """

    name: str
    weights: Mapping[str, float] = field(default_factory=dict)
    place: Place | None = None

    @property
    def title(self) -> str:
        """The name as a person writes it."""
        return self.name.capitalize()

    @property
    def family(self) -> str:
        """The name of what it is a variant of, as ``anger`` for ``anger, lips pressed``; empty if of nothing."""
        return self.name.split(", ", 1)[0] if ", " in self.name else ""


def field_names(units: Iterable[ActionUnit]) -> tuple[str, ...]:
    """Names of all sliders, in the order of the units, left before right."""
    return tuple(name for unit in units for name in unit.fields)


def skin_units(units: Iterable[ActionUnit]) -> tuple[ActionUnit, ...]:
    """The units that have displacement fields."""
    return tuple(unit for unit in units if unit.moves_skin)


def skin_fields(units: Iterable[ActionUnit]) -> tuple[str, ...]:
    """Names of all displacement fields, in the order of the units, left before right."""
    return field_names(skin_units(units))


def resolve(name: str, units: Sequence[ActionUnit]) -> tuple[str, ...]:
    """Fields meant by a name such as ``12``, ``AU12``, ``12L`` or ``lip corner puller R``.

    Raises
    ------
    UnknownNameError
        If there is no such action unit, or it has no sides and one was named.
    """
    asked = _spoken(name)
    bare, side = re.fullmatch(r"(.*?)(?:(?<=\d)|\s+)?([lr])?", asked).groups()  # type: ignore[union-attr]
    for unit in units:
        spoken = {str(unit.number), f"au{unit.number}", f"au {unit.number}", _spoken(unit.name)}
        if asked in spoken:
            return unit.fields
        if side and bare.strip() in spoken and unit.paired:
            return (f"{unit.number}{side.upper()}",)
        if side and bare.strip() in spoken:
            raise UnknownNameError(
                f"Action unit {unit.number} ({unit.name}) has no left and right; name it {unit.number}."
            )
    known = ", ".join(str(u.number) for u in units)
    raise UnknownNameError(f"There is no action unit “{name}”; this face has {known} (paired ones also as 12L, 12R).")


def _spoken(name: str) -> str:
    """A name without what people write in one way or another."""
    return re.sub(r"[\s_-]+", " ", name.strip()).lower()


def find_emotion(name: str, emotions: Sequence[Emotion]) -> Emotion:
    """The emotion of that name, whatever its case.

    Raises
    ------
    UnknownNameError
        If there is none.
    """
    for emotion in emotions:
        if emotion.name.strip().lower() == name.strip().lower():
            return emotion
    known = ", ".join(e.name for e in emotions)
    raise UnknownNameError(f"There is no emotion “{name}”; choose one of {known}.")


def expand(weights: Mapping[str, float], units: Sequence[ActionUnit]) -> dict[str, float]:
    """Weights by field from weights by any name; a later name overrides an earlier one."""
    return {fld: float(weight) for name, weight in weights.items() for fld in resolve(name, units)}


def mixed(parts: Iterable[Expression]) -> dict[str, float]:
    """Several expressions at once: per field the largest weight, so that a shared unit is not doubled."""
    total: dict[str, float] = {}
    for part in parts:
        for name, weight in part.items():
            total[name] = max(total.get(name, 0.0), weight)
    return total

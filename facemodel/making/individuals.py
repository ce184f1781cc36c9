"""The people we ship: which macro targets and details each one is blended from."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

from facemodel.making.wheel import TARGETS, Wheel
from fem.types import FloatArray


@dataclass(frozen=True)
class Individual:
    """One shipped person.

    Attributes
    ----------
    key : file name in ``resources/faces``
    title : name shown to the user
    age, sex, ancestry : parts of the macro target's name
    details : further targets (path below the wheel's target folder) with their weights
    """

    key: str
    title: str
    age: str
    sex: str
    ancestry: str
    details: Mapping[str, float] = field(default_factory=dict)


INDIVIDUALS: tuple[Individual, ...] = (
    Individual("ada", "Ada (young woman)", "young", "female", "caucasian"),
    Individual("ben", "Ben (young man)", "young", "male", "caucasian"),
    Individual("chen", "Chen (young woman)", "young", "female", "asian"),
    Individual("dayo", "Dayo (old man)", "old", "male", "african"),
)


def positions(wheel: Wheel, person: Individual) -> FloatArray:
    """The base mesh in the shape of one person, (V, 3) millimetres."""
    macro = f"{TARGETS}macrodetails/"
    shape = wheel.base.positions.copy()
    shape += wheel.target(f"{macro}{person.ancestry}-{person.sex}-{person.age}.target.gz")
    shape += wheel.target(f"{macro}universal-{person.sex}-{person.age}-averagemuscle-averageweight.target.gz")
    for name, weight in person.details.items():
        shape += weight * wheel.target(f"{TARGETS}{name}.target.gz")
    return shape

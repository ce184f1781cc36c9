"""What a brush does to the field of an action unit."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal, get_args

from facemodel.errors import PaintError
from facemodel.painting.brush import LARGEST_RADIUS

SculptMode = Literal["pull", "raise", "smooth", "pinch", "erase"]

SCULPT_MODES: tuple[SculptMode, ...] = get_args(SculptMode)

SCULPT_TITLES: Mapping[SculptMode, str] = {
    "pull": "Pull",
    "raise": "Raise",
    "smooth": "Smooth",
    "pinch": "Pinch",
    "erase": "Erase",
}

RAISED = 1.0
"""Millimetres that one stroke of full strength raises the skin by."""

PINCHED = 0.5
"""Share of its way to the middle of the brush that one stroke of full strength takes the skin: more would fold it."""


@dataclass(frozen=True)
class SculptBrush:
    """A round brush that moves skin.

    Attributes
    ----------
    mode : ``pull`` after the hand, ``raise`` along the normal, ``smooth`` the field, ``pinch`` towards the middle of
        the brush, ``erase`` what was sculpted
    radius : geodesic, millimetres
    strength : 0 to 1, the share of the effect in the middle
    hardness : 0 to 1, the part of the radius over which the effect is the same before it fades
    reverse : raise downwards, pinch outwards; means nothing to the others

    Raises
    ------
    PaintError
        If there is no such mode, or a number is outside its range.
    """

    mode: SculptMode
    radius: float
    strength: float = 1.0
    hardness: float = 0.0
    reverse: bool = False

    def __post_init__(self) -> None:
        if self.mode not in SCULPT_MODES:
            raise PaintError(f"A field cannot be sculpted by “{self.mode}”; choose one of {', '.join(SCULPT_MODES)}.")
        if not 0 < self.radius <= LARGEST_RADIUS:
            raise PaintError(
                f"A brush of {self.radius:g} mm is not possible; choose a radius above 0 and up to "
                f"{LARGEST_RADIUS:g} mm."
            )
        for name in ("strength", "hardness"):
            if not 0 <= getattr(self, name) <= 1:
                raise PaintError(f"A {name} of {getattr(self, name):g} is not possible; choose one from 0 to 1.")

    @property
    def sign(self) -> float:
        """1, or -1 in reverse."""
        return -1.0 if self.reverse else 1.0

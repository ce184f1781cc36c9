"""What files hold of action units."""

from __future__ import annotations

from itertools import pairwise
from typing import Annotated, Literal

from pydantic import Field, model_validator

from facemodel.actions import EXAGGERATED, LETTERS
from facemodel.io.record_types import Degrees, Key, Length, Limit, Name, Record, Text, Weight


class JawMotionRecord(Record):
    """See `facemodel.actions.JawMotion`."""

    degrees: Degrees
    slide: Length
    side: Length = 0.0


class EyeMotionRecord(Record):
    """See `facemodel.motions.EyeMotion`."""

    turn: Degrees = 0.0
    lift: Degrees = 0.0
    spread: Degrees = 0.0


class HeadMotionRecord(Record):
    """See `facemodel.motions.HeadMotion`."""

    turn: Degrees = 0.0
    lift: Degrees = 0.0
    tilt: Degrees = 0.0
    forward: Length = 0.0


class TongueMotionRecord(Record):
    """See `facemodel.motions.TongueMotion`."""

    out: Length = 0.0
    lift: Degrees = 0.0


class UnitRecord(Record):
    """See `facemodel.actions.ActionUnit`."""

    number: Annotated[int, Field(ge=1, le=999)]
    name: Name
    group: Literal["upper", "horizontal", "vertical", "diagonal", "orbital", "jaw", "eyes", "head"]
    paired: bool
    muscles: dict[Key, Weight]
    amplitude: Annotated[float, Field(ge=0, le=1e5)]
    jaw: JawMotionRecord | None
    note: Text
    limit: Limit = EXAGGERATED
    letters: tuple[Limit, Limit, Limit, Limit, Limit] = LETTERS
    eyes: EyeMotionRecord | None = None
    head: HeadMotionRecord | None = None
    tongue: TongueMotionRecord | None = None

    @model_validator(mode="after")
    def _ordered(self) -> UnitRecord:
        if any(after <= before for before, after in pairwise(self.letters)):
            raise ValueError("the intensities A to E have to begin one after the other")
        return self

"""What the records of all documents are made of: their base, and numbers and names with their limits."""

from __future__ import annotations

from typing import Annotated

from pydantic import BaseModel, ConfigDict, Field

from facemodel.actions import EXAGGERATED

LARGEST_WEIGHT = 100.0
"""Weights beyond this leave the range in which a face of float32 millimetres means anything."""

Name = Annotated[str, Field(min_length=1, max_length=100)]
Key = Annotated[str, Field(pattern=r"^[\w-]{1,100}$")]
Colour = Annotated[str, Field(pattern=r"^(#[0-9a-f]{6})?$")]
Text = Annotated[str, Field(max_length=20_000)]
Length = Annotated[float, Field(ge=-1e5, le=1e5)]
Degrees = Annotated[float, Field(ge=-90, le=90)]
Positive = Annotated[float, Field(gt=0, le=1e5)]
Share = Annotated[float, Field(ge=-1, le=1)]
Weight = Annotated[float, Field(ge=-LARGEST_WEIGHT, le=LARGEST_WEIGHT)]
Limit = Annotated[float, Field(gt=0, le=EXAGGERATED)]
Inside = Annotated[float, Field(ge=0, le=1)]
Index = Annotated[int, Field(ge=0, lt=1 << 31)]
Point = tuple[Length, Length, Length]


class Record(BaseModel):
    """A part of a document."""

    model_config = ConfigDict(extra="forbid", strict=True, frozen=True, allow_inf_nan=False)

"""The JSON documents of face and project files: what each may hold, and its upgrades from older versions.

The models are strict: a field that is missing, unknown, of another type or not a finite number is refused
with its place.  Arrays are not part of them; they are members of their own beside the document.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Mapping
from itertools import pairwise
from typing import Annotated, Any, Final, Literal, TypeVar

from pydantic import Field, ValidationError, model_validator

from facemodel.io.animation_schema import AnimationRecord
from facemodel.io.damage import DamageError
from facemodel.io.record_types import (
    Colour,
    Index,
    Inside,
    Key,
    Length,
    Name,
    Point,
    Positive,
    Record,
    Share,
    Text,
    Weight,
)
from facemodel.io.unit_schema import UnitRecord
from facemodel.io.upgrades import with_eyes_and_head
from facemodel.muscles.muscle import Model

PROJECT_FORMAT: Final = "risorius"
FACE_FORMAT: Final = "risorius-face"
SCHEMA: Final = 2
"""The version that is written.  Whoever changes the meaning of a file raises it and adds an upgrade."""

Upgrade = Callable[[dict[str, Any]], dict[str, Any]]
UPGRADES: Mapping[int, Upgrade] = {1: with_eyes_and_head}
"""For each older version the function that turns its document into the next one's; version 1 is the first."""

SMALLEST_EYE, LARGEST_EYE = 8.0, 50.0
"""Millimetres; a newborn's eyeball has a radius of 8, and a smaller one could not carry its cornea."""

MOST_VIA, MOST_KNOTS = 100, 100
"""More points than this on one fibre or profile are no work of a hand."""


class EyeRecord(Record):
    """See `facemodel.face.Eye`."""

    side: Literal["L", "R"]
    centre: Point
    radius: Annotated[float, Field(ge=SMALLEST_EYE, le=LARGEST_EYE)]


class PartRecord(Record):
    """See `facemodel.face.Part`; its arrays are the members ``face/parts/<its number in the list>``."""

    name: Name
    kind: Literal["lining", "socket", "lashes", "teeth", "tongue"]
    carrier: Literal["skull", "jaw", "skin"]


class JawRecord(Record):
    """See `facemodel.face.Jaw`."""

    axis: tuple[Point, Point]
    teeth: Point


class PlacementRecord(Record):
    """See `facemodel.face.Placement`; its feet are the member ``face/skull/feet``."""

    shift: Point
    turn: Point
    scale: tuple[Positive, Positive, Positive]
    centre: Point


class FaceRecord(Record):
    """See `facemodel.face.Face`; its arrays are the members under ``face``."""

    key: Key
    title: Name
    provenance: Text
    landmarks: dict[Name, Index]
    eyes: tuple[EyeRecord, EyeRecord]
    jaw: JawRecord
    parts: tuple[PartRecord, ...]
    placement: PlacementRecord | None = None


class FibreRecord(Record):
    """See `facemodel.muscles.Fibre`."""

    origin: Point
    attachment: Point
    via: Annotated[tuple[Point, ...], Field(max_length=MOST_VIA)] = ()


class SphincterRecord(Record):
    """See `facemodel.muscles.Sphincter`."""

    centre: Point
    long_axis: Point
    short_axis: Point
    sector: Point
    focus: Annotated[float, Field(ge=0, le=1)]
    inward: Share
    forward: Share


class ProfileRecord(Record):
    """See `facemodel.muscles.Profile`."""

    at: Annotated[tuple[Length, ...], Field(min_length=2, max_length=MOST_KNOTS)]
    values: Annotated[tuple[Length, ...], Field(min_length=2, max_length=MOST_KNOTS)]

    @model_validator(mode="after")
    def _ordered(self) -> ProfileRecord:
        if len(self.at) != len(self.values):
            raise ValueError("a profile needs one value for every knot")
        if self.at[0] != 0 or any(after <= before for before, after in pairwise(self.at)):
            raise ValueError("the knots of a profile have to start at 0 and increase")
        return self


class ProfilesRecord(Record):
    """See `facemodel.muscles.Profiles`."""

    sigma: ProfileRecord
    tau: ProfileRecord


class CosineRecord(Record):
    """See `facemodel.muscles.Cosine`."""

    box: tuple[Positive, Positive, Positive]
    share: Share
    factors: tuple[Share, Share, Share]


class MuscleRecord(Record):
    """See `facemodel.muscles.Muscle`; what has a default may be missing, and is in files that do not need it."""

    name: Key
    side: Literal["L", "R", "M"]
    title: Name
    group: Name
    model: Model
    fibres: tuple[FibreRecord, ...]
    ring: SphincterRecord | None
    width: Positive
    kappa: Positive
    strength: Annotated[float, Field(ge=0, le=1e5)]
    count: Annotated[int, Field(ge=0, le=10_000)]
    profiles: ProfilesRecord | None = None
    cosine: CosineRecord | None = None
    linked: bool = True
    colour: Colour = ""


class EmotionRecord(Record):
    """See `facemodel.actions.Emotion`."""

    name: Name
    weights: dict[Name, Weight]
    place: tuple[Inside, Inside] | None = None


class CorrectionRecord(Record):
    """See `facemodel.sculpting.correction`; its arrays are the members ``corrections/<its number in the list>``."""

    field: Name
    amount: Annotated[float, Field(ge=0, le=1)]
    on: bool


class SettingsRecord(Record):
    """See `facemodel.project.Settings`."""

    element: Literal["hct9", "hct12"]
    density: Annotated[int, Field(ge=1, le=16)]


class FaceDocument(Record):
    """The document of a ``.face`` file."""

    format: Literal["risorius-face"]
    version: Literal[2] = Field(alias="schema")
    face: FaceRecord


class ProjectDocument(Record):
    """The document of a ``.risorius`` file."""

    format: Literal["risorius"]
    version: Literal[2] = Field(alias="schema")
    face: FaceRecord
    muscles: tuple[MuscleRecord, ...]
    units: tuple[UnitRecord, ...]
    emotions: tuple[EmotionRecord, ...]
    expression: dict[Name, Weight]
    settings: SettingsRecord
    corrections: tuple[CorrectionRecord, ...] = ()
    animation: AnimationRecord | None = None


Document = TypeVar("Document", bound=Record)


def parse(raw: Mapping[str, Any], kind: type[Document], format_: str, member: str) -> Document:
    """A checked document from JSON of this or an older version.

    Raises
    ------
    DamageError
        If it is of another format, a newer version, or breaks a rule of the models; the place is named.
    """
    if raw.get("format") != format_:
        raise DamageError(f"{member}, format", f"is not “{format_}”, so it is another kind of file")
    document = _upgraded(dict(raw), member)
    try:
        return kind.model_validate_json(json.dumps(document))
    except ValidationError as error:
        raise _damage(error, member) from error


def _upgraded(document: dict[str, Any], member: str) -> dict[str, Any]:
    version = document.get("schema")
    if type(version) is not int or version < 1:
        raise DamageError(f"{member}, schema", "is not the number of a version")
    if version > SCHEMA:
        raise DamageError(
            f"{member}, schema",
            f"is {version}, so it was written by a newer version of Risorius (this one reads up to {SCHEMA})",
            "update Risorius to open it",
        )
    for old in range(version, SCHEMA):
        document = UPGRADES[old](document)
    return document


def _damage(error: ValidationError, member: str) -> DamageError:
    """The first complaint of pydantic as one sentence with its place."""
    first = error.errors(include_url=False, include_input=False)[0]
    place = "".join(f"[{step}]" if isinstance(step, int) else f".{step}" for step in first["loc"]).lstrip(".")
    says = {
        "extra_forbidden": "is not known to this version",
        "missing": "is missing",
        "finite_number": "is not a finite number",
    }.get(first["type"])
    if says is None:
        says = "is not valid: " + first["msg"].removeprefix("Input ").removeprefix("Value ")
    return DamageError(f"{member}, {place}" if place else member, says)

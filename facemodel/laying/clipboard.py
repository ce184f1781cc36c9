"""Muscles as text, to be copied from one project and pasted into another, whatever its head."""

from __future__ import annotations

import json
from collections.abc import Iterable
from typing import Annotated, Any, Final, Literal

import numpy as np
from pydantic import Field

from facemodel.errors import MuscleError
from facemodel.face import Face
from facemodel.io.damage import RESTORE, DamageError
from facemodel.io.readable import readable
from facemodel.io.record_types import Name, Point, Record
from facemodel.io.records import muscle_json, muscle_of, point_json
from facemodel.io.schema import SCHEMA, MuscleRecord, parse
from facemodel.laying.checks import shape_complaints
from facemodel.laying.fitting import fitted
from facemodel.laying.warp import control_points, landmark_warp
from facemodel.muscles import Muscle
from fem.types import FloatArray

FORMAT: Final = "risorius-muscles"

LONGEST_TEXT = 4_000_000
"""Characters of a text that is taken for muscles; all muscles of a face take a hundredth of it."""

SAME_HEAD = 0.05
"""Millimetres by which the landmarks of two heads may differ that count as one."""


class MusclesDocument(Record):
    """Copied muscles, with the places of the head they come from, by which they can be fitted to another one."""

    format: Literal["risorius-muscles"]
    version: Literal[2] = Field(alias="schema")
    places: dict[Name, tuple[Point, Point]]
    muscles: Annotated[tuple[MuscleRecord, ...], Field(min_length=1, max_length=10_000)]


def muscles_text(muscles: Iterable[Muscle], face: Face) -> str:
    """Muscles of a face as JSON text."""
    document: dict[str, Any] = {
        "format": FORMAT,
        "schema": SCHEMA,
        "places": {name: [point_json(p) for p in pair] for name, pair in control_points(face).items()},
        "muscles": [muscle_json(muscle) for muscle in muscles],
    }
    return readable(document).decode()


def muscles_from(text: str, face: Face) -> tuple[Muscle, ...]:
    """The muscles of a text on a face; fitted to it by landmarks if they come from another head.

    Raises
    ------
    MuscleError
        If the text is no copy of muscles, is damaged or newer, or the heads share too few landmarks.
    """
    document = _document(text)
    muscles = tuple(muscle_of(record) for record in document.muscles)
    for muscle in muscles:
        for complaint in shape_complaints(muscle):
            raise MuscleError(f"The copied text cannot be pasted: {complaint}")
    source = {name: np.array(pair) for name, pair in document.places.items()}
    target = control_points(face)
    if _same_head(source, target):
        return muscles
    warp = landmark_warp(source, target)
    return tuple(fitted(muscle, warp, face) for muscle in muscles)


def _document(text: str) -> MusclesDocument:
    try:
        raw = json.loads(text) if len(text) <= LONGEST_TEXT else None
    except (ValueError, RecursionError) as error:
        raise MuscleError("The copied text is no copy of muscles; copy some muscles first.") from error
    if not isinstance(raw, dict) or raw.get("format") != FORMAT:
        raise MuscleError("The copied text is no copy of muscles; copy some muscles first.")
    try:
        return parse(raw, MusclesDocument, FORMAT, "its text")
    except DamageError as damage:
        remedy = "copy them again" if damage.remedy == RESTORE else damage.remedy
        raise MuscleError(f"The copied muscles cannot be pasted: {damage.where} {damage.what}; {remedy}.") from damage


def _same_head(source: dict[str, FloatArray], target: dict[str, FloatArray]) -> bool:
    if source.keys() != target.keys():
        return False
    return all(float(np.abs(source[name] - target[name]).max()) < SAME_HEAD for name in source)

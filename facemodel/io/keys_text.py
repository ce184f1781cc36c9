"""Copied keys as text, for the clipboard of the system: from one project to another, or into a mail."""

from __future__ import annotations

import json
from typing import Annotated, Final, Literal

from pydantic import Field, ValidationError

from facemodel.animation.curve import Curve, Key, curve_of
from facemodel.animation.editing.clipboard import Copied
from facemodel.errors import RisoriusError
from facemodel.io.animation_schema import MOST_TRACKS, Amount, Time
from facemodel.io.record_types import Name, Record

FORMAT: Final = "risorius-keys"
MOST_KEYS = 1_000_000

LONGEST_TEXT = 1 << 27
"""Characters; a million keys."""

Pair = tuple[Amount, Amount]


class KeysError(RisoriusError):
    """A text holds no keys that could be pasted."""


class KeyRecord(Record):
    """See `facemodel.animation.curve.Key`."""

    time: Time
    value: Amount
    shape: Literal["step", "linear", "smooth", "bezier"] = "smooth"
    arrives: Pair = (0.0, 0.0)
    leaves: Pair = (0.0, 0.0)
    weighted: bool = False
    broken: bool = False


class RowRecord(Record):
    """One row: a channel, 0 for its track or the number of a layer, and the keys."""

    channel: Name
    row: Annotated[int, Field(ge=0, le=100)] = 0
    overshoot: bool = False
    keys: Annotated[tuple[KeyRecord, ...], Field(min_length=1, max_length=MOST_KEYS)]


class KeysRecord(Record):
    """All of it."""

    format: Literal["risorius-keys"]
    rows: Annotated[tuple[RowRecord, ...], Field(min_length=1, max_length=MOST_TRACKS)]


def keys_text(copied: Copied) -> str:
    """Copied keys as text."""
    rows = [
        {
            "channel": channel,
            **({"row": row} if row else {}),
            **({"overshoot": True} if curve.overshoot else {}),
            "keys": [_key_json(key) for key in curve.keys],
        }
        for (channel, row), curve in copied.items()
    ]
    return json.dumps({"format": FORMAT, "rows": rows}, ensure_ascii=False)


def _key_json(key: Key) -> dict[str, object]:
    usual = Key(key.time, key.value)
    return {
        name: getattr(key, name)
        for name in KeyRecord.model_fields
        if name in ("time", "value") or getattr(key, name) != getattr(usual, name)
    }


def keys_from(text: str) -> Copied:
    """Copied keys from a text.

    Raises
    ------
    KeysError
        If it holds none.
    """
    if len(text) > LONGEST_TEXT:
        raise KeysError("The clipboard holds too much text to be keys; copy keys first.")
    try:
        record = KeysRecord.model_validate_json(text)
    except ValidationError as error:
        raise KeysError("The clipboard holds no keys; copy some in the timeline first.") from error
    return {(row.channel, row.row): _curve(row) for row in record.rows}


def _curve(row: RowRecord) -> Curve:
    keys = (
        Key(each.time, each.value, each.shape, each.arrives, each.leaves, each.weighted, each.broken)
        for each in row.keys
    )
    return curve_of(keys, row.overshoot)

"""Mapping tables as files of their own, to be kept, edited by hand and shared."""

from __future__ import annotations

import json
from dataclasses import asdict
from pathlib import Path
from typing import Annotated, Final, Literal

from pydantic import Field, ValidationError

from facemodel.animation.mapping import Mapping, MapRow
from facemodel.io.damage import DamageError, naming
from facemodel.io.disk import read_file, replacing
from facemodel.io.record_types import Name, Record
from facemodel.io.weights.table import decoded

FORMAT: Final = "risorius-mapping"
LARGEST_FILE = 1 << 22
AGAIN = "correct it, or save the table again"

Gain = Annotated[float, Field(ge=-1e6, le=1e6)]


class RowRecord(Record):
    """See `facemodel.animation.mapping.MapRow`."""

    source: Name
    target: Name
    gain: Gain = 1.0
    offset: Gain = 0.0
    cap: Annotated[float, Field(ge=0, le=1e6)] | None = None
    centred: bool = False


class MappingRecord(Record):
    """See `facemodel.animation.mapping.Mapping`."""

    format: Literal["risorius-mapping"]
    name: Name
    smoothing: Annotated[float, Field(ge=0, le=10)] = 0.0
    rows: Annotated[tuple[RowRecord, ...], Field(max_length=10_000)]


def save_mapping(mapping: Mapping, path: Path) -> None:
    """Write a table, a row on each line.

    Raises
    ------
    ProjectError
        If it cannot be written; a previous file stays.
    """
    usual = asdict(MapRow("", ""))
    rows = [{k: v for k, v in asdict(row).items() if v != usual[k]} for row in mapping.rows]
    lines = ",\n".join(f"  {json.dumps(row, ensure_ascii=False)}" for row in rows)
    head = f' "format": "{FORMAT}",\n "name": {json.dumps(mapping.name, ensure_ascii=False)}'
    text = f'{{\n{head},\n "smoothing": {mapping.smoothing!r},\n "rows": [\n{lines}\n ]\n}}\n'
    with replacing(path) as stream:
        stream.write(text.encode())


def load_mapping(path: Path) -> Mapping:
    """Read a table.

    Raises
    ------
    ProjectError
        If there is no such file, or it is no table; the place is named.
    """
    data = read_file(path, LARGEST_FILE)
    with naming(path, "read"):
        return mapping_of(data)


def mapping_of(data: bytes) -> Mapping:
    """The table in the bytes of a file.

    Raises
    ------
    DamageError
        If it is none.
    """
    try:
        record = MappingRecord.model_validate_json(decoded(data))
    except ValidationError as error:
        first = error.errors(include_url=False, include_input=False)[0]
        place = "".join(f"[{step}]" if isinstance(step, int) else f".{step}" for step in first["loc"]).lstrip(".")
        raise DamageError(place or "the file", f"is not valid: {first['msg']}", AGAIN) from error
    rows = tuple(MapRow(**row.model_dump()) for row in record.rows)
    return Mapping(record.name, rows, record.smoothing)

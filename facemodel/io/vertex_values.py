"""Painted layers as plain numbers, one per skin vertex: ``.npy`` arrays and ``.csv`` tables."""

from __future__ import annotations

import csv
import re
from io import StringIO
from pathlib import Path

import numpy as np

from facemodel.errors import ProjectError
from facemodel.face import Face
from facemodel.io.damage import DamageError, naming
from facemodel.io.disk import read_file, replacing
from facemodel.io.npy import npy_array, npy_bytes
from facemodel.io.texture_codes import check_within, whole_span
from facemodel.painting.delta import LayerDelta
from facemodel.painting.layers import PaintLayer
from fem.types import FloatArray, IntArray

SUFFIXES = (".npy", ".csv")
LARGEST_FILE = 1 << 26
"""Bytes; a million vertices in words."""

VERTEX = "vertex"
AGAIN = "correct the file, or export the layer again"


def export_values(face: Face, layer: PaintLayer, path: Path) -> None:
    """Write the values of a layer, exactly.

    An ``.npy`` file holds one float64 per vertex, a ``.csv`` file a row of vertex and value under a heading.

    Raises
    ------
    ProjectError
        If the ending is another one, or the file cannot be written.
    """
    values = layer.values(face)
    if _suffix(path, "saved") == ".npy":
        data = npy_bytes(values)
    else:
        text = StringIO(newline="")
        rows = csv.writer(text, lineterminator="\n")
        rows.writerow(_heading(layer))
        rows.writerows(enumerate(values.tolist()))
        data = text.getvalue().encode()
    with replacing(path) as stream:
        stream.write(data)


def import_values(face: Face, layer: PaintLayer, path: Path) -> LayerDelta:
    """Read values of a layer; a table may leave out vertices, which keep theirs.

    Raises
    ------
    ProjectError
        If there is no such file, or it is not what `export_values` writes; the place is named.
    PaintError
        If a value is outside the layer's range.
    """
    suffix = _suffix(path, "opened")
    data = read_file(path, LARGEST_FILE)
    with naming(path, "opened"):
        vertices, values = _array(data, path, face) if suffix == ".npy" else _table(data, face)
    check_within(layer, values, whole_span(layer), f"“{path}”", "correct the file")
    return layer.delta(face, vertices, values)


def _suffix(path: Path, failed: str) -> str:
    suffix = path.suffix.lower()
    if suffix not in SUFFIXES:
        raise ProjectError(f"“{path}” cannot be {failed}: values per vertex are in {' or '.join(SUFFIXES)} files.")
    return suffix


def _heading(layer: PaintLayer) -> tuple[str, str]:
    return VERTEX, f"{layer.key} [{layer.unit}]" if layer.unit else layer.key


def _array(data: bytes, path: Path, face: Face) -> tuple[IntArray, FloatArray]:
    values = npy_array(data, path.name)
    count = len(face.skin.positions)
    if values.shape != (count,):
        raise DamageError(path.name, f"has the shape {values.shape} and not ({count},), one value per vertex", AGAIN)
    numbers = values.astype(np.float64)
    bad = np.flatnonzero(~np.isfinite(numbers))
    if len(bad):
        raise DamageError(f"{path.name} at {bad[0]}", "is not a finite number", AGAIN)
    return np.arange(count), numbers


def _table(data: bytes, face: Face) -> tuple[IntArray, FloatArray]:
    found: dict[int, float] = {}
    try:
        lines = csv.reader(StringIO(data.decode("utf-8-sig"), newline=""))
        for number, row in enumerate(lines, start=1):
            if number == 1 and (len(row) != 2 or row[0].strip() != VERTEX):
                raise DamageError("line 1", f"is not a heading of “{VERTEX}” and the layer", AGAIN)
            if number > 1 and row:
                vertex = _vertex(row, number, face, found)
                found[vertex] = _value(row, number)
    except (UnicodeDecodeError, csv.Error) as error:
        raise DamageError("the file", "is not a table in UTF-8", AGAIN) from error
    if not found:
        raise DamageError("the table", "names no vertex", AGAIN)
    vertices = np.array(sorted(found), dtype=np.int64)
    return vertices, np.array([found[vertex] for vertex in vertices.tolist()], dtype=np.float64)


def _vertex(row: list[str], number: int, face: Face, found: dict[int, float]) -> int:
    count = len(face.skin.positions)
    if len(row) != 2 or not re.fullmatch(r"\s*[0-9]{1,10}\s*", row[0]):
        raise DamageError(f"line {number}", "is not a vertex and a value", AGAIN)
    vertex = int(row[0])
    if vertex >= count:
        raise DamageError(f"line {number}", f"names vertex {vertex}, and the skin has 0 to {count - 1}", AGAIN)
    if vertex in found:
        raise DamageError(f"line {number}", f"names vertex {vertex} a second time", AGAIN)
    return vertex


def _value(row: list[str], number: int) -> float:
    try:
        value = float(row[1])
    except ValueError as error:
        raise DamageError(f"line {number}", "is not a vertex and a value", AGAIN) from error
    if not np.isfinite(value):
        raise DamageError(f"line {number}", "holds no finite number", AGAIN)
    return value

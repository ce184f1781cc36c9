"""A face as a file of its own: ``.face``, the form in which the shipped individuals are kept."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray

from facemodel.face import Face
from facemodel.io.archive import LARGEST_ARCHIVE, Archive, pack, unpack
from facemodel.io.damage import TAKE_BACK, naming
from facemodel.io.disk import read_file, replacing
from facemodel.io.face_arrays import face_arrays, face_json, face_of
from facemodel.io.schema import FACE_FORMAT, SCHEMA, FaceDocument, parse

FACE_MEMBER = "face.json"
ALWAYS_DOUBLE = {"face/skin/chart"}
"""Rounding could flip a small triangle of the chart."""


def write_face(face: Face, path: Path, *, single: bool = False) -> None:
    """Write a face; with ``single`` all numbers but the chart in single precision, at half the size.

    Raises
    ------
    ProjectError
        If the face is not valid or the file cannot be written; a previous file stays as it was.
    """
    with naming(path, "saved", TAKE_BACK):
        data = _face_bytes(face, single)
        _face_of(data)
    with replacing(path) as stream:
        stream.write(data)


def read_face(path: Path) -> Face:
    """Read a face.

    Raises
    ------
    ProjectError
        If there is no such file or it is damaged; the place and the remedy are named.
    """
    data = read_file(path, LARGEST_ARCHIVE)
    with naming(path, "opened"):
        return _face_of(data)


def _face_bytes(face: Face, single: bool) -> bytes:
    document = {"format": FACE_FORMAT, "schema": SCHEMA, "face": face_json(face)}
    arrays = face_arrays(face)
    if single:
        arrays = {name: array if name in ALWAYS_DOUBLE else _single(array) for name, array in arrays.items()}
    return pack(Archive(document, arrays), FACE_MEMBER)


def _single(array: NDArray[Any]) -> NDArray[Any]:
    return array.astype(np.float32) if array.dtype.kind == "f" else array


def _face_of(data: bytes) -> Face:
    archive = unpack(data, FACE_MEMBER)
    document = parse(archive.document, FaceDocument, FACE_FORMAT, FACE_MEMBER)
    return face_of(document.face, archive.arrays, FACE_MEMBER)

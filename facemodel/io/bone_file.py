"""Read a skull from an OBJ, PLY or STL file of whoever made it."""

from __future__ import annotations

import re
from io import BytesIO
from pathlib import Path

import numpy as np
import trimesh

from facemodel.errors import ProjectError, SkullError
from facemodel.io.damage import DamageError, naming
from facemodel.io.disk import read_file
from facemodel.skull.mending import Bone, Told, mended
from fem.types import FloatArray, IntArray

SUFFIXES = (".obj", ".ply", ".stl")

LARGEST_FILE = 1 << 28
"""Bytes; five million triangles in words."""

MOST_TRIANGLES = 6_000_000
"""As many as the largest file can hold in words; a binary one may hold more."""

HEADER = 4096
"""Bytes at the beginning of a PLY file in which it says how much it holds."""

LEAST_BYTES = {b"vertex": 3, b"face": 4}
"""Bytes that a vertex or a face of a PLY file takes at least, however they are written."""

KINDS = {b"vertex": "vertices", b"face": "triangles"}

REMEDY = "choose another file, or repair it in a program for meshes and export it again"

UNREADABLE = (ValueError, KeyError, IndexError, TypeError, AttributeError, EOFError, OverflowError, NameError)
"""What the reader raises for files that are not what they say."""


def read_bone(path: Path, told: Told = lambda _text, _share: None) -> Bone:
    """A mesh that can be a skull.

    Parameters
    ----------
    path : of a file that ends in .obj, .ply or .stl
    told : of every step and the share that is done; what it raises passes through

    Raises
    ------
    ProjectError
        If there is no such file, it is too large, damaged, or its mesh encloses nothing.
    """
    suffix = path.suffix.lower()
    if suffix not in SUFFIXES:
        raise ProjectError(f"“{path}” cannot be opened: a skull is read from {', '.join(SUFFIXES)} files.")
    told("Reading the file", 0.05)
    _check_size(path)
    data = read_file(path, LARGEST_FILE)
    with naming(path, "opened", REMEDY):
        told("Reading the mesh", 0.1)
        positions, triangles = _mesh(data, suffix)
        try:
            return mended(positions, triangles, told)
        except SkullError as error:
            raise DamageError("its mesh", str(error)) from error


def _check_size(path: Path) -> None:
    """Refuse a file that is too large; one that is not there is told of by whoever reads it."""
    if path.is_file() and path.stat().st_size > LARGEST_FILE:
        raise ProjectError(
            f"“{path}” cannot be opened: it has {path.stat().st_size / 2**20:.0f} MiB and at most "
            f"{LARGEST_FILE / 2**20:.0f} MiB are read; reduce the mesh in the program that made it."
        )


def _mesh(data: bytes, suffix: str) -> tuple[FloatArray, IntArray]:
    """Positions (n, 3) and triangles (t, 3) as they are in a file."""
    if not data.strip():
        raise DamageError("the file", "is empty")
    _check_promises(data, suffix)
    options = {"skip_materials": True, "group_material": False} if suffix == ".obj" else {}
    try:
        found = trimesh.load_mesh(BytesIO(data), file_type=suffix[1:], process=False, **options)
        positions, triangles = np.array(found.vertices, dtype=np.float64), np.array(found.faces, dtype=np.int64)
    except UNREADABLE as error:
        raise DamageError("the mesh", "is damaged or cut short") from error
    if positions.ndim != 2 or triangles.ndim != 2 or not len(triangles):
        raise DamageError("the file", "has no triangles")
    if len(triangles) > MOST_TRIANGLES:
        raise DamageError("the mesh", f"has {len(triangles)} triangles and at most {MOST_TRIANGLES} are read")
    if triangles.min() < 0 or triangles.max() >= len(positions):
        raise DamageError("the mesh", "has a triangle with a corner that is not there")
    return positions, triangles


def _check_promises(data: bytes, suffix: str) -> None:
    """Refuse a file that says that it holds more than it can, before memory is set aside for it."""
    promised = []
    if suffix == ".ply":
        found = re.findall(rb"^element (vertex|face) (\d+)", data[:HEADER], re.MULTILINE)
        promised = [(int(count), KINDS[what], LEAST_BYTES[what]) for what, count in found]
    elif suffix == ".stl" and not data.lstrip().startswith(b"solid"):
        promised = [(int.from_bytes(data[80:84], "little"), "triangles", 50)]
    for count, what, size in promised:
        if count * size > len(data):
            raise DamageError("the mesh", f"should have {count} {what} and is shorter than that")

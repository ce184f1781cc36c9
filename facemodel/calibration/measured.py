"""Measured expressions of one face: a neutral surface with landmarks, and how it moves from there."""

from __future__ import annotations

import zipfile
from collections.abc import Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.sparse.csgraph import connected_components

from facemodel.errors import ProjectError
from facemodel.mesh import Mesh, submesh
from fem.types import FloatArray, IntArray

LANDMARKS = 68
"""Points of the scheme in which the places of a measured face are told."""

MOST_BYTES = 4 << 30
"""Unpacked size beyond which a file is refused: 52 fields on half a million vertices need a sixth of it."""

FARTHEST = 1e4
"""Millimetres; a coordinate beyond ten metres is no face."""

NAMED = ("neutral", "triangles", "landmarks68", "names", "deltas")


@dataclass(frozen=True, eq=False)
class MeasuredFace:
    """What was measured.

    Attributes
    ----------
    mesh : the neutral surface, millimetres
    landmarks : (68,) its vertices in the order of the 68-point scheme
    names : K names of expressions, in the ARKit manner
    deltas : (K, N, 3) displacement of its vertices, millimetres
    left_out : vertices of the file that belong to no triangle, or to another piece than the landmarks
    """

    mesh: Mesh
    landmarks: IntArray
    names: tuple[str, ...]
    deltas: FloatArray
    left_out: int = 0


def read_measured(path: Path) -> MeasuredFace:
    """Read an ``.npz`` of measured expressions; arrays of other names are ignored.

    Raises
    ------
    ProjectError
        If the file cannot be read, or an array is missing, of a wrong shape or outside its range.
    """
    arrays = _arrays(path)
    neutral = _floats(arrays, "neutral", path, (None, 3))
    count = len(neutral)
    triangles = _indices(arrays, "triangles", path, (None, 3), count)
    landmarks = _indices(arrays, "landmarks68", path, (LANDMARKS,), count)
    names = _names(arrays["names"], path)
    deltas = _floats(arrays, "deltas", path, (len(names), count, 3))
    return _one_piece(Mesh(neutral, triangles), landmarks, names, deltas, path)


def _arrays(path: Path) -> Mapping[str, NDArray[Any]]:
    try:
        with zipfile.ZipFile(path) as archive:
            size = sum(each.file_size for each in archive.infolist() if each.filename.removesuffix(".npy") in NAMED)
        if size > MOST_BYTES:
            raise _wrong(path, f"would unpack to {size >> 20} MB; give fewer or coarser fields")
        with np.load(path, allow_pickle=False) as found:
            missing = [name for name in NAMED if name not in found.files]
            if missing:
                raise _wrong(path, f"has no array “{missing[0]}”; it needs {', '.join(NAMED)}")
            return {name: found[name] for name in NAMED}
    except OSError as error:
        raise ProjectError(f"“{path}” cannot be read: {error.strerror or error}.") from error
    except (ValueError, EOFError, zipfile.BadZipFile) as error:
        raise _wrong(path, "is no .npz archive of plain arrays; save it with numpy.savez") from error


def _floats(arrays: Mapping[str, NDArray[Any]], name: str, path: Path, shape: tuple[int | None, ...]) -> FloatArray:
    array = _shaped(arrays[name], name, path, shape, "fiu")
    values = array.astype(np.float64)
    if not (np.abs(values) < FARTHEST).all():
        where = tuple(int(k) for k in np.argwhere(~(np.abs(values) < FARTHEST))[0])
        raise _wrong(path, f"has {values[where]:g} at {list(where)} of “{name}”; coordinates are finite millimetres")
    return values


def _indices(
    arrays: Mapping[str, NDArray[Any]], name: str, path: Path, shape: tuple[int | None, ...], count: int
) -> IntArray:
    array = _shaped(arrays[name], name, path, shape, "iu").astype(np.int64)
    if not ((array >= 0) & (array < count)).all():
        bad = int(array[(array < 0) | (array >= count)][0])
        raise _wrong(path, f"names vertex {bad} in “{name}”; there are vertices 0 to {count - 1}")
    return array


def _shaped(array: NDArray[Any], name: str, path: Path, shape: tuple[int | None, ...], kinds: str) -> NDArray[Any]:
    fits = array.ndim == len(shape) and all(want in (None, have) for want, have in zip(shape, array.shape, strict=True))
    if not fits or array.dtype.kind not in kinds or array.size == 0:
        wanted = ", ".join("N" if want is None else str(want) for want in shape)
        raise _wrong(path, f"has {array.dtype} {array.shape} as “{name}”; it must be numbers of shape ({wanted})")
    return array


def _names(array: NDArray[Any], path: Path) -> tuple[str, ...]:
    if array.ndim != 1 or array.dtype.kind != "U" or array.size == 0:
        raise _wrong(path, "has “names” that are no list of words; it must hold one word per field")
    names = tuple(str(name) for name in array)
    twice = sorted({name for name in names if names.count(name) > 1})
    if twice:
        raise _wrong(path, f"has the name “{twice[0]}” twice; every field needs its own")
    return names


def _one_piece(mesh: Mesh, landmarks: IntArray, names: tuple[str, ...], deltas: FloatArray, path: Path) -> MeasuredFace:
    """The piece of the surface that carries the landmarks, numbered anew."""
    piece = connected_components(mesh.adjacency, directed=False)[1]
    used = np.isin(np.arange(len(piece)), mesh.triangles)
    here = np.bincount(piece[landmarks]).argmax()
    stray = np.flatnonzero((piece[landmarks] != here) | ~used[landmarks])
    if len(stray):
        raise _wrong(path, f"has landmark {stray[0]} off the piece of skin of the others; all 68 lie on one skin")
    part, vertices = submesh(mesh, piece[mesh.triangles[:, 0]] == here)
    number = np.full(len(piece), -1)
    number[vertices] = np.arange(len(vertices))
    return MeasuredFace(part, number[landmarks], names, deltas[:, vertices], len(piece) - len(vertices))


def _wrong(path: Path, what: str) -> ProjectError:
    return ProjectError(f"The measured face “{path}” {what}.")

"""Where a face's vertices and triangles lie in a picture, by its texture coordinates."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.ndimage import distance_transform_edt
from scipy.sparse import csc_array, csr_array, eye_array
from scipy.sparse.linalg import splu

from facemodel.errors import PaintError
from facemodel.face import Face
from fem.types import BoolArray, Float32Array, FloatArray, IntArray

SEAM = 4.0
"""A triangle whose longest edge in the picture is this many times longer than that of a usual one of its size on the
skin bridges a seam: its corners lie on different sides of the cut, and what it covers belongs to others."""

BATCH = 200_000
"""Texels looked at together: few enough to stay in the cache, whatever the size of the picture."""

SPREAD = 16
"""Texels by which colour goes on beyond the skin, so that neither filtering nor smaller copies of the picture draw the
background over the seams."""

LOOSE = 1e-6
"""Added to the equations of vertices so close together in the picture that they share their texels; apart from these
it is far below a quantisation step."""


ROUNDS = 12
"""Projections in turn after which a picture at its darkest or lightest is as true as it gets."""


@dataclass(frozen=True, eq=False)
class TexturedSkin:
    """The part of a skin that has a place of its own in a picture.

    The rest, such as a neck that was added to a head, shares its texture coordinates with other vertices or bridges a
    seam; nothing of it is drawn and nothing is read for it.

    Attributes
    ----------
    uv : (N, 2) texture coordinates of all vertices, v upwards
    triangles : (T', 3) triangles that are drawn
    vertices : (n,) vertices that are drawn and read
    """

    uv: FloatArray
    triangles: IntArray
    vertices: IntArray


@dataclass(frozen=True, eq=False)
class Texels:
    """The texels of a picture whose middle lies on the skin.

    Attributes
    ----------
    index : (k,) row by row from the top left
    corners : (k, 3) vertices of the triangle that each lies in
    shares : (k, 3) barycentric coordinates in it
    """

    index: IntArray
    corners: IntArray
    shares: FloatArray


def textured_skin(face: Face) -> TexturedSkin:
    """Find what of a face has a place of its own in a picture.

    Raises
    ------
    PaintError
        If nothing has.
    """
    skin, uv = face.skin, face.uv
    i, j = skin.edges.T
    scale = _lengths(uv, i, j) / np.maximum(_lengths(skin.positions, i, j), np.finfo(float).tiny)
    usual = float(np.median(scale[scale > 0])) if (scale > 0).any() else 1.0
    own = _owners(uv, i, j, scale / usual)
    a, b, c = skin.triangles.T
    first, second = uv[b] - uv[a], uv[c] - uv[a]
    upright = first[:, 0] * second[:, 1] - first[:, 1] * second[:, 0] > 0
    longest = np.max([_lengths(uv, *ends) for ends in ((a, b), (b, c), (c, a))], axis=0)
    size = np.max([_lengths(skin.positions, *ends) for ends in ((a, b), (b, c), (c, a))], axis=0)
    whole = own[skin.triangles].all(axis=1) & upright & (longest < SEAM * usual * size)
    if not whole.any():
        raise PaintError(
            f"The face “{face.title}” has no texture coordinates of its own, so no picture can be painted."
        )
    return TexturedSkin(uv, skin.triangles[whole], np.unique(skin.triangles[whole]))


def _lengths(points: FloatArray, i: IntArray, j: IntArray) -> FloatArray:
    return np.asarray(np.linalg.norm(points[i] - points[j], axis=1))


def _owners(uv: FloatArray, i: IntArray, j: IntArray, scale: FloatArray) -> BoolArray:
    """Vertices (N,) that do not borrow their place: of those at one place the one whose edges fit it best."""
    misfit = np.abs(np.log(np.maximum(scale, np.finfo(float).tiny)))
    vertex, edge = np.concatenate([i, j]), np.tile(misfit, 2)
    order = np.lexsort((edge, vertex))
    count = np.bincount(vertex, minlength=len(uv))
    middle = np.minimum(np.cumsum(count) - count + count // 2, len(order) - 1)
    median = np.where(count > 0, edge[order][middle], np.inf)
    place = np.unique(uv, axis=0, return_inverse=True)[1].ravel()
    best = np.lexsort((median, place))
    own = np.zeros(len(uv), dtype=np.bool_)
    own[best[np.append(True, place[best][1:] != place[best][:-1])]] = True
    return own


def texels_on(skin: TexturedSkin, width: int, height: int) -> Texels:
    """The texels whose middle lies in a triangle; each once."""
    found = [_inside(chunk, corners, width, height) for chunk, corners in _candidates(skin, width, height)]
    index, triangle, shares = (np.concatenate(column) for column in zip(*found, strict=True))
    index, once = np.unique(index, return_index=True)
    return Texels(index, skin.triangles[triangle[once]], shares[once])


def _candidates(skin: TexturedSkin, width: int, height: int) -> Iterator[tuple[IntArray, FloatArray]]:
    """Triangles in batches, with their corners (t, 3, 2) in texels; row 0 is the top."""
    corners = places(skin.uv, width, height)[skin.triangles]
    box = np.floor(corners.max(axis=1)) - np.ceil(corners.min(axis=1)) + 1
    texels = np.cumsum(np.maximum(box, 0).prod(axis=1))
    batch = (texels // BATCH).astype(np.int64)
    for number in np.unique(batch):
        chunk = np.flatnonzero(batch == number)
        yield chunk, corners[chunk]


def _inside(chunk: IntArray, corners: FloatArray, width: int, height: int) -> tuple[IntArray, IntArray, FloatArray]:
    """Texel, triangle and barycentric coordinates of all texels of the boxes that are in their triangles."""
    low = np.ceil(corners.min(axis=1)).astype(np.int64)
    box = np.maximum(np.floor(corners.max(axis=1)).astype(np.int64) - low + 1, 0)
    count = box.prod(axis=1)
    which = np.repeat(np.arange(len(chunk)), count)
    step = np.arange(len(which)) - np.repeat(np.cumsum(count) - count, count)
    column, row = low[which, 0] + step % box[which, 0], low[which, 1] + step // box[which, 0]
    start, to_b, to_c = corners[:, 0], corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0]
    whole = to_b[:, 0] * to_c[:, 1] - to_b[:, 1] * to_c[:, 0]
    x, y = column - start[which, 0], row - start[which, 1]
    second = x * (to_c[:, 1] / whole)[which] - y * (to_c[:, 0] / whole)[which]
    third = y * (to_b[:, 0] / whole)[which] - x * (to_b[:, 1] / whole)[which]
    shares = np.stack([1 - second - third, second, third], axis=1)
    inside = (shares >= 0).all(axis=1) & (column >= 0) & (column < width) & (row >= 0) & (row < height)
    keep = np.flatnonzero(inside)
    return row[keep] * width + column[keep], chunk[which[keep]], shares[keep]


def places(uv: FloatArray, width: int, height: int) -> FloatArray:
    """Texture coordinates (n, 2) in texels to the right and down, whole numbers at the middles of texels."""
    return np.column_stack([uv[:, 0] * width - 0.5, (1 - uv[:, 1]) * height - 0.5])


@dataclass(frozen=True, eq=False)
class Reading:
    """How to read a picture between its texels (bilinearly) at n places.

    Attributes
    ----------
    index : (n, 4) texels around each place, row by row from the top left
    weights : (n, 4) their parts, which sum to one
    """

    index: IntArray
    weights: FloatArray

    def of(self, picture: NDArray[Any]) -> FloatArray:
        """What is read (n, C) of a picture (H, W, C)."""
        texels = picture.reshape(-1, picture.shape[2])[self.index]
        return np.asarray(np.einsum("nk,nkc->nc", self.weights, texels, dtype=np.float64))

    @property
    def nearest(self) -> IntArray:
        """The texel (n,) in whose middle each place is most nearly."""
        return np.take_along_axis(self.index, self.weights.argmax(axis=1)[:, None], axis=1)[:, 0]


def reading(uv: FloatArray, width: int, height: int) -> Reading:
    """How to read a picture at texture coordinates (n, 2)."""
    at = np.clip(places(uv, width, height), 0, [width - 1, height - 1])
    low = np.minimum(np.floor(at).astype(np.int64), [width - 2, height - 2])
    x, y = (at - low).T
    first = low[:, 1] * width + low[:, 0]
    index = first[:, None] + np.array([0, 1, width, width + 1])
    return Reading(index, np.stack([(1 - y) * (1 - x), (1 - y) * x, y * (1 - x), y * x], axis=1))


def spread(colours: Float32Array, index: IntArray, size: int) -> Float32Array:
    """A square picture (size, size, C) of colours (k, C) at texels (k,), carried on over `SPREAD` others around."""
    covered = np.zeros((size, size), dtype=np.bool_)
    covered.reshape(-1)[index] = True
    rows, columns = (np.flatnonzero(covered.any(axis=axis)) for axis in (1, 0))
    part = tuple(slice(max(int(at[0]) - SPREAD, 0), int(at[-1]) + SPREAD + 1) for at in (rows, columns))
    away, (row, column) = distance_transform_edt(~covered[part], return_indices=True)
    source = np.zeros((size, size), dtype=np.int64)
    source.reshape(-1)[index] = np.arange(len(index))
    picture = np.zeros((size, size, colours.shape[1]), dtype=np.float32)
    picture[part] = np.where((away <= SPREAD)[..., None], colours[source[part][row, column]], np.float32(0))
    return picture


def true_at_vertices(picture: Float32Array, read: Reading, values: FloatArray) -> Float32Array:
    """A small change of a picture (H, W, C) after which reading it at the vertices gives their values (n, C).

    A picture of triangles is right at the middles of texels, and between them rounds off the vertices, which are its
    kinks; what is read would be off by more than a quantisation step.  The least change that makes it right and the
    nearest colours that there are, from 0 to 1, are taken in turn (alternating projections).
    """
    used, column = np.unique(read.index, return_inverse=True)
    rows = np.repeat(np.arange(len(values)), 4)
    operator = csr_array((read.weights.ravel(), (rows, column.ravel())), shape=(len(values), len(used)))
    equations = csc_array(operator @ operator.T + LOOSE * eye_array(len(values)))
    factor = splu(equations)
    flat = picture.reshape(-1, picture.shape[2]).copy()
    around = flat[used].astype(np.float64)
    for _ in range(ROUNDS):
        around = np.clip(around + operator.T @ factor.solve(values - operator @ around), 0.0, 1.0)
    flat[used] = around
    return flat.reshape(picture.shape)

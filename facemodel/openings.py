"""The openings of the skin, mouth and eyes, as slits between an upper and a lower lip or lid."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.sparse import csr_array, diags_array
from scipy.sparse.csgraph import dijkstra
from scipy.sparse.linalg import splu

from facemodel.face import Eye, Face
from facemodel.mesh import Mesh
from fem.types import BoolArray, Float32Array, FloatArray, IntArray


@dataclass(frozen=True, eq=False)
class Slit:
    """An opening between two corners.

    Attributes
    ----------
    upper, lower : skin vertices of its two edges, each from the subject's right corner to the left one
    """

    upper: IntArray
    lower: IntArray

    @property
    def corners(self) -> tuple[int, int]:
        """The right and the left corner, skin vertices."""
        return int(self.upper[0]), int(self.upper[-1])


def mouth_of(face: Face) -> Slit | None:
    """The slit of the mouth; none on a face whose lips are one piece of skin or whose corners are not known."""
    return _slit(face, "mouth_corner_R", "mouth_corner_L")


def lids_of(face: Face, eye: Eye) -> Slit | None:
    """The slit between the lids of an eye; none on a face whose lids are not open or not known."""
    inner, outer = f"eye_inner_{eye.side}", f"eye_outer_{eye.side}"
    return _slit(face, outer, inner) if eye.side == "R" else _slit(face, inner, outer)


def _slit(face: Face, right: str, left: str) -> Slit | None:
    marks = face.landmarks
    if right not in marks or left not in marks:
        return None
    for loop in face.skin.boundary_loops:
        found = split_loop(loop, marks[right], marks[left], face.skin.positions)
        if found is not None:
            return found
    return None


def split_loop(loop: IntArray, right: int, left: int, positions: FloatArray | Float32Array) -> Slit | None:
    """A closed loop as a slit between two of its points; none if it does not hold both, each once."""
    ends = [np.flatnonzero(loop == corner) for corner in (right, left)]
    if right == left or any(len(end) != 1 for end in ends):
        return None
    turned = np.roll(loop, -int(ends[0][0]))
    stop = int(np.flatnonzero(turned == left)[0])
    one, other = turned[: stop + 1], np.append(turned[stop:], turned[0])[::-1]
    high = [float(positions[chain, 1].mean()) for chain in (one, other)]
    return Slit(one, other) if high[0] >= high[1] else Slit(other, one)


def along(positions: FloatArray, chain: IntArray) -> FloatArray:
    """Where (n,) the vertices of an edge of a slit lie on it by its length: -1 at the right corner, 1 at the left."""
    steps = np.linalg.norm(np.diff(positions[chain], axis=0), axis=1)
    reached = np.concatenate([[0.0], np.cumsum(steps)])
    return np.asarray(2 * reached / reached[-1] - 1)


ALIKE = 1.5
"""Millimetres by which ways to both edges differ at most where they lead to a corner; they go along edges."""


def on_upper_side(mesh: Mesh, slit: Slit, alike: float = ALIKE) -> BoolArray:
    """Skin vertices (N,) from which the way over the skin to the upper edge is the shorter one.

    Lips that rest on each other are near in space; on the skin they are far from each other.  Beside a corner, which is
    of both edges, the skin is parted where a membrane would be halfway that is up along the upper edge and down along
    the lower one.

    Parameters
    ----------
    alike : millimetres by which the ways to both edges differ at most beside a corner
    """
    i, j = mesh.edges.T
    length = np.maximum(np.linalg.norm(mesh.positions[i] - mesh.positions[j], axis=1), SHORTEST)
    count = len(mesh.positions)
    graph = csr_array((np.tile(length, 2), (np.concatenate([i, j]), np.concatenate([j, i]))), shape=(count, count))
    upper, lower = (dijkstra(graph, indices=chain, min_only=True) for chain in (slit.upper, slit.lower))
    height = np.where(upper < lower, 1.0, -1.0)
    open_to_both = ~(np.abs(upper - lower) > alike)
    open_to_both[slit.upper[1:-1]] = open_to_both[slit.lower[1:-1]] = False
    height[slit.upper[1:-1]], height[slit.lower[1:-1]] = 1.0, -1.0
    free = np.flatnonzero(open_to_both)
    adjacency = mesh.adjacency
    laplacian = diags_array(np.asarray(adjacency.sum(axis=1)).ravel()) - adjacency
    held = csr_array(laplacian)[free]
    height[free] = splu(held[:, free].tocsc()).solve(-(held[:, ~open_to_both] @ height[~open_to_both]))
    return np.asarray(height > 0)


SHORTEST = 1e-6
"""Millimetres; an edge of no length would be no edge of the graph."""

"""A slit of the skin as it is drawn, with the parts that hang on it, at rest."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import igl
import numpy as np

from facemodel.display import DisplaySurface
from facemodel.face import Face
from facemodel.openings import Slit, on_upper_side, split_loop
from facemodel.sampling import carried_points, points_of_vertices
from fem.types import BoolArray, FloatArray, IntArray


@dataclass(frozen=True, eq=False)
class DrawnSlit:
    """Everything live about a slit: points of the parts that the skin carries, then those of the moving skin.

    Attributes
    ----------
    face : whose slit it is
    rest : (L, 3) all live points at rest
    first : number of the first live point that is one of the skin
    edges : the slit in drawn points of the skin
    upper : (L,) whether each live point belongs to the upper side of it
    away : (L,) millimetres from the edge of its own side
    vertex_upper, vertex_away : (N,) the same of the vertices of the skin
    """

    face: Face
    rest: FloatArray
    first: int
    edges: Slit
    upper: BoolArray
    away: FloatArray
    vertex_upper: BoolArray
    vertex_away: FloatArray

    @property
    def corners(self) -> FloatArray:
        """The right and the left corner (2, 3)."""
        return np.asarray(self.rest[self.first + np.array(self.edges.corners)])

    def spread(self, rule: Rule) -> FloatArray:
        """What a rule gives (L, k) for the live points; parts get the mean of what carries them.

        Parameters
        ----------
        rule : called with places (n, 3), whether they are of the upper side, and how far they are from its edge
        """
        vertices = rule(self.face.skin.positions, self.vertex_upper, self.vertex_away)
        skin = slice(self.first, None)
        return np.concatenate(
            [carried_points(self.face, vertices), rule(self.rest[skin], self.upper[skin], self.away[skin])]
        )


Rule = Callable[[FloatArray, BoolArray, FloatArray], FloatArray]


def drawn_slit(face: Face, display: DisplaySurface, slit: Slit) -> DrawnSlit | None:
    """A slit between skin vertices as it is drawn; none if it is not where skin moves."""
    number = points_of_vertices(face, display)
    right, left = (int(number[corner]) for corner in slit.corners)
    loops = (np.array(loop, dtype=np.int64) for loop in igl.boundary_loop_all(display.triangles))
    found = (split_loop(loop, right, left, display.points) for loop in loops)
    edges = next((each for each in found if each is not None), None)
    if edges is None or max(edges.upper.max(), edges.lower.max()) >= display.moving:
        return None
    skin, moving = face.skin, slice(0, display.moving)
    vertex_upper = on_upper_side(skin, slit, BESIDE_CORNER)
    corners = skin.triangles[display.elements[moving]]
    share = np.einsum("pk,pk->p", display.barycentric[moving], vertex_upper[corners].astype(np.float64))
    carried = carried_points(face, vertex_upper[:, None].astype(np.float64))[:, 0]
    parts = [part.mesh.positions for part in face.parts if part.carrier == "skin"]
    rest = np.concatenate([*parts, display.points[moving].astype(np.float64)])
    upper = np.concatenate([carried, share]) > HALF
    chains = skin.positions[slit.upper], skin.positions[slit.lower]
    away = _distance(rest, upper, chains)
    vertex_away = _distance(skin.positions, vertex_upper, chains)
    return DrawnSlit(face, rest, len(carried), edges, upper, away, vertex_upper, vertex_away)


BESIDE_CORNER = 3.0
"""Millimetres by which ways to both edges differ at most beside a corner that may lie deep, where one is cut short."""

HALF = 0.5
"""A point between vertices of both sides belongs to the one of which it has more."""


def _distance(points: FloatArray, upper: BoolArray, chains: tuple[FloatArray, FloatArray]) -> FloatArray:
    """How far (n,) points are from the edge of their own side, a chain of places for the upper and the lower one."""
    away = np.zeros(len(points))
    for mine, chain in ((upper, chains[0]), (~upper, chains[1])):
        steps: IntArray = np.stack([np.arange(len(chain) - 1), np.arange(1, len(chain))], axis=1)
        away[mine] = np.sqrt(igl.point_mesh_squared_distance(points[mine], chain, steps)[0])
    return away

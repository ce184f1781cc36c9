"""The default face with more vertices, or drawn with more points."""

from __future__ import annotations

from dataclasses import fields, replace
from functools import cache

import numpy as np

from facemodel.basis import Basis
from facemodel.display import DisplaySurface
from facemodel.face import Face, Layers
from facemodel.mesh import Mesh
from facemodel.projects import new_project
from facemodel.sampling import HeadSurface, display_surface, head_surface
from fem import HCT9, HCT12, Support, sample_operators
from fem.surface import edge_topology
from fem.types import FloatArray, IntArray

FIELDS = 50
"""As many as a basis of action units with sides has, and as the yardstick asks for."""


@cache
def default_face() -> Face:
    """The face that a first start shows."""
    return new_project().face


@cache
def _head() -> HeadSurface:
    return head_surface(default_face(), HCT9)


def drawn(density: int) -> DisplaySurface:
    """The default face as it is drawn with ``density`` segments per edge of an element."""
    return display_surface(default_face(), _head(), density)


def random_basis(display: DisplaySurface) -> Basis:
    """Fields without meaning on a drawn face; what they cost does not depend on their numbers."""
    rng = np.random.default_rng(0)
    points = sum(count for _, count in display.carried) + display.moving
    moved = np.empty((FIELDS, 3 * points), dtype=np.float32)
    slopes = np.empty((FIELDS, 6 * display.moving), dtype=np.float32)
    for row in range(FIELDS):
        moved[row] = rng.random(moved.shape[1], dtype=np.float32) * 0.02
        slopes[row] = rng.random(slopes.shape[1], dtype=np.float32) * 0.001
    return Basis(tuple(f"field {k}" for k in range(FIELDS)), display, moved, slopes, np.zeros((FIELDS, 3)))


def refined(face: Face, count: int) -> Face:
    """A face with ``count`` vertices at least, its longest edges halved on the smooth surface first.

    Vertices keep their numbers and new ones follow; chart and painted layers are interpolated.
    """
    triangles, elements, places = _bisected(face.skin, count)
    total = int(triangles.max()) + 1
    element, barycentric = np.empty(total, dtype=np.int64), np.empty((total, 3))
    element[triangles], barycentric[triangles] = elements[:, None], places
    corners = face.skin.triangles[element]

    def spread(painted: FloatArray) -> FloatArray:
        return np.asarray(np.einsum("pk,pk...->p...", barycentric, painted[corners]))

    head = head_surface(face, HCT12)
    positions = sample_operators(head.assembler, element, barycentric).value @ head.coefficients
    painted = {each.name: spread(getattr(face.layers, each.name)) for each in fields(Layers) if each.name != "supports"}
    return replace(
        face,
        skin=Mesh(positions, triangles),
        solved=face.solved[elements],
        uv=spread(face.uv),
        mirror=np.arange(total),
        chart=spread(face.chart),
        skull=replace(face.skull, anchors=spread(face.skull.anchors), jawbone=spread(face.skull.jawbone)),
        layers=replace(face.layers, **painted, supports=np.full(total, Support.FREE)),
    )


def _bisected(mesh: Mesh, count: int) -> tuple[IntArray, IntArray, FloatArray]:
    """Halve edges that are the longest of all triangles on them, round by round, up to ``count`` vertices.

    Returns
    -------
    triangles : (T, 3)
    elements : (T,) the triangle of the mesh that each lies in
    places : (T, 3, 3) barycentric coordinates in it of each corner
    """
    triangles, positions = mesh.triangles, mesh.positions
    elements, places = np.arange(len(triangles)), np.tile(np.eye(3), (len(triangles), 1, 1))
    while len(positions) < count:
        edges, of_triangle = edge_topology(triangles)
        length = np.linalg.norm(positions[edges[:, 0]] - positions[edges[:, 1]], axis=1)
        longest = of_triangle[np.arange(len(triangles)), length[of_triangle].argmax(axis=1)]
        wished = np.bincount(longest, minlength=len(edges)) == np.bincount(of_triangle.ravel(), minlength=len(edges))
        chosen = np.flatnonzero(wished)
        chosen = chosen[np.argsort(-length[chosen], kind="stable")][: count - len(positions)]
        middle = np.full(len(edges), -1)
        middle[chosen] = len(positions) + np.arange(len(chosen))
        positions = np.concatenate([positions, positions[edges[chosen]].mean(axis=1)])
        triangles, elements, places = _halved(triangles, elements, places, middle[of_triangle])
    return triangles, elements, places


def _halved(
    triangles: IntArray, elements: IntArray, places: FloatArray, middles: IntArray
) -> tuple[IntArray, IntArray, FloatArray]:
    """Cut triangles from the middle of an edge, (T, 3) vertex or -1 with edge k opposite corner k, to its corner."""
    cut = np.flatnonzero((middles >= 0).any(axis=1))
    top = middles[cut].argmax(axis=1)
    left, right = (top + 1) % 3, (top + 2) % 3
    middle = places[cut, left] / 2 + places[cut, right] / 2
    halves = []
    for replaced in (right, left):
        corners, place = triangles[cut].copy(), places[cut].copy()
        rows = np.arange(len(cut))
        corners[rows, replaced], place[rows, replaced] = middles[cut, top], middle
        halves.append((corners, elements[cut], place))
    whole = np.delete(np.arange(len(triangles)), cut)
    kept = (triangles[whole], elements[whole], places[whole])
    return tuple(np.concatenate(pieces) for pieces in zip(kept, *halves, strict=True))  # type: ignore[return-value]

"""Sample the element's own smooth surface of a face for drawing."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import numpy as np

from facemodel.display import DisplaySurface
from facemodel.face import Face
from facemodel.mesh import submesh
from fem import (
    HCT9,
    HCT12,
    Assembler,
    ChartedSurface,
    Element,
    SampleOperators,
    interpolate_smoothly,
    sample_operators,
    subdivide,
)
from fem.types import FloatArray, IntArray

ELEMENTS: dict[str, Element] = {"hct9": HCT9, "hct12": HCT12}

MEMBRANE = 0.02
"""1/mm^2, weight of the slopes against the curvatures of the neutral surface: thin-plate splines overshoot at the
tight folds of lips and ears, and a membrane of seven millimetres' reach calms them without flattening cheeks."""


@dataclass(frozen=True, eq=False)
class HeadSurface:
    """The smooth surface of a whole head: the thin plate of the element through the skin's vertices.

    Attributes
    ----------
    assembler : of all triangles of the skin
    coefficients : (n_dofs, 3) of the surface in the element
    """

    assembler: Assembler
    coefficients: FloatArray


@dataclass(frozen=True, eq=False)
class SolvedRegion:
    """The part of the skin that the finite elements move.

    Attributes
    ----------
    assembler : of the solved triangles, bending measured on the head's smooth surface
    vertices : (n,) skin vertex of each of its vertices
    dofs : (n_dofs,) degree of freedom of the head of each of its degrees of freedom
    """

    assembler: Assembler
    vertices: IntArray
    dofs: IntArray


def head_surface(face: Face, element: Element) -> HeadSurface:
    """The smooth surface of a face, solved part and held rest in one, so that they join with the same tangents."""
    assembler = Assembler(ChartedSurface(face.skin.positions, face.skin.triangles, face.chart), element)
    return HeadSurface(assembler, interpolate_smoothly(assembler, face.skin.positions, MEMBRANE))


def solved_region(face: Face, head: HeadSurface) -> SolvedRegion:
    """The solved triangles of a face as a charted surface of their own."""
    mesh, vertices = submesh(face.skin, face.solved)
    surface = ChartedSurface(mesh.positions, mesh.triangles, face.chart[vertices])
    assembler = Assembler(surface, head.assembler.element)
    rows = (3 * vertices[:, None] + np.arange(3)).ravel()
    if assembler.element.dofs_per_edge:
        count = len(face.skin.positions)
        whole, part = head.assembler.surface.edges, vertices[surface.edges]
        edge = np.searchsorted(whole[:, 0] * count + whole[:, 1], part[:, 0] * count + part[:, 1])
        rows = np.concatenate([rows, 3 * count + edge])
    return SolvedRegion(assembler.on_smooth_surface(head.coefficients[rows]), vertices, rows)


def display_surface(face: Face, head: HeadSurface, density: int) -> DisplaySurface:
    """Sample the smooth surface of a head, ``density`` segments per edge of an element."""
    grid = subdivide(face.skin.triangles, density)
    moving = face.solved[grid.elements]
    order = np.argsort(~moving, kind="stable")
    number = np.empty_like(order)
    number[order] = np.arange(len(order))
    elements, barycentric = grid.elements[order], grid.barycentric[order]
    sample = sample_operators(head.assembler, elements, barycentric)
    d_u, d_v = sample.d_u @ head.coefficients, sample.d_v @ head.coefficients
    normals = np.cross(d_u, d_v)
    normals /= np.linalg.norm(normals, axis=1, keepdims=True)
    count = int(moving.sum())
    return DisplaySurface(
        points=(sample.value @ head.coefficients).astype(np.float32),
        normals=normals.astype(np.float32),
        slopes=np.concatenate([d_u[:count].T, d_v[:count].T]).astype(np.float32),
        triangles=number[grid.triangles],
        moving=count,
        elements=elements,
        barycentric=barycentric,
        density=density,
        carried=tuple((p.name, len(p.mesh.positions)) for p in face.parts if p.carrier == "skin"),
    )


def field_sampler(face: Face, display: DisplaySurface, region: SolvedRegion) -> SampleOperators:
    """Operators from the solved region's degrees of freedom to the moving points of the display."""
    number = np.cumsum(face.solved) - 1
    moving = slice(0, display.moving)
    return sample_operators(region.assembler, number[display.elements[moving]], display.barycentric[moving])


def carried_points(face: Face, vertex_fields: FloatArray) -> FloatArray:
    """Displacements (C, k) of the points of all carried parts from those of the skin vertices (N, k)."""
    rows = [
        np.einsum("pk,pkc->pc", part.shares, vertex_fields[part.anchors])
        for part in face.parts
        if part.carrier == "skin"
    ]
    return np.concatenate(rows) if rows else np.zeros((0, vertex_fields.shape[1]))


@lru_cache(maxsize=2)
def points_of_vertices(face: Face, display: DisplaySurface) -> IntArray:
    """The drawn point (N,) that lies on each skin vertex; to be read only, for it is remembered."""
    corner = display.barycentric.argmax(axis=1)
    on = np.flatnonzero(display.barycentric.max(axis=1) > 1 - 1e-6)
    found = np.full(len(face.skin.positions), -1, dtype=np.int64)
    found[face.skin.triangles[display.elements[on], corner[on]]] = on
    return found

"""The drawn surface: the smooth element surface of the skin, sampled."""

from __future__ import annotations

from dataclasses import dataclass

from fem.types import Float32Array, FloatArray, IntArray


@dataclass(frozen=True, eq=False)
class DisplaySurface:
    """Points sampled on every element of the skin, moving ones first.

    Attributes
    ----------
    points : (P, 3) float32, the skin at rest, millimetres
    normals : (P, 3) float32, analytic unit normals at rest
    slopes : (6, S) float32, the rows x, y, z of d/du and of d/dv of the S moving points at rest
    triangles : (F, 3) int64
    moving : S, the first S points lie on solved elements
    elements : (P,) int, the skin triangle of each point
    barycentric : (P, 3) float, where in it
    density : segments into which each edge of an element is cut
    carried : name and number of points of each part that the skin carries
    """

    points: Float32Array
    normals: Float32Array
    slopes: Float32Array
    triangles: IntArray
    moving: int
    elements: IntArray
    barycentric: FloatArray
    density: int
    carried: tuple[tuple[str, int], ...]

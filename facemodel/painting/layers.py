"""The layers of a face that can be painted: what they are called, their units and ranges, and how they are changed."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Any, Literal

import numpy as np
from numpy.typing import NDArray

from facemodel.face import Face
from facemodel.painting.delta import LayerDelta, Member, layer_delta
from facemodel.painting.frames import angle_of, direction_at, doubled, line_at, tangent_frames, wrapped
from facemodel.painting.geodesic import SurfacePoint
from facemodel.tissue import bone_depth
from fem import Support
from fem.types import FloatArray, IntArray

Kind = Literal["amount", "angle", "choice"]


@dataclass(frozen=True)
class PaintLayer:
    """One number per skin vertex that a brush can paint.

    Attributes
    ----------
    key : its name in code and files
    title : what people read
    unit : of its values; empty for a choice
    kind : an ``amount`` is added to and scaled, an ``angle`` is turned and combed, a ``choice`` is set
    low, high : what can be painted
    default : on a face that nobody has painted
    reason : why the range is as it is
    member, column : where its values are kept in `facemodel.face.Layers`
    automatic : values (N,) that hold where nobody painted, which is kept as 0; without it the default does
    typical : an ordinary value where the default is nothing at all; none where the default is one
    """

    key: str
    title: str
    unit: str
    kind: Kind
    low: float
    high: float
    default: float
    reason: str
    member: Member
    column: int | None = None
    automatic: Callable[[Face], FloatArray] | None = None
    typical: float | None = None

    def values(self, face: Face) -> FloatArray:
        """Its values (N,), in its unit; an array of their own."""
        stored: NDArray[Any] = getattr(face.layers, self.member)
        if self.kind == "angle":
            return angle_of(doubled(stored, tangent_frames(face.skin.normals)))
        if self.automatic is not None:
            return np.where(stored > 0, stored, self.unpainted(face))
        return np.array(stored if self.column is None else stored[:, self.column], dtype=np.float64)

    def unpainted(self, face: Face) -> FloatArray:
        """The values (N,) of a face that nobody has painted."""
        if self.automatic is not None:
            return np.clip(self.automatic(face), self.low, self.high)
        return np.full(len(face.skin.positions), float(self.default))

    def picked(self, face: Face, point: SurfacePoint) -> float:
        """Its value at a point of the skin, to paint with."""
        corners = face.skin.triangles[point.triangle]
        values, share = self.values(face)[corners], point.barycentric
        if self.kind == "angle":
            return float(angle_of(share @ line_at(values)[:, None])[0])
        return float(values[share.argmax()] if self.kind == "choice" else share @ values)

    def delta(self, face: Face, vertices: IntArray, values: FloatArray) -> LayerDelta:
        """The change that gives some vertices (k,) other values (k,), which are put into the range."""
        rows = getattr(face.layers, self.member)[vertices]
        fitting = self.fitting(values)
        if self.kind == "angle":
            frames = tangent_frames(face.skin.normals[vertices])
            other = fitting != angle_of(doubled(rows, frames))
            rows[other] = direction_at(fitting, frames)[other]
        elif self.automatic is not None:
            rows[:] = np.where(fitting == self.unpainted(face)[vertices], 0.0, fitting)
        elif self.column is None:
            rows[:] = fitting
        else:
            rows[:, self.column] = fitting
        return layer_delta(face.layers, self.member, vertices, rows)

    def fitting(self, values: FloatArray) -> FloatArray:
        """Values put into the range: angles by half turns, choices to the nearest one."""
        if self.kind == "angle":
            return wrapped(values)
        clipped = np.clip(values, self.low, self.high)
        return np.rint(clipped) if self.kind == "choice" else clipped


STIFF_SKIN = "at most a skin of 2 mm and 1 MPa, the stiff end of what is measured; below zero it would pull by itself"
THICK_SKIN = "at most a skin of 5 mm and 1 MPa (E t^3 / 12); below zero it would buckle by itself"
DEEP_TISSUE = (
    "at most a full cheek; tissue of no thickness would be infinitely stiff. Where nobody paints, it is as thick as "
    "the bone is deep. How thick the skin itself is, stretching and bending tell"
)
SLIDING_TISSUE = (
    "from tissue that is as stiff along the surface as across it to skin that slides over bone all but freely; 70 to "
    "95 % of the motion of scanned faces is along the surface"
)
FULL_TISSUE = (
    "where it is ten times the tissue stiffness and more, what is squeezed bulges and its volume stays; more of it "
    "only costs accuracy"
)
FIRM_TISSUE = "at most cartilage of 1 MPa over a centimetre; below zero it would push off the bone"

PAINT_LAYERS: tuple[PaintLayer, ...] = (
    PaintLayer(
        "stretching-along", "Stretching along the grain", "N/mm", "amount", 0, 2, 0.168, STIFF_SKIN, "stretching", 0
    ),
    PaintLayer(
        "stretching-across", "Stretching across the grain", "N/mm", "amount", 0, 2, 0.168, STIFF_SKIN, "stretching", 1
    ),
    PaintLayer("grain", "Grain", "°", "angle", -90, 90, 0, "a line turned by 180° is the same line", "direction"),
    PaintLayer("bending-along", "Bending along the grain", "N mm", "amount", 0, 10, 0.2, THICK_SKIN, "bending", 0),
    PaintLayer("bending-across", "Bending across the grain", "N mm", "amount", 0, 10, 0.2, THICK_SKIN, "bending", 1),
    PaintLayer("bending-twist", "Twisting", "N mm", "amount", 0, 10, 0.2, THICK_SKIN, "bending", 2),
    PaintLayer("stiffness", "Tissue stiffness", "N/mm³", "amount", 0, 0.1, 0.0016, FIRM_TISSUE, "stiffness"),
    PaintLayer(
        "thickness", "Tissue thickness", "mm", "amount", 0.2, 60, 8, DEEP_TISSUE, "thickness", automatic=bone_depth
    ),
    PaintLayer("sliding", "Sliding over bone", "", "amount", 1, 200, 7.28, SLIDING_TISSUE, "sliding"),
    PaintLayer("volume", "Volume stiffness", "N/mm³", "amount", 0, 0.5, 0, FULL_TISSUE, "volume", typical=0.012),
    PaintLayer(
        "supports", "Supports", "", "choice", 0, len(Support) - 1, 0, "each number is one kind of support", "supports"
    ),
)
"""All layers, in the order in which they are listed."""

LAYER: Mapping[str, PaintLayer] = {layer.key: layer for layer in PAINT_LAYERS}
"""The layers by key."""

SUPPORT_TITLES: Mapping[Support, str] = {
    Support.FREE: "Free",
    Support.VALUE: "Held in place",
    Support.CLAMPED: "Held in place and slope",
    Support.SLIDING: "Sliding along the surface",
}
"""What the choices of the supports are called."""

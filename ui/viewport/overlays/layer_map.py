"""How the values of a layer become colours: the range, the map, and what is covered.  Pure."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from facemodel.display import DisplaySurface
from facemodel.face import Face
from facemodel.painting.frames import angle_of, line_at
from facemodel.painting.layers import SUPPORT_TITLES, PaintLayer
from fem import Support
from fem.types import FloatArray, IntArray
from ui.viewport.colour_map import cividis
from ui.viewport.look import at_points

CHOICES: dict[Support, tuple[float, float, float]] = {
    Support.FREE: (0.62, 0.62, 0.64),
    Support.VALUE: (0.353, 0.694, 0.941),
    Support.CLAMPED: (0.910, 0.725, 0.286),
    Support.SLIDING: (0.800, 0.400, 0.640),
}
"""Colours of the supports, told apart by every kind of eye (after Okabe and Ito 2008)."""

ROUND = np.array([1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0, 6.0, 8.0, 10.0])
"""Leading figures of a range's end that are easily read."""

SEVERAL = 4.0
"""The map ends at so many times the middle value: cartilage is ten times as stiff as a cheek, and on a map up to it all
cheeks would look alike."""

CYCLE = np.array(
    [(0.839, 0.541, 0.278), (0.255, 0.235, 0.240), (0.263, 0.404, 0.737), (0.855, 0.855, 0.865), (0.839, 0.541, 0.278)]
)
"""Orange, dark, blue, pale and back, with blue for what is level: angles that are a quarter turn apart differ in
lightness or in blue and yellow, which every kind of eye tells apart."""


@dataclass(frozen=True)
class Band:
    """One entry of a legend of choices: what it is called and its colour."""

    title: str
    colour: tuple[float, float, float]


@dataclass(frozen=True)
class LayerMap:
    """The map of one layer.

    Attributes
    ----------
    layer : what is shown
    low, high : values at the ends of the map
    beyond : whether there are values above it, which have the last colour
    """

    layer: PaintLayer
    low: float
    high: float
    beyond: bool = False

    def colours(self, values: FloatArray) -> FloatArray:
        """Colours (n, 3) of values (n,)."""
        if self.layer.kind == "choice":
            table = np.array([CHOICES[kind] for kind in Support])
            return np.asarray(table[np.rint(values).astype(np.int64)])
        share = (values - self.low) / (self.high - self.low)
        if self.layer.kind == "angle":
            at = np.linspace(0, 1, len(CYCLE))
            return np.stack([np.interp(share, at, CYCLE[:, k]) for k in range(3)], axis=-1)
        return cividis(share)

    def covers(self, values: FloatArray) -> FloatArray:
        """How much (n,) of the skin the map covers, 0 to 1: what is free of support stays bare."""
        if self.layer.kind == "choice":
            return np.where(np.rint(values) == int(Support.FREE), 0.0, 1.0)
        return np.ones(len(values))

    @property
    def bands(self) -> tuple[Band, ...]:
        """The entries of a legend of choices; free skin is bare and needs none."""
        return tuple(Band(SUPPORT_TITLES[kind], CHOICES[kind]) for kind in Support if kind is not Support.FREE)


def layer_map(layer: PaintLayer, values: FloatArray, also: float) -> LayerMap:
    """The map for values (N,) of a layer and for another one that is about to be painted."""
    if layer.kind != "amount":
        return LayerMap(layer, layer.low, layer.high)
    most = float(values.max(initial=0.0))
    usual = SEVERAL * float(np.median(values)) if len(values) else 0.0
    top = readable(max(min(most, usual), also, layer.high * 1e-3))
    return LayerMap(layer, 0.0, top, most > top)


def readable(top: float) -> float:
    """The smallest easily read number that is not below a positive one."""
    scale = 10.0 ** np.floor(np.log10(top))
    return float(scale * ROUND[np.searchsorted(ROUND, top / scale * (1 - 1e-9))])


def at_drawn(layer: PaintLayer, face: Face, display: DisplaySurface, values: FloatArray) -> FloatArray:
    """Values (N,) of the vertices at all drawn points (P,)."""
    if layer.kind == "amount":
        return at_points(face, display, values)
    return at_some(layer, face, display, values, np.arange(len(display.points)))


def at_some(layer: PaintLayer, face: Face, display: DisplaySurface, values: FloatArray, points: IntArray) -> FloatArray:
    """Values (N,) of the vertices at some drawn points (n,): amounts in between, angles as lines, choices nearest."""
    corners = face.skin.triangles[display.elements[points]]
    shares = display.barycentric[points]
    if layer.kind == "choice":
        return np.asarray(values[corners[np.arange(len(points)), shares.argmax(axis=1)]])
    if layer.kind == "angle":
        return angle_of(np.einsum("pk,pk->p", shares, line_at(values)[corners]))
    return np.asarray(np.einsum("pk,pk->p", shares, values[corners]))

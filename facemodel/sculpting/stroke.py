"""One stroke of a sculpting brush over a posed face: what it adds to the corrections of the fields that pose it."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field

import numpy as np

from facemodel.mesh import Mesh
from facemodel.painting.brush import falloff
from facemodel.painting.geodesic import SurfacePoint
from facemodel.painting.smoothing import STEPS
from facemodel.painting.surface import PaintSurface
from facemodel.painting.sweep import STRIDE, Reached, Tip, swept
from facemodel.sculpting.brush import PINCHED, RAISED, SculptBrush
from facemodel.sculpting.correction import FARTHEST, Correction, correction_of
from fem.types import BoolArray, FloatArray, IntArray

SHARPNESS = 4
"""Power by which the nearer of a stroke and its mirror image prevails; both together stay smooth at the midline."""

LEAST_GRIP = 0.25
"""Share of the hand's way that the place under it has to go at least, before the brush is made stronger there: below it
the brush lies between the vertices of a coarse mesh and would throw them far."""

MIRROR = np.array([-1.0, 1.0, 1.0])


@dataclass(frozen=True, eq=False)
class Layer:
    """The correction of one field as a stroke begins.

    Attributes
    ----------
    correction : what there is
    solved : (N, 3) the field without it at activation 1, millimetres
    weight : the field's weight in what is seen, above 0
    share : (N,) the part of what is sculpted that this field takes
    """

    correction: Correction
    solved: FloatArray
    weight: float
    share: FloatArray


@dataclass(frozen=True, eq=False)
class Moved:
    """What a stroke has just done: vertices (k,), and how far (k, 3) the posed skin went there since before."""

    vertices: IntArray
    by: FloatArray


@dataclass(frozen=True, eq=False)
class Sculpted:
    """What a stroke works on.

    Attributes
    ----------
    surface : the skin at rest, on which distances are measured
    posed : (N, 3) the skin's vertices as they are seen, millimetres
    layers : by field name
    movable : (N,) the vertices that a hand can move
    partners : (N,) vertex across the midline or -1, to sculpt both sides alike
    """

    surface: PaintSurface
    posed: FloatArray
    layers: Mapping[str, Layer]
    movable: BoolArray
    partners: IntArray | None = None


@dataclass(eq=False)
class _Trail:
    """Weights (N,) of a brush where it was, and the way (N, 3) that it asks of every vertex."""

    weights: FloatArray
    ways: FloatArray = field(default_factory=lambda: np.zeros((0, 3)))


class SculptStroke:
    """A stroke from press to release.

    What counts for a vertex is the largest weight that the brush has given it: a slow stroke does no more than a quick
    one, and going over a place again does nothing new before the next stroke.

    Parameters
    ----------
    work : what it works on
    brush : what does it
    """

    def __init__(self, work: Sculpted, brush: SculptBrush) -> None:
        self.brush = brush
        self._work = work
        count = len(work.posed)
        self._trail = _Trail(np.zeros(count), np.zeros((count, 3)))
        self._tip: Tip | None = None
        self._normals = Mesh(work.posed, work.surface.mesh.triangles).normals
        self._before = {name: layer.correction.everywhere(count) for name, layer in work.layers.items()}
        self._targets = {name: self._target(name) for name in work.layers}
        self._after = dict(self._before)
        self._pressure = 1.0

    def take(self, point: SurfacePoint, shares: FloatArray) -> None:
        """Take hold of a place, to pull it.

        Parameters
        ----------
        point : where the hand takes hold
        shares : (N,) how far that place goes with each vertex, see `CorrectionSampler.shares_at`
        """
        self._tip = Tip(self._work.surface.geodesics, point, self.brush.radius)
        reached = self._tip.reached()
        weights = np.zeros_like(self._trail.weights)
        weights[reached.vertices] = falloff(reached.distances, self.brush.radius, self.brush.hardness)
        weights[~self._work.movable] = 0.0
        corners = self._work.surface.mesh.triangles[point.triangle]
        if shares @ weights < LEAST_GRIP:
            weights[corners] = np.where(self._work.movable[corners], np.maximum(weights[corners], point.barycentric), 0)
        grip = float(shares @ weights)
        self._trail.weights = weights * self.brush.strength / max(grip, LEAST_GRIP)

    def pull(self, way: FloatArray) -> Moved:
        """Pull what was taken hold of to a way (3,) off where it was, millimetres as it is seen."""
        self._trail.ways = self._trail.weights[:, None] * way
        return self._settle()

    def extend(self, point: SurfacePoint, pressure: float = 1.0) -> Moved:
        """Move the brush on to a place of the skin; a pen's pressure (0 to 1) changes evenly along the way."""
        if self._tip is None:
            self._tip = Tip(self._work.surface.geodesics, point, self.brush.radius)
            self._press(self._tip.reached(), pressure, self._tip, self._tip)
        else:
            way = self._work.surface.path.between(self._tip.point, point, STRIDE * self.brush.radius)
            for number, stop in enumerate(way, start=1):
                share = number / len(way)
                start, self._tip = self._tip, Tip(self._work.surface.geodesics, stop, self.brush.radius)
                reached = swept(start, self._tip)
                self._press(reached, (1 - share) * self._pressure + share * pressure, start, self._tip)
        self._pressure = pressure
        return self._settle()

    def lift(self) -> None:
        """Take the brush off the skin: the next place begins a new line of the same stroke."""
        self._tip = None

    @property
    def corrections(self) -> dict[str, Correction]:
        """The corrections that there are now, by field; those that the stroke has not changed are the same objects."""
        return {
            name: layer.correction
            if np.array_equal(self._after[name], self._before[name])
            else correction_of(self._after[name], layer.correction)
            for name, layer in self._work.layers.items()
        }

    def _target(self, name: str) -> FloatArray:
        """What (N, 3) a stroke of full strength adds to a correction by itself: nothing but to smooth or to erase."""
        layer, before = self._work.layers[name], self._before[name]
        if self.brush.mode == "erase":
            return -before
        if self.brush.mode != "smooth":
            return np.zeros_like(before)
        total = layer.solved + layer.correction.share * before
        even = total
        for _ in range(STEPS):
            even = self._work.surface.smoothing @ even
        return np.asarray((even - total) / layer.correction.share)

    def _press(self, reached: Reached, pressure: float, start: Tip, end: Tip) -> None:
        """Raise the weights of what is reached to what this piece of the way gives."""
        trail, near = self._trail, reached.vertices
        given = pressure * self.brush.strength * falloff(reached.distances, self.brush.radius, self.brush.hardness)
        stronger = given > trail.weights[near]
        near, given = near[stronger], given[stronger]
        trail.weights[near] = given
        if self.brush.mode == "raise":
            trail.ways[near] = self.brush.sign * RAISED * given[:, None] * self._normals[near]
        elif self.brush.mode == "pinch":
            trail.ways[near] = self.brush.sign * PINCHED * given[:, None] * self._inward(near, start, end)

    def _inward(self, near: IntArray, start: Tip, end: Tip) -> FloatArray:
        """Ways (k, 3) along the posed skin to the piece of path between two places of the brush."""
        a, b = (self._seen(tip) for tip in (start, end))
        away = self._work.posed[near] - a
        along = b - a
        share = np.clip(away @ along / max(float(along @ along), np.finfo(float).tiny), 0.0, 1.0)
        inward = share[:, None] * along - away
        normal = self._normals[near]
        return np.asarray(inward - np.einsum("ij,ij->i", inward, normal)[:, None] * normal)

    def _seen(self, tip: Tip) -> FloatArray:
        corners = self._work.surface.mesh.triangles[tip.point.triangle]
        return np.asarray(tip.point.barycentric @ self._work.posed[corners])

    def _settle(self) -> Moved:
        """Make the corrections what the trail asks for."""
        weights, ways = self._trail.weights, self._trail.ways
        if self._work.partners is not None:
            weights, ways = on_both_sides(weights, ways, self._work.partners)
        weights, ways = weights * self._work.movable, ways * self._work.movable[:, None]
        seen = np.zeros_like(ways)
        for name, layer in self._work.layers.items():
            felt = layer.weight * layer.correction.share
            own = weights[:, None] * self._targets[name] + ways * layer.share[:, None] / felt
            after = np.clip(self._before[name] + own, -FARTHEST, FARTHEST)
            seen += felt * (after - self._after[name])
            self._after[name] = after
        vertices = np.flatnonzero(seen.any(axis=1))
        return Moved(vertices, seen[vertices])


def on_both_sides(weights: FloatArray, ways: FloatArray, partners: IntArray) -> tuple[FloatArray, FloatArray]:
    """Weights (N,) and ways (N, 3) of a stroke and its mirror image together.

    Far from the midline each side has its own alone; between, the stronger prevails without a seam, and a vertex on
    the midline goes straight ahead.

    Parameters
    ----------
    partners : (N,) vertex across the midline, or -1
    """
    paired = partners >= 0
    across, image = np.zeros_like(weights), np.zeros_like(ways)
    across[paired] = weights[partners[paired]]
    image[paired] = ways[partners[paired]] * MIRROR
    most = np.maximum(weights, across)
    scale = np.where(most > 0, most, 1.0)
    one, other = (weights / scale) ** SHARPNESS, (across / scale) ** SHARPNESS
    both = np.maximum(one + other, np.finfo(float).tiny)
    return (one * weights + other * across) / both, (one[:, None] * ways + other[:, None] * image) / both[:, None]

"""A stroke of a brush from press to release: a sweep that never paints the same place twice."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np
from numpy.typing import NDArray

from facemodel.face import Face
from facemodel.painting.brush import Brush, check_mode, falloff, painted
from facemodel.painting.delta import LayerDelta
from facemodel.painting.frames import angle_of, doubled
from facemodel.painting.geodesic import SurfacePoint
from facemodel.painting.layers import PaintLayer
from facemodel.painting.smoothing import smoothed
from facemodel.painting.surface import PaintSurface
from facemodel.painting.sweep import STRIDE, Reached, Tip, swept
from fem.types import BoolArray, FloatArray, IntArray

UPRIGHT = 90.0
"""Degrees between a level and an upright line."""


@dataclass(frozen=True, eq=False)
class Touch:
    """What a stroke has changed just now: vertices (k,), and the values (k,) of the layer that they have now."""

    vertices: IntArray
    values: FloatArray


class Stroke:
    """One stroke on one layer.

    What counts for a vertex is the largest weight that the moving brush has given it: a slow stroke paints no more than
    a quick one, and going over a place again paints nothing new before the next stroke.

    Parameters
    ----------
    surface : the skin at rest
    face : as it is before the stroke
    layer, brush : what is painted with what
    partners : (N,) vertex across the midline or -1, to paint both sides alike; see `mirror.mirror_partners`
    locked : (N,) vertices that keep their value

    Raises
    ------
    PaintError
        If the layer does not know the brush's mode.
    """

    def __init__(
        self,
        surface: PaintSurface,
        face: Face,
        layer: PaintLayer,
        brush: Brush,
        partners: IntArray | None = None,
        locked: BoolArray | None = None,
    ) -> None:
        check_mode(layer, brush.mode)
        self.layer = layer
        # A choice is made or not made: there is no half of it.
        self.brush = replace(brush, hardness=1.0, strength=1.0) if layer.kind == "choice" else brush
        self._surface, self._face = surface, face
        self._partners, self._locked = partners, locked
        self._before = layer.values(face)
        self._target: FloatArray = np.full(len(self._before), brush.value)
        if brush.mode == "smooth":
            self._target = smoothed(layer.kind, self._before, surface.smoothing)
        elif brush.mode == "erase":
            self._target = layer.unpainted(face)
        self._weights: FloatArray = np.zeros(len(self._before))
        self._grain: NDArray[np.complex128] = np.zeros(len(self._before), dtype=np.complex128)
        self._tip: Tip | None = None
        self._pressure = 1.0

    def extend(self, point: SurfacePoint, pressure: float = 1.0) -> Touch:
        """Move on to a point of the skin.

        Parameters
        ----------
        point : where the brush is now
        pressure : 0 to 1 of a pen, multiplies the strength; it changes evenly along the way
        """
        weights = np.zeros_like(self._weights)
        grain = np.zeros_like(self._grain)
        if self._tip is None:
            self._tip = Tip(self._surface.geodesics, point, self.brush.radius)
            self._raise(weights, self._tip.reached(), pressure)
        else:
            way = self._surface.path.between(self._tip.point, point, STRIDE * self.brush.radius)
            for number, stop in enumerate(way, start=1):
                share = number / len(way)
                self._advance(stop, (1 - share) * self._pressure + share * pressure, weights, grain)
        self._pressure = pressure
        return self._taken(weights, grain)

    def lift(self) -> None:
        """Take the brush off the skin: the next point begins a new line of the same stroke."""
        self._tip = None

    def _advance(self, stop: SurfacePoint, pressure: float, weights: FloatArray, grain: NDArray[np.complex128]) -> None:
        assert self._tip is not None
        start, self._tip = self._tip, Tip(self._surface.geodesics, stop, self.brush.radius)
        reached = swept(start, self._tip)
        given = self._raise(weights, reached, pressure)
        if self.brush.mode == "comb":
            way = np.broadcast_to(self._tip.position - start.position, (len(reached.vertices), 3))
            # Doubling squares lengths; a step counts once for its own length however the way is cut into steps.
            lines = doubled(way, self._surface.frames.at(reached.vertices))
            size = np.sqrt(np.abs(lines))
            grain[reached.vertices] += given * np.divide(lines, size, out=np.zeros_like(lines), where=size > 0)

    def _raise(self, weights: FloatArray, reached: Reached, pressure: float) -> FloatArray:
        """Let the weights of what is reached be at least what this piece gives; returns that."""
        full = 1.0 if self.layer.kind == "choice" else pressure * self.brush.strength
        given = full * falloff(reached.distances, self.brush.radius, self.brush.hardness)
        weights[reached.vertices] = np.maximum(weights[reached.vertices], given)
        return given

    def _taken(self, weights: FloatArray, grain: NDArray[np.complex128]) -> Touch:
        """Add what a move has given, on both sides if they are mirrored and nowhere where it is locked."""
        mirrored = np.zeros(len(weights), dtype=np.bool_)
        if self._partners is not None:
            weights, grain, mirrored = both_sides(weights, grain, self._partners)
        if self._locked is not None:
            weights[self._locked], grain[self._locked] = 0.0, 0.0
        raised = weights > self._weights
        self._weights[raised] = weights[raised]
        self._grain += grain
        if self.layer.kind == "angle" and self.brush.mode in ("set", "add"):
            self._target[raised] = np.where(mirrored[raised], -self.brush.value, self.brush.value)
        touched = np.flatnonzero(raised | (grain != 0))
        return Touch(touched, self._values(touched))

    def _values(self, vertices: IntArray) -> FloatArray:
        weights, target = self._weights[vertices], self._target[vertices]
        if self.brush.mode == "comb":
            grain = self._grain[vertices]
            target, weights = angle_of(grain), np.where(grain != 0, weights, 0.0)
        values = painted(self.layer.kind, self.brush.mode, self._before[vertices], weights, target)
        if self.layer.kind == "angle" and self._partners is not None:
            # A line on the midline is its own mirror image only if it lies level or upright.
            middle = self._partners[vertices] == vertices
            values[middle] = UPRIGHT * np.rint(values[middle] / UPRIGHT)
        return self.layer.fitting(values)

    def delta(self) -> LayerDelta:
        """What the stroke has changed so far, as one step to do and undo."""
        touched = np.flatnonzero(self._weights)
        return self.layer.delta(self._face, touched, self._values(touched))


def both_sides(
    weights: FloatArray, grain: NDArray[np.complex128], partners: IntArray
) -> tuple[FloatArray, NDArray[np.complex128], BoolArray]:
    """Weights and lines of a stroke and its mirror image together, and where the image is the stronger one.

    Parameters
    ----------
    weights, grain : (N,) of the stroke alone
    partners : (N,) vertex across the midline, or -1
    """
    paired = partners >= 0
    across, lines = np.zeros_like(weights), np.zeros_like(grain)
    across[paired] = weights[partners[paired]]
    # A mirrored line has the negative angle.
    lines[paired] = np.conj(grain[partners[paired]])
    return np.maximum(weights, across), grain + lines, across > weights

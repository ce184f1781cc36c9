"""A brush, and what it does to values: pure functions of values, weights and the brush."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal

import numpy as np

from facemodel.errors import PaintError
from facemodel.painting.frames import turned
from facemodel.painting.layers import Kind, PaintLayer
from facemodel.smooth import smooth_step
from fem.types import FloatArray

Mode = Literal["set", "add", "scale", "smooth", "comb", "erase"]

MODES: Mapping[Kind, tuple[Mode, ...]] = {
    "amount": ("set", "add", "scale", "smooth", "erase"),
    "angle": ("comb", "set", "add", "smooth", "erase"),
    "choice": ("set", "erase"),
}
"""What a brush can do to each kind of layer, the most usual first."""

LARGEST_RADIUS = 100.0
"""Millimetres; a brush of that size holds half a face."""


@dataclass(frozen=True)
class Brush:
    """A round brush on the skin.

    Attributes
    ----------
    radius : geodesic, millimetres
    strength : 0 to 1, the share of the effect in the middle
    hardness : 0 to 1, the part of the radius over which the effect is the same before it fades
    mode : ``set`` the value, ``add`` it, ``scale`` by it, ``smooth`` what is there, ``comb`` the grain along the
        stroke, ``erase`` what was painted
    value : in the layer's unit; the factor of ``scale``; smoothing, combing and erasing need none

    Raises
    ------
    PaintError
        If a number is outside its range.
    """

    radius: float
    strength: float = 1.0
    hardness: float = 0.0
    mode: Mode = "set"
    value: float = 0.0

    def __post_init__(self) -> None:
        if not 0 < self.radius <= LARGEST_RADIUS:
            raise PaintError(
                f"A brush of {self.radius:g} mm is not possible; choose a radius above 0 and up to "
                f"{LARGEST_RADIUS:g} mm."
            )
        for name in ("strength", "hardness"):
            if not 0 <= getattr(self, name) <= 1:
                raise PaintError(f"A {name} of {getattr(self, name):g} is not possible; choose one from 0 to 1.")
        if not np.isfinite(self.value) or (self.mode == "scale" and self.value < 0):
            raise PaintError(f"The value {self.value:g} cannot be painted; choose a number, for a factor from 0 on.")


def check_mode(layer: PaintLayer, mode: Mode) -> None:
    """Refuse what a layer does not know.

    Raises
    ------
    PaintError
        If the mode does nothing that makes sense on this kind of layer.
    """
    if mode not in MODES[layer.kind]:
        known = ", ".join(MODES[layer.kind])
        raise PaintError(f"The layer “{layer.title}” knows no “{mode}”; choose one of {known}.")


def falloff(distances: FloatArray, radius: float, hardness: float) -> FloatArray:
    """Weight of a brush of full strength: 1 up to ``hardness`` of the radius, 0 from the radius on, smooth between."""
    inner = hardness * radius
    if inner >= radius:
        return (distances <= radius).astype(np.float64)
    return smooth_step((radius - distances) / (radius - inner))


def painted(kind: Kind, mode: Mode, before: FloatArray, weights: FloatArray, target: FloatArray) -> FloatArray:
    """Values after a brush has gone over them; of weight 0 they stay to the last bit, of weight 1 take all of it.

    Parameters
    ----------
    kind : of the layer
    mode : of the brush
    before : (k,) values before the stroke
    weights : (k,) from 0 to 1
    target : (k,) the brush's value, or what ``smooth``, ``comb`` and ``erase`` lead to
    """
    if kind == "choice":
        return np.where(weights > 0, target, before)
    if mode == "add":
        return before + weights * target
    if mode == "scale":
        return np.asarray(before * target**weights)
    if kind == "angle":
        return np.where(weights > 0, turned(before, target, weights), before)
    return (1 - weights) * before + weights * target

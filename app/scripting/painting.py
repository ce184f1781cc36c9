"""Painting in scripts: ``paint("stiffness", 0.01, at="cheek_L", radius=15)``."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import Any

import numpy as np

from app.commands import paint_deltas
from app.scripting.desk import ScriptDesk
from facemodel.errors import PaintError, UnknownNameError
from facemodel.painting.brush import Brush, Mode
from facemodel.painting.geodesic import SurfacePoint
from facemodel.painting.layers import LAYER, SUPPORT_TITLES, PaintLayer
from facemodel.painting.regions import filled
from facemodel.painting.stroke import Stroke
from fem.types import FloatArray

Where = str | int | Sequence[float]
"""A place on the skin: the name of a landmark, the number of a vertex, or a point near it in millimetres."""


class Painter:
    """Reads and paints the layers of the face.

    Parameters
    ----------
    desk : what the script works on
    """

    def __init__(self, desk: ScriptDesk) -> None:
        self._desk = desk

    def values(self, layer: str) -> FloatArray:
        """The values (N,) of a layer at all skin vertices; a copy."""
        face = self._desk.project.face
        return np.array(paint_layer(layer).values(face))

    def set_values(self, layer: str, values: Iterable[float]) -> None:
        """Give all skin vertices other values (N,) of a layer; those out of range stop at its ends."""
        face, own = self._desk.project.face, paint_layer(layer)
        given = np.fromiter(values, dtype=np.float64)
        everywhere = np.arange(len(face.skin.positions))
        if given.shape != everywhere.shape or not np.isfinite(given).all():
            raise PaintError(f"“{layer}” takes {len(everywhere)} numbers, one for each vertex of the skin.")
        delta = own.delta(face, everywhere, given)
        self._desk.document.run(paint_deltas((delta,), f"Set {own.title.lower()}"))

    def paint(
        self,
        layer: str,
        value: float | str = 0.0,
        at: Where | None = None,
        to: Where | None = None,
        *,
        radius: float = 12.0,
        strength: float = 1.0,
        hardness: float = 0.5,
        mode: Mode = "set",
        mirror: bool = False,
    ) -> None:
        """Paint a layer about a place, or in a stroke from it to another one; the whole skin without a place.

        Parameters
        ----------
        layer : see `layers()`
        value : in its unit; of the supports also ``free``, ``value``, ``clamped`` or ``sliding``
        at, to : a landmark, a vertex or a point (x, y, z) in millimetres
        radius, strength, hardness, mode : of the brush, see `facemodel.painting.brush.Brush`
        mirror : paint the other side alike
        """
        own, face = paint_layer(layer), self._desk.project.face
        surface = self._desk.ground.surface(face)
        brush = Brush(radius, strength, hardness, mode, _number(own, value))
        if at is None:
            everywhere = np.ones(len(face.skin.positions), dtype=np.bool_)
            delta = filled(surface, face, own, brush, everywhere)
        else:
            partners = self._desk.ground.partners(face) if mirror else None
            stroke = Stroke(surface, face, own, brush, partners)
            for place in (at,) if to is None else (at, to):
                stroke.extend(self.on_skin(place))
            delta = stroke.delta()
        self._desk.document.run(paint_deltas((delta,), f"Paint {own.title.lower()}"))

    def layers(self) -> dict[str, str]:
        """Keys and titles of all layers."""
        return {key: f"{layer.title}, {layer.unit}" if layer.unit else layer.title for key, layer in LAYER.items()}

    def place(self, where: Where) -> FloatArray:
        """The point (3,) of a place, millimetres."""
        face = self._desk.project.face
        if isinstance(where, str):
            if where not in face.landmarks:
                raise UnknownNameError(f"There is no landmark “{where}”; this face has {', '.join(face.landmarks)}.")
            return np.array(face.skin.positions[face.landmarks[where]])
        if isinstance(where, int | np.integer):
            if not 0 <= where < len(face.skin.positions):
                raise UnknownNameError(f"There is no vertex {where}; the skin has {len(face.skin.positions)}.")
            return np.array(face.skin.positions[where])
        return _point(where)

    def on_skin(self, where: Where) -> SurfacePoint:
        """The place on the skin nearest to a place."""
        (found,) = self._desk.ground.surface(self._desk.project.face).path.nearest(self.place(where))
        return found


def paint_layer(key: str) -> PaintLayer:
    """The layer with a key.

    Raises
    ------
    UnknownNameError
        If there is none.
    """
    if key not in LAYER:
        raise UnknownNameError(f"There is no layer “{key}” to paint; choose one of {', '.join(LAYER)}.")
    return LAYER[key]


def _number(layer: PaintLayer, value: float | str) -> float:
    if not isinstance(value, str):
        return float(value)
    kinds = {kind.name.lower(): float(kind) for kind in SUPPORT_TITLES}
    if layer.kind != "choice" or value.lower() not in kinds:
        raise PaintError(f"“{value}” is no value of “{layer.title}”; the supports know {', '.join(kinds)}.")
    return kinds[value.lower()]


def _point(where: Sequence[float]) -> FloatArray:
    point: Any = np.array(where, dtype=np.float64)
    if point.shape != (3,) or not np.isfinite(point).all():
        raise PaintError("A place is a landmark, a vertex or three numbers of millimetres.")
    return np.asarray(point)

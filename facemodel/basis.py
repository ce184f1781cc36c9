"""The basis: every displacement field of a face, sampled on what is drawn."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from facemodel.display import DisplaySurface
from facemodel.jaw.arc import JawArc
from fem.types import Float32Array, FloatArray


@dataclass(frozen=True, eq=False)
class Basis:
    """Displacement fields at activation 1 (design section 7).

    Attributes
    ----------
    names : M field names, for example ``12L``, ``12R``, ``17``
    display : the surface and the parts that the fields belong to
    fields : (M, 3 Q) float32, C order, millimetres; Q = the points of the parts that the skin carries, in the
        order of ``display.carried``, then the moving skin points
    slopes : (M, 6 S) float32, C order; rows x, y, z of d/du and of d/dv of the S moving skin points
    jaw : (M, 3) float64, opening in degrees, slide and shift to the left in millimetres, which move the parts that
        the jaw carries
    origin : ``solved``, ``sculpted`` or ``imported``
    arc : what lets the skin follow a turning jaw between the fields; none if that was not solved
    """

    names: tuple[str, ...]
    display: DisplaySurface
    fields: Float32Array
    slopes: Float32Array
    jaw: FloatArray
    origin: str = "solved"
    arc: JawArc | None = None

    @cached_property
    def index(self) -> dict[str, int]:
        """Row of each field by its name."""
        return {name: row for row, name in enumerate(self.names)}

    def field(self, name: str) -> Float32Array:
        """One field on the whole drawn skin (P, 3), zero where the skin is held; millimetres."""
        full = np.zeros((len(self.display.points), 3), dtype=np.float32)
        moving = self.display.moving
        full[:moving] = self.moving_field(name)
        return full

    def peak(self, name: str) -> float:
        """Largest displacement of the skin by one field, millimetres."""
        return float(np.linalg.norm(self.moving_field(name), axis=1).max())

    def moving_field(self, name: str) -> Float32Array:
        """One field on the moving skin points (S, 3), a view; millimetres."""
        row = self.fields[self.index[name]]
        start = len(row) - 3 * self.display.moving
        return np.asarray(row[start:].reshape(-1, 3))

    def carried_field(self, name: str, part: str) -> Float32Array:
        """One field on the points (n, 3) of a part that the skin carries, a view; millimetres."""
        start = 0
        for carried, count in self.display.carried:
            if carried == part:
                return self.fields[self.index[name], 3 * start : 3 * (start + count)].reshape(-1, 3)
            start += count
        raise KeyError(part)

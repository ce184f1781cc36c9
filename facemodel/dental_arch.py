"""Where the teeth of a face stand: cutting edges and roots along a row, and how wide and high each crown is."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import Literal, NamedTuple

import numpy as np
from scipy.interpolate import PchipInterpolator

from facemodel.face import Part
from facemodel.mesh import Mesh
from fem.types import FloatArray

RowName = Literal["upper", "lower"]

WIDTHS: Mapping[RowName, tuple[float, ...]] = {
    "upper": (8.6, 6.6, 7.7, 7.0, 6.8, 10.2, 9.6),
    "lower": (5.4, 5.9, 6.9, 7.0, 7.1, 11.0, 10.4),
}
"""Widths of the crowns in millimetres from the midline backwards (Wheeler's table)."""

HEIGHTS: Mapping[RowName, tuple[float, ...]] = {
    "upper": (10.4, 9.0, 10.0, 8.6, 8.2, 7.4, 7.0),
    "lower": (8.8, 9.0, 10.0, 8.6, 8.0, 7.4, 7.0),
}
"""Heights of the crowns in millimetres."""

FEWEST = 8
"""Vertices inside a strip, of the cutting edge and between it and the root, from which an arch can be read."""


class Places(NamedTuple):
    """Places along a row, all (n, 3): the cutting edge, the end of the gum, and unit vectors out to the lips."""

    edge: FloatArray
    root: FloatArray
    outward: FloatArray


@dataclass(frozen=True, eq=False)
class DentalArch:
    """The lips' side of a row of teeth.

    Attributes
    ----------
    jaw : the row
    bounds : (8,) where along the cutting edge the teeth of one side begin and end, millimetres from the midline
    edge_at, root_at : of millimetres (n,) from the midline, below zero on the right side, places (n, 3)
    """

    jaw: RowName
    bounds: FloatArray
    edge_at: PchipInterpolator
    root_at: Callable[[FloatArray], FloatArray]

    def at(self, along: FloatArray) -> Places:
        """Places as many millimetres (n,) along the cutting edge."""
        edge, root = self.edge_at(along), self.root_at(along)
        outward = np.cross(self.edge_at.derivative()(along), edge - root)
        outward /= np.linalg.norm(outward, axis=1, keepdims=True)
        outward *= np.sign((outward * (edge - self.edge_at(self.edge_at.x).mean(axis=0))).sum())
        return Places(edge, root, outward)


def is_strip(part: Part) -> bool:
    """Whether a part is a strip over a whole row of teeth, out of which single teeth can be carved."""
    loops = part.mesh.boundary_loops
    return len(loops) == 1 and len(part.mesh.positions) - len(loops[0]) >= FEWEST


def dental_arch(part: Part) -> DentalArch:
    """The arch of a row of teeth that is a strip, see `is_strip`."""
    mesh = part.mesh
    jaw: RowName = "upper" if part.carrier == "skull" else "lower"
    edge_row, root_row = _rows(mesh, jaw)
    angle = _angle(edge_row, mesh)
    along = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(edge_row, axis=0), axis=1))])
    along -= along[-1] / 2
    angle_at = PchipInterpolator(along, angle)
    by_angle = PchipInterpolator(_angle(root_row, mesh), root_row)
    ends = by_angle.x[[0, -1]]
    bounds = np.concatenate([[0.0], np.cumsum(WIDTHS[jaw])])
    return DentalArch(
        jaw,
        bounds * min(1.0, along[-1] / bounds[-1]),
        PchipInterpolator(along, edge_row),
        lambda s: np.asarray(by_angle(np.clip(angle_at(s), *ends))),
    )


def _rows(mesh: Mesh, jaw: RowName) -> tuple[FloatArray, FloatArray]:
    """Cutting edge and root line of a strip of teeth, each from the right end over the front to the left end.

    The strip runs from the root over the lips' side to the cutting edge and up the tongue's side; so its boundary is
    the root line, the inner line and two ends, and the cutting edge is the row of its inside that is farther away.
    """
    loop = mesh.boundary_loops[-1]
    rim = mesh.positions[loop]
    ends = [int(np.where(side * rim[:, 0] > 0, rim[:, 2], np.inf).argmin()) for side in (1.0, -1.0)]
    first, last = min(ends), max(ends)
    chains = (rim[first : last + 1], np.concatenate([rim[last:], rim[: first + 1]]))
    root = max(chains, key=lambda chain: float(chain[:, 2].max()))
    inside = np.ones(len(mesh.positions), dtype=bool)
    inside[loop] = False
    inner = mesh.positions[inside]
    base = np.column_stack([np.ones(len(inner)), inner[:, 2]])
    off = inner[:, 1] - base @ np.linalg.lstsq(base, inner[:, 1], rcond=None)[0]
    edge = inner[off < 0 if jaw == "upper" else off > 0]
    return edge[np.argsort(_angle(edge, mesh))], _increasing(root, _angle(root, mesh))


def _angle(points: FloatArray, mesh: Mesh) -> FloatArray:
    """Angle of places about the middle of the arch, from the right end to the left end."""
    return np.asarray(np.arctan2(points[:, 0], points[:, 2] - mesh.positions[:, 2].min() + 10.0))


def _increasing(points: FloatArray, angle: FloatArray) -> FloatArray:
    """Points in the order of their angle, those of equal angle (the ends) left out but one."""
    order = np.argsort(angle)
    steps = np.diff(angle[order], prepend=-np.inf)
    return np.asarray(points[order[steps > 1e-3]])

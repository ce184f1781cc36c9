"""Teeth with a shape: fourteen crowns in a gum, laid along the arch that the face's own row of teeth describes."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from scipy.interpolate import PchipInterpolator

from facemodel.face import Part
from facemodel.mesh import Mesh
from facemodel.smooth import smooth
from fem.types import FloatArray
from ui.viewport.complexion import Colour
from ui.viewport.look import bytes_of
from ui.viewport.shading import TOOTH, apply
from ui.viewport.surface import Surface

WIDTHS = {"upper": (8.6, 6.6, 7.7, 7.0, 6.8, 10.2, 9.6), "lower": (5.4, 5.9, 6.9, 7.0, 7.1, 11.0, 10.4)}
"""Widths of the crowns in millimetres from the midline backwards (Wheeler's table)."""
HEIGHTS = {"upper": (10.4, 9.0, 10.0, 8.6, 8.2, 7.4, 7.0), "lower": (8.8, 9.0, 10.0, 8.6, 8.0, 7.4, 7.0)}
"""Heights of the crowns in millimetres."""
PAPILLA = 0.70
"""Height of the gum's tip between two teeth over that of the crowns beside it."""
ACROSS = np.sin(np.pi / 2 * np.linspace(-1, 1, 9))
"""Columns of a tooth, -1..1, close together where it meets its neighbour."""
FRONT = np.array([1.00, 0.90, 0.72, 0.48, 0.25, 0.10, 0.03])
"""Rows of a crown over its height, from just under the gum down to the cutting edge."""
BACK = np.array([0.0, 0.05, 0.35, 0.95])
"""Rows from the cutting edge up the tongue's side."""
THICK = 3.2
"""Millimetres from the lips' side to the tongue's side of a crown near its edge."""
FEWEST = 8
"""Vertices inside a strip, of the cutting edge and between it and the root, from which an arch can be read."""
CURVED = np.array([0.25, 0.25, 0.0, 0.15, 0.15, 0.10, 0.10])
"""How much shorter than the canines the other crowns end, millimetres."""

ENAMEL: Colour = (0.780, 0.735, 0.645)
NECK: Colour = (0.68, 0.58, 0.44)
GAP: Colour = (0.20, 0.12, 0.09)
GUM: Colour = (0.54, 0.25, 0.245)
DARKEST = 0.04
"""Openness of the hindmost tooth, where a row ends in the dark."""
LIT, UNLIT = 0.5, 4.2
"""Teeth from the midline, 0 the first and 5 the first molar, at which lips and cheeks begin to take the light, and have
taken it."""
INSIDE = 0.35
"""Openness of the tongue's side of a tooth."""
UNDER_LIP = 0.62
"""Openness of the gum and the necks, which lie under the lip while the edges are seen."""


@dataclass(frozen=True, eq=False)
class _Arch:
    """Columns along a row of teeth; all arrays have one row per column.

    Attributes
    ----------
    edge, root : (C, 3) the cutting edge and the end of the gum
    outward : (C, 3) unit vectors to the lips
    within : (C,) -1..1 across the tooth
    tooth : (C,) number of the tooth from the midline
    gum : (C,) height of the gum over the cutting edge, millimetres
    """

    edge: FloatArray
    root: FloatArray
    outward: FloatArray
    within: FloatArray
    tooth: FloatArray
    gum: FloatArray


def is_strip(part: Part) -> bool:
    """Whether a part is a strip over a whole row of teeth, out of which single teeth can be carved."""
    loops = part.mesh.boundary_loops
    return len(loops) == 1 and len(part.mesh.positions) - len(loops[0]) >= FEWEST


def row_of_teeth(part: Part) -> Surface:
    """A row of teeth and its gum in the place of a part, at rest."""
    arch = _arch(part.mesh, "upper" if "upper" in part.name else "lower")
    points, colours = _crowns(arch)
    mesh = _grid(points)
    surface = Surface(
        mesh.positions.astype(np.float32),
        mesh.normals.astype(np.float32),
        mesh.triangles,
        bytes_of(colours.reshape(-1, 4)),
    )
    apply(surface.actor, TOOTH, openness=True)
    surface.actor.ForceOpaqueOn()
    surface.actor.GetProperty().BackfaceCullingOn()
    return surface


def _arch(mesh: Mesh, row: str) -> _Arch:
    edge_row, root_row = _rows(mesh, row)
    angle = _angle(edge_row, mesh)
    along = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(edge_row, axis=0), axis=1))])
    along -= along[-1] / 2
    edge_at, angle_at = PchipInterpolator(along, edge_row), PchipInterpolator(along, angle)
    root_at = PchipInterpolator(_angle(root_row, mesh), root_row)
    widths, heights = WIDTHS[row], HEIGHTS[row]
    bounds = np.concatenate([[0.0], np.cumsum(widths)]) * min(1.0, along[-1] / sum(widths))
    s = np.concatenate([(a + b) / 2 + ACROSS * (b - a) / 2 for a, b in itertools.pairwise(bounds)])
    tooth = np.repeat(np.arange(len(widths)), len(ACROSS))
    gum = _gum_line(heights)
    s = np.concatenate([-s[::-1], s])
    edge, root = edge_at(s), root_at(np.clip(angle_at(s), *_angle(root_row, mesh)[[0, -1]]))
    outward = np.cross(edge_at.derivative()(s), edge - root)
    outward /= np.linalg.norm(outward, axis=1, keepdims=True)
    outward *= np.sign((outward * (edge - edge.mean(axis=0))).sum())
    within = np.tile(ACROSS, len(widths))
    return _Arch(
        edge,
        root,
        outward,
        np.concatenate([-within[::-1], within]),
        np.concatenate([tooth[::-1], tooth]),
        np.concatenate([gum[::-1], gum]),
    )


def _rows(mesh: Mesh, row: str) -> tuple[FloatArray, FloatArray]:
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
    edge = inner[off < 0 if row == "upper" else off > 0]
    return edge[np.argsort(_angle(edge, mesh))], _increasing(root, _angle(root, mesh))


def _angle(points: FloatArray, mesh: Mesh) -> FloatArray:
    """Angle of places about the middle of the arch, from the right end to the left end."""
    return np.arctan2(points[:, 0], points[:, 2] - mesh.positions[:, 2].min() + 10.0)


def _increasing(points: FloatArray, angle: FloatArray) -> FloatArray:
    """Points in the order of their angle, those of equal angle (the ends) left out but one."""
    order = np.argsort(angle)
    steps = np.diff(angle[order], prepend=-np.inf)
    return np.asarray(points[order[steps > 1e-3]])


def _gum_line(heights: Sequence[float]) -> FloatArray:
    """Height of the gum over the cutting edge at the columns of one half of an arch, scalloped tooth by tooth."""
    h = np.array(heights)
    beside = PAPILLA * np.array([h[0], *((h[:-1] + h[1:]) / 2), h[-1]])
    dip = np.where(ACROSS < 0, beside[:-1, None], beside[1:, None])
    return np.asarray(dip + (h[:, None] - dip) * (1 - np.abs(ACROSS) ** 2.4)).ravel()


def _crowns(arch: _Arch) -> tuple[FloatArray, FloatArray]:
    """Points (C, R, 3) and colours (C, R, 4) of crowns in their gum, rows from the gum over the edge to the back."""
    whole = np.linalg.norm(arch.edge - arch.root, axis=1)
    gum = np.minimum(arch.gum, whole - 1.0)[:, None]
    down = (arch.edge - arch.root) / whole[:, None]
    gums = gum + (whole[:, None] - gum) * np.array([1.0, 0.5, 0.12, 0.02])
    rise = np.concatenate([gums, gum * FRONT[1:], gum * BACK], axis=1)
    rows = rise.shape[1]
    side = np.concatenate([np.zeros(rows - len(BACK) - 1), [0.06], [0.5, 0.92, 1.0, 1.0]])[None]
    crown = np.concatenate([np.zeros(3), [0.35], np.ones(rows - 4)])[None]
    q = arch.within[:, None]
    belly = 1 - np.abs(q) ** 3.0
    short = np.clip(0.8 * np.abs(q) ** 4 + CURVED[arch.tooth.astype(int)][:, None], 0, None)
    bulge = crown * (0.85 * belly - 0.65) + (1 - crown) * 0.30
    lifted = rise + crown * np.exp(-rise / 2.0) * short
    points = (
        arch.edge[:, None]
        - down[:, None] * lifted[..., None]
        + arch.outward[:, None] * (bulge - THICK * side)[..., None]
    )
    gap = smooth(np.abs(q), 0.90, 1.0) * crown
    warm = smooth(rise / gum, 0.45, 1.05) * np.ones_like(crown)
    colour = np.array(ENAMEL) + (np.array(NECK) - np.array(ENAMEL)) * (0.7 * warm)[..., None]
    colour = colour + (np.array(GAP) - colour) * (0.8 * gap)[..., None]
    colour = colour + (np.array(GUM) - colour) * (1 - crown)[..., None]
    open_ = _openness(arch, side, smooth(rise / gum, 0.15, 1.0))
    return points, np.concatenate([colour, open_[..., None]], axis=-1)


def _openness(arch: _Arch, inside: FloatArray, under_lip: FloatArray) -> FloatArray:
    """Share (C, R) of the light that an open mouth lets in to each place of a row, the darkest at its ends."""
    backwards = np.repeat([-1.0, 1.0], len(arch.tooth) // 2)
    back = smooth(arch.tooth + 0.5 * arch.within * backwards, LIT, UNLIT)[:, None]
    dark, within, covered = (
        1 - (1 - least) * share for least, share in ((DARKEST, back), (INSIDE, inside), (UNDER_LIP, under_lip))
    )
    return np.asarray(dark * within * covered)


def _grid(points: FloatArray) -> Mesh:
    """A grid (columns, rows, 3) as a mesh that faces outwards at the front."""
    columns, rows = points.shape[:2]
    i, j = np.meshgrid(np.arange(columns - 1), np.arange(rows - 1), indexing="ij")
    a = (i * rows + j).ravel()
    b, c, d = a + rows, a + rows + 1, a + 1
    triangles = np.concatenate([np.stack([a, b, c], 1), np.stack([a, c, d], 1)]).astype(np.int64)
    mesh = Mesh(points.reshape(-1, 3), triangles)
    front = points[..., 2] > np.quantile(points[..., 2], 0.9)
    if mesh.normals[front.ravel(), 2].mean() < 0:
        return Mesh(mesh.positions, triangles[:, ::-1])
    return mesh

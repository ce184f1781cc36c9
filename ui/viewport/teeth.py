"""Teeth with a shape: fourteen crowns in a gum, laid along the arch that the face's own row of teeth describes."""

from __future__ import annotations

import itertools
from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np

from facemodel.dental_arch import HEIGHTS, DentalArch, dental_arch
from facemodel.face import Part
from facemodel.mesh import Mesh
from facemodel.smooth import smooth
from fem.types import FloatArray
from ui.viewport.complexion import Colour
from ui.viewport.look import bytes_of
from ui.viewport.shading import TOOTH, apply
from ui.viewport.surface import Surface

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


def row_of_teeth(part: Part) -> Surface:
    """A row of teeth and its gum in the place of a part, at rest."""
    arch = _arch(dental_arch(part))
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


def _arch(arch: DentalArch) -> _Arch:
    ends = arch.bounds
    s = np.concatenate([(a + b) / 2 + ACROSS * (b - a) / 2 for a, b in itertools.pairwise(ends)])
    tooth = np.repeat(np.arange(len(ends) - 1), len(ACROSS))
    within, gum = np.tile(ACROSS, len(ends) - 1), _gum_line(HEIGHTS[arch.jaw])
    return _Arch(
        *arch.at(np.concatenate([-s[::-1], s])),
        np.concatenate([-within[::-1], within]),
        np.concatenate([tooth[::-1], tooth]),
        np.concatenate([gum[::-1], gum]),
    )


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

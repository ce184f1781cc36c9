"""Paint the tissue of a recipe on a head: stiffness, stretching, bending and supports by region, from landmarks."""

from __future__ import annotations

from collections.abc import Mapping

import igl
import numpy as np

from facemodel.anatomy.placement import EYES_APART, SCALE_FROM
from facemodel.anatomy.recipe import Layer, Region, Tissue
from facemodel.face import Layers
from facemodel.mesh import Mesh
from facemodel.smooth import smooth_step
from fem import Support
from fem.types import BoolArray, FloatArray, IntArray

MARGINS = ("lids", "lips")
"""What a region may lie about beside landmarks."""


def soft(distance: FloatArray, inner: float, outer: float) -> FloatArray:
    """1 within ``inner``, 0 beyond ``outer``, smooth between."""
    return smooth_step((outer - distance) / (outer - inner))


class Canvas:
    """A skin on which regions lie.

    Parameters
    ----------
    skin : the whole skin, millimetres
    landmarks : its vertices by name
    margins : vertices of the loops of ``lids`` and ``lips``
    """

    def __init__(self, skin: Mesh, landmarks: Mapping[str, int], margins: Mapping[str, IntArray]) -> None:
        self._skin, self._landmarks, self._margins = skin, landmarks, margins
        self._away: dict[tuple[str, ...], FloatArray] = {}
        left, right = (skin.positions[landmarks[name]] for name in SCALE_FROM)
        self._scale = float(np.linalg.norm(left - right)) / EYES_APART

    def share(self, region: Region) -> FloatArray:
        """How much every vertex (N,) belongs to a region, 0 to 1."""
        if region.about not in self._away:
            self._away[region.about] = self._distance(region.about) / self._scale
        return soft(self._away[region.about], region.inner, region.outer)

    def _distance(self, about: tuple[str, ...]) -> FloatArray:
        """Millimetres (N,): along the skin from a margin, through the air from the nearest landmark."""
        if about[0] in MARGINS:
            return geodesic(self._skin, self._margins[about[0]])
        names = [full for name in about for full in self._sides(name)]
        places = self._skin.positions[[self._landmarks[name] for name in names]]
        return np.asarray(np.linalg.norm(self._skin.positions[:, None] - places[None], axis=2).min(axis=1))

    def _sides(self, name: str) -> tuple[str, ...]:
        return (name,) if name in self._landmarks else (f"{name}_L", f"{name}_R")


def geodesic(skin: Mesh, sources: IntArray) -> FloatArray:
    """Geodesic distance (N,) from some vertices, millimetres (heat method)."""
    data = igl.HeatGeodesicsData()
    igl.heat_geodesics_precompute(skin.positions, skin.triangles, data)
    return np.asarray(igl.heat_geodesics_solve(data, np.asarray(sources, dtype=np.int64)))


def head_margins(skin: Mesh) -> dict[str, IntArray]:
    """The margins of a head that ships: its shortest loops are the eyes, then comes the mouth."""
    one, other, mouth, *_ = skin.boundary_loops
    return {"lids": np.concatenate([one, other]), "lips": mouth}


def paint(tissue: Tissue, canvas: Canvas, skin: Mesh, solved: BoolArray, landmarks: Mapping[str, int]) -> Layers:
    """The layers of a head that nobody has painted yet."""
    count = len(skin.positions)
    log: dict[Layer, FloatArray] = {}
    volume = np.zeros(count)
    for region in tissue.regions:
        share = canvas.share(region)
        for layer, factor in region.factors.items():
            if layer == "volume":
                volume = (1 - share) * volume + share * factor
            else:
                log[layer] = log.get(layer, np.zeros(count)) + np.log(factor) * share

    def times(layer: Layer) -> FloatArray:
        return np.exp(log[layer]) if layer in log else np.ones(count)

    bending = tissue.bending * times("bending")
    across = bending * times("bending_across")
    supports = np.zeros(count, dtype=np.int64)
    supports[np.unique(skin.triangles[~solved])] = Support.CLAMPED
    for name in ("eye_inner_L", "eye_inner_R"):
        supports[landmarks[name]] = Support.VALUE
    return Layers(
        direction=np.tile([1.0, 0.0, 0.0], (count, 1)),
        stretching=np.repeat((tissue.stretching * times("stretching"))[:, None], 2, axis=1),
        bending=np.stack([bending, across, np.sqrt(bending * across)], axis=1),
        stiffness=tissue.stiffness * times("stiffness"),
        thickness=np.zeros(count),
        sliding=np.maximum(tissue.sliding * times("sliding"), 1.0),
        volume=volume,
        supports=supports,
    )

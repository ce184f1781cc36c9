"""The painted default tissue: stiffness, stretching, bending and supports by region, from landmarks."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import igl
import numpy as np

from facemodel.face import Layers
from facemodel.mesh import Mesh
from facemodel.tissue import SLIDING
from fem import Support
from fem.types import BoolArray, FloatArray, IntArray

STIFFNESS = 0.004
"""N/mm^3 along the normal: soft tissue of some 40 kPa over a centimetre of depth."""

STRETCHING = 0.15
"""N/mm.  With the tissue's tangential stiffness it gives a pull a reach of about two centimetres along the skin."""

BENDING = 0.5
"""N mm, a skin of 0.5 MPa and 2 mm; it rounds a fold over two to three millimetres."""


@dataclass(frozen=True)
class Region:
    """A soft-edged patch about landmarks: factor inside ``inner`` millimetres, none beyond ``outer``."""

    landmarks: tuple[str, ...]
    inner: float
    outer: float
    factor: float


STIFFNESS_REGIONS: tuple[Region, ...] = (
    Region(("nasion", "rhinion"), 7, 18, 5.0),
    Region(("nose_tip",), 8, 16, 2.0),
    Region(("tragus_L", "tragus_R"), 30, 45, 8.0),
    Region(("cheek_L", "cheek_R", "nasolabial_L", "nasolabial_R"), 14, 28, 0.6),
    Region(("pogonion", "menton"), 10, 26, 1.6),
    Region(("gonion_L", "gonion_R"), 10, 26, 1.5),
)
"""Where the tissue is firmer (nasal bones and cartilage, ear, ligaments of the chin and jaw) or looser (cheeks)."""

LID_REACH = (3.0, 11.0, 0.25)
LIP_REACH = (6.0, 16.0, 0.35)
"""Inner and outer distance from the margin of lids and lips in millimetres, and the factor: both hang free."""


def _soft(distance: FloatArray, inner: float, outer: float) -> FloatArray:
    """1 within ``inner``, 0 beyond ``outer``, smooth between."""
    t = np.clip((outer - distance) / (outer - inner), 0.0, 1.0)
    return np.asarray(t * t * (3 - 2 * t))


def _distance(skin: Mesh, sources: IntArray) -> FloatArray:
    """Geodesic distance (N,) from some vertices, millimetres (heat method)."""
    data = igl.HeatGeodesicsData()
    igl.heat_geodesics_precompute(skin.positions, skin.triangles, data)
    return np.asarray(igl.heat_geodesics_solve(data, np.asarray(sources, dtype=np.int64)))


def paint(skin: Mesh, solved: BoolArray, landmarks: Mapping[str, int]) -> Layers:
    """The default layers of a head."""
    count = len(skin.positions)
    log_factor = np.zeros(count)
    for region in STIFFNESS_REGIONS:
        sources = np.array([landmarks[name] for name in region.landmarks])
        away = np.linalg.norm(skin.positions[:, None] - skin.positions[sources][None], axis=2).min(axis=1)
        log_factor += np.log(region.factor) * _soft(away, region.inner, region.outer)
    eyes, mouth = np.concatenate(skin.boundary_loops[:2]), skin.boundary_loops[2]
    for loop, (inner, outer, factor) in ((eyes, LID_REACH), (mouth, LIP_REACH)):
        log_factor += np.log(factor) * _soft(_distance(skin, loop), inner, outer)

    supports = np.zeros(count, dtype=np.int64)
    supports[np.unique(skin.triangles[~solved])] = Support.CLAMPED
    for name in ("eye_inner_L", "eye_inner_R"):
        supports[landmarks[name]] = Support.VALUE
    return Layers(
        direction=np.tile([1.0, 0.0, 0.0], (count, 1)),
        stretching=np.full((count, 2), STRETCHING),
        bending=np.full((count, 3), BENDING),
        stiffness=STIFFNESS * np.exp(log_factor),
        thickness=np.zeros(count),
        sliding=np.full(count, SLIDING),
        volume=np.zeros(count),
        supports=supports,
    )

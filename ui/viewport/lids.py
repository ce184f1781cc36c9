"""The edge of the lids: where their margin turns into their front, as a closed line that moves with the skin."""

from __future__ import annotations

from dataclasses import dataclass
from functools import lru_cache

import igl
import numpy as np

from facemodel.display import DisplaySurface
from facemodel.face import Eye
from fem.types import Float32Array, FloatArray, IntArray
from ui.viewport.edges import between

NEAR = 1.6
"""Radii of the eyeball within which its lids lie."""
SECTIONS = 80
"""Half-planes through the opening in each of which the edge is found."""
UNSEEN = 0.01
"""Millimetres that nobody sees of a lid."""
BEYOND = 3.0
"""Millimetres farther out than the opening at which the edge may lie; cheek and nose begin there."""


@dataclass(frozen=True, eq=False)
class LidLine:
    """A closed line round an eye on the drawn skin.

    Attributes
    ----------
    start, stop : (n,) drawn points at the ends of the edges that the line crosses
    share : (n,) how far from ``start`` to ``stop``
    """

    start: IntArray
    stop: IntArray
    share: FloatArray

    @property
    def closed(self) -> bool:
        """Whether there are lids at all; a scan without openings has none."""
        return len(self.start) > 0

    def places(self, points: Float32Array | FloatArray) -> FloatArray:
        """The line (n, 3) on the posed skin ``points`` (P, 3), in order round the eye."""
        return between(points, self.start, self.stop, self.share)


def same_line(one: FloatArray, other: FloatArray) -> bool:
    """Whether two places (n, 3) of a line look the same, so that what hangs on it need not follow."""
    return bool(np.abs(one - other).max() < UNSEEN)


@lru_cache(maxsize=8)
def lids_of(display: DisplaySurface, eye: Eye) -> LidLine:
    """The edge of the resting lids of an eye on a drawn surface; remembered, so that lashes and light share it."""
    return lid_line(display.points, display.triangles, eye)


def lid_line(points: Float32Array | FloatArray, triangles: IntArray, eye: Eye) -> LidLine:
    """The edge of the resting lids of an eye on a skin of ``points`` (P, 3); empty if it has no opening there.

    In every section through the opening the edge is the place of the lid that stands out most inwards and forwards.
    """
    opening = _opening(points, triangles, eye)
    if opening is None:
        return LidLine(*(np.zeros(0, dtype=np.int64) for _ in "ab"), np.zeros(0))
    offset = points.astype(np.float64) - [*opening[:2], eye.centre[2]]
    near = (np.linalg.norm(offset, axis=1) < NEAR * eye.radius) & (offset[:, 2] > 0.2 * eye.radius)
    lids = triangles[near[triangles].all(axis=1)]
    edges = np.unique(np.sort(lids[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1), axis=0)
    found = [_edge_in_section(offset, edges, turn) for turn in 2 * np.pi * np.arange(SECTIONS) / SECTIONS]
    start, stop, share = np.array([place for place in found if place is not None]).reshape(-1, 3).T
    return LidLine(start.astype(np.int64), stop.astype(np.int64), share)


def _opening(points: Float32Array | FloatArray, triangles: IntArray, eye: Eye) -> FloatArray | None:
    """The middle (3,) of the opening of the skin before an eye."""
    middles = [points[loop].mean(axis=0) for loop in igl.boundary_loop_all(triangles)]
    nearest = min(middles, key=lambda middle: float(np.linalg.norm(middle - eye.centre)))
    return nearest if np.linalg.norm(nearest - eye.centre) < NEAR * eye.radius else None


def _edge_in_section(offset: FloatArray, edges: IntArray, turn: float) -> tuple[float, float, float] | None:
    """The mesh edge and the share along it where the lid's edge crosses a half-plane at an angle about +z."""
    across = offset[:, 1] * np.cos(turn) - offset[:, 0] * np.sin(turn)
    outward = offset[:, 0] * np.cos(turn) + offset[:, 1] * np.sin(turn)
    a, b = across[edges].T
    met = edges[(a < 0) != (b < 0)]
    share = across[met[:, 0]] / (across[met[:, 0]] - across[met[:, 1]])
    distance = outward[met[:, 0]] * (1 - share) + outward[met[:, 1]] * share
    height = offset[met[:, 0], 2] * (1 - share) + offset[met[:, 1], 2] * share
    before = distance > 0
    if not before.any():
        return None
    lid = before & (distance < distance[before].min() + BEYOND)
    chosen = int(np.where(lid, height - distance, -np.inf).argmax())
    return float(met[chosen, 0]), float(met[chosen, 1]), float(share[chosen])

"""How deep the furrows of a face are in a pose: as far as its skin is pushed together across them.

The slopes of the posed surface say how long a step across a furrow has become; what it has lost folds.
"""

from __future__ import annotations

import numpy as np

from facemodel.compiled import compiled
from facemodel.display import DisplaySurface
from facemodel.face import Face
from facemodel.smooth import smooth_share
from facemodel.superposition import Superposition
from fem.types import Float32Array, FloatArray, IntArray
from ui.viewport.furrows import Furrows
from ui.viewport.look import at_points

FOLDS = "folds"
"""Name of the array of points that says how deep their furrows are."""

FIRST, FULL = 0.02, 0.13
"""Share of its length that skin loses until a furrow is seen, and until it is as deep as it gets."""

BELONGS = 0.02
"""Share of furrowed skin below which a point is left out."""

SEEN = 0.01
"""Change of depth that is seen."""


class Folding:
    """Tells how deep the furrows of a posed face are.

    Parameters
    ----------
    posed : the face
    lines : its furrows

    Attributes
    ----------
    depth : (P, 1) float32, 0 to 1, of every drawn point; always the same array
    """

    def __init__(self, posed: Superposition, lines: Furrows) -> None:
        display = posed.basis.display
        self._posed = posed
        self.depth = np.zeros((len(display.points), 1), dtype=np.float32)
        share = at_points(posed.face, display, lines.share)[: display.moving]
        self._points: IntArray = np.flatnonzero(share > BELONGS)
        self._share = share[self._points]
        self._across, self._length = _steps(posed.face, display, lines, self._points)
        self._seen = np.zeros(len(self._points), dtype=np.float32)

    def follow(self) -> bool:
        """Take over the pose; whether any furrow is seen otherwise than before."""
        now = _depths(self._posed.slopes, self._points, self._across, self._length, self._share)
        if not len(now) or np.abs(now - self._seen).max() < SEEN:
            return False
        self._seen = now
        self.depth[self._points, 0] = now
        return True


def _steps(face: Face, display: DisplaySurface, lines: Furrows, points: IntArray) -> tuple[FloatArray, FloatArray]:
    """The steps (n, 2) on the chart that go across the furrows at some points, and how long (n,) they are at rest."""
    ways = at_points(face, display, lines.across)[points]
    slopes = display.slopes.astype(np.float64)[:, points]
    along_u, along_v = slopes[:3].T, slopes[3:].T
    uu, uv, vv = ((a * b).sum(axis=1) for a, b in ((along_u, along_u), (along_u, along_v), (along_v, along_v)))
    u, v = (along_u * ways).sum(axis=1), (along_v * ways).sum(axis=1)
    whole = uu * vv - uv * uv
    steps = np.stack([(vv * u - uv * v) / whole, (uu * v - uv * u) / whole], axis=1)
    return steps, np.linalg.norm(steps[:, :1] * along_u + steps[:, 1:] * along_v, axis=1)


@compiled
def _depths(
    slopes: Float32Array, points: IntArray, across: FloatArray, length: FloatArray, share: FloatArray
) -> Float32Array:
    """How deep (n,) furrows are at some of the points whose slopes (6, S) are given."""
    found = np.empty(len(points), np.float32)
    for number, i in enumerate(points):
        square = 0.0
        for axis in range(3):
            step = across[number, 0] * slopes[axis, i] + across[number, 1] * slopes[3 + axis, i]
            square += step * step
        lost = 1 - np.sqrt(square) / max(length[number], 1e-9)
        found[number] = share[number] * smooth_share((lost - FIRST) / (FULL - FIRST))
    return found

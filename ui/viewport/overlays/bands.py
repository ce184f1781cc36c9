"""The shape of a muscle as a body: fibres between bone and skin with a belly, or a ring under the skin, lens-shaped."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from facemodel.mesh import Mesh
from facemodel.muscles import Muscle
from fem.types import FloatArray, IntArray
from ui.viewport.overlays.fan_body import fan_body
from ui.viewport.overlays.ring_body import ring_body


@dataclass(frozen=True, eq=False)
class Band:
    """A muscle as a grid of points.

    Attributes
    ----------
    points : (rows, columns, 3) rows go round the lens of a cross-section, columns from origin to attachment, or round
        a ring
    along : (columns,) 0 at the origin, 1 at the attachment; all one for a ring, which hangs on the skin alone
    grain : (rows, columns, 2) millimetres along and across the fibres, for what is drawn on them
    closed : whether the columns close to a ring
    """

    points: FloatArray
    along: FloatArray
    grain: FloatArray
    closed: bool

    @property
    def triangles(self) -> IntArray:
        """Triangles of the grid, vertices numbered row by row; the rows close to a tube."""
        rows, columns = self.points.shape[:2]
        spans = columns if self.closed else columns - 1
        i, j = np.meshgrid(np.arange(rows), np.arange(spans), indexing="ij")
        a, b = i * columns + j, i * columns + (j + 1) % columns
        c, d = (i + 1) % rows * columns + j, (i + 1) % rows * columns + (j + 1) % columns
        return np.concatenate([np.stack([a, b, d], -1).reshape(-1, 3), np.stack([a, d, c], -1).reshape(-1, 3)])


def band(muscle: Muscle, skin: Mesh, bones: tuple[Mesh, Mesh]) -> Band:
    """The body of a muscle under a resting skin and over bones."""
    if muscle.ring is not None:
        points, grain, closed = ring_body(muscle, skin)
        return Band(points, np.ones(points.shape[1]), grain, closed)
    points, grain = fan_body(muscle, skin, bones)
    return Band(points, np.linspace(0, 1, points.shape[1]), grain, closed=False)

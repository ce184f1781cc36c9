"""The muscles: bands with visible fibres, coloured by group; what contracts glows, what is selected stands out."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from functools import lru_cache

import igl
import numpy as np

from facemodel.display import DisplaySurface
from facemodel.mesh import Mesh
from facemodel.muscles import Muscle
from fem.types import Float32Array, FloatArray, IntArray
from ui.viewport.muscle_fields import activations
from ui.viewport.overlays.bands import Band, band
from ui.viewport.overlays.glow import ACCENT
from ui.viewport.overlays.overlay import Drawn, Overlay
from ui.viewport.shading import BAND, apply
from ui.viewport.surface import Surface

GROUPS: Mapping[str, tuple[float, float, float]] = {
    "brow": (0.80, 0.58, 0.27),
    "eye": (0.36, 0.60, 0.62),
    "nose": (0.58, 0.47, 0.74),
    "cheek": (0.74, 0.33, 0.31),
    "lip": (0.76, 0.42, 0.52),
    "chin": (0.53, 0.60, 0.35),
}
"""Colours of muscle groups, alike in brightness."""
OTHER = (0.62, 0.40, 0.36)
TENDON = (0.80, 0.74, 0.68)
REST, FULL = 0.62, 1.25
"""Brightness of a muscle at rest and fully contracted."""
HOT = (1.00, 0.66, 0.36)
"""What a contracting muscle turns to."""
SWELL = 1.2
"""Millimetres that a contracted muscle is thicker."""


class MusclesOverlay(Overlay):
    """All muscles of a project in one actor."""

    def build(self, drawn: Drawn) -> None:
        """Lay the bands under the resting skin."""
        skin = drawn.project.face.skin
        # The force of the jaw has no shape of its own: its muscles lie under the others.
        self._muscles = [
            muscle
            for muscle in drawn.project.muscles
            if (muscle.fibres or muscle.ring is not None) and muscle.key not in drawn.hidden
        ]
        if not self._muscles:
            return
        display = drawn.figure.posed.basis.display
        laid = [_laid(muscle, skin, display) for muscle in self._muscles]
        sizes = [len(each.points) for each in laid]
        first = np.cumsum([0, *sizes])
        self._rest = np.concatenate([each.points for each in laid])
        triangles = np.concatenate([each.triangles + k for each, k in zip(laid, first, strict=False)])
        self._owner = np.repeat(np.arange(len(laid)), sizes)
        self._base = np.concatenate([each.colours for each in laid])
        self._share = np.concatenate([each.share for each in laid])
        self._anchor = np.concatenate([each.anchor for each in laid])
        self._anchored = display.points
        self._normals = np.concatenate([each.normals for each in laid])
        colours = np.full((len(self._rest), 4), 255, dtype=np.uint8)
        self._surface = Surface(self._rest.astype(np.float32), self._normals, triangles, colours)
        apply(self._surface.actor, BAND)
        self.add(self._surface.actor)

    def follow(self, drawn: Drawn) -> None:
        """Colour by contraction and selection, and move the attachments with the skin."""
        if not self._muscles:
            return
        active = activations(drawn.project, drawn.expression)
        keys = [muscle.key for muscle in self._muscles]
        pull = np.array([active.get(key, 0.0) for key in keys])
        chosen = np.array([key == drawn.muscle or key in drawn.others | drawn.glowing for key in keys])
        at = pull[self._owner][:, None]
        colour = self._base * (REST + (FULL - REST) * at)
        colour += (np.array(HOT) - colour) * 0.45 * at
        colour += (np.array(ACCENT) - colour) * 0.75 * chosen[self._owner][:, None]
        colours = self._surface.colours
        assert colours is not None
        colours[:, :3] = np.clip(255 * colour, 0, 255)
        shift = drawn.figure.posed.points[self._anchor] - self._anchored[self._anchor]
        self._surface.points[:] = self._rest + self._share[:, None] * shift
        self._surface.points[:] += (SWELL * pull[self._owner] * (1 - self._share))[:, None] * self._normals
        self._surface.recoloured()
        self._surface.moved()


def colour_of(muscle: Muscle) -> tuple[float, float, float]:
    """The colour of a muscle at rest: its own, else that of its group."""
    if muscle.colour:
        red, green, blue = (int(muscle.colour[k : k + 2], 16) / 255 for k in (1, 3, 5))
        return red, green, blue
    return GROUPS.get(muscle.group, OTHER)


def _colours(shape: Band, group: tuple[float, float, float]) -> FloatArray:
    """Colours (n, 3) of a band: fibres as fine stripes, paler towards the tendon."""
    rows, columns = shape.points.shape[:2]
    stripe = 1.0 + 0.16 * np.where(np.arange(rows) % 2 == 0, 1.0, -1.0)
    colour = np.array(group) * stripe[:, None, None] * np.ones((1, columns, 1))
    pale = np.clip(1 - shape.along / 0.16, 0, 1) ** 2
    return np.asarray((colour + (np.array(TENDON) - colour) * (0.7 * pale)[None, :, None]).reshape(-1, 3))


@dataclass(frozen=True, eq=False)
class Laid:
    """One muscle as it lies under the resting skin.

    Attributes
    ----------
    points, normals, colours : (n, 3) of its band
    triangles : (t, 3)
    share : (n,) how far each point goes with the skin
    anchor : (n,) the drawn point that it goes with
    """

    points: FloatArray
    normals: Float32Array
    colours: FloatArray
    triangles: IntArray
    share: FloatArray
    anchor: IntArray


@lru_cache(maxsize=256)
def _laid(muscle: Muscle, skin: Mesh, display: DisplaySurface) -> Laid:
    """One muscle; remembered, so that of many only the one that changed is laid anew."""
    shape = band(muscle, skin)
    points = shape.points.reshape(-1, 3)
    anchor = _nearest(points, display)
    return Laid(
        points,
        _outward(Mesh(points, shape.triangles), display.normals[anchor]).astype(np.float32),
        _colours(shape, colour_of(muscle)),
        shape.triangles,
        np.tile(shape.along**2, shape.points.shape[0]),
        anchor,
    )


def _nearest(places: FloatArray, display: DisplaySurface) -> IntArray:
    """The drawn point nearest to each place."""
    tree, points = _tree(display)
    _, element, nearest = tree.squared_distance(points, display.triangles, np.ascontiguousarray(places))
    corners = display.triangles[np.reshape(element, -1)]
    closest = np.linalg.norm(points[corners] - np.reshape(nearest, (-1, 1, 3)), axis=2).argmin(axis=1)
    return np.asarray(corners[np.arange(len(corners)), closest])


@lru_cache(maxsize=2)
def _tree(display: DisplaySurface) -> tuple[igl.AABB, FloatArray]:
    """What finds the nearest places of the drawn skin at rest, and its points."""
    points = np.ascontiguousarray(display.points, dtype=np.float64)
    tree = igl.AABB()
    tree.init(points, display.triangles)
    return tree, points


def _outward(mesh: Mesh, towards: Float32Array) -> FloatArray:
    """Normals (n, 3) of a band, turned to the side of the skin, whose normals are (n, 3) beside it."""
    side = np.sign(np.einsum("nc,nc->n", mesh.normals, towards))
    return np.asarray(mesh.normals * np.where(side == 0, 1.0, side)[:, None])

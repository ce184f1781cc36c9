"""The skull behind the skin: the cranium stands still, the mandible turns with the jaw."""

from __future__ import annotations

from collections import deque

import numpy as np

from facemodel.face import Jaw
from facemodel.jaw.motion import jaw_motion
from facemodel.mesh import Mesh
from fem.types import FloatArray, IntArray
from ui.viewport.look import bytes_of
from ui.viewport.occlusion import openness
from ui.viewport.overlays.overlay import Drawn, Overlay
from ui.viewport.shading import BONE, apply
from ui.viewport.surface import ByteArray, Surface, moved_by

BONE_COLOUR = (0.865, 0.815, 0.720)
RAYS, FEWEST_RAYS = 48, 12
"""Bone is smooth and half hidden: half the rays of the skin will do, and fewer where there are many vertices."""

BUDGET = 300_000
"""Rays of one bone at most; they are cast while the window waits."""

KEPT = 8
"""Bones whose openness is remembered."""


class SkullOverlay(Overlay):
    """Cranium and mandible.

    Attributes
    ----------
    tried : degrees, and millimetres forward and aside, by which the jaw is moved to be looked at; none where it is as
        it is posed
    hinge : what it turns about while that is dragged; none where it is the project's
    """

    tried: tuple[float, float, float] | None = None
    hinge: Jaw | None = None
    _way: FloatArray = np.eye(4)
    _dye: tuple[FloatArray, FloatArray] | None = None
    _aside = False

    def build(self, drawn: Drawn) -> None:
        """Make both bones."""
        skull = drawn.project.face.skull
        self._bones = tuple(bone_surface(mesh) for mesh in (skull.cranium, skull.mandible))
        self._way = np.eye(4)
        for bone in self._bones:
            self.add(bone.actor)
        self._lay_on()
        self.step_aside(self._aside)

    def follow(self, drawn: Drawn) -> None:
        """Turn the mandible with the jaw."""
        stance = drawn.figure.posed.stance
        cranium, mandible = self._bones
        moved_by(cranium, stance.head @ self._way)
        moved_by(mandible, stance.head @ self._way @ self.jaw(drawn))

    def jaw(self, drawn: Drawn) -> FloatArray:
        """The motion (4, 4) within the head that the mandible is drawn with."""
        if self.tried is None:
            return drawn.figure.posed.jaw
        return jaw_motion(self.hinge or drawn.project.face.skull.jaw, *self.tried)

    def carry(self, drawn: Drawn, way: FloatArray) -> None:
        """Draw both bones where an affine map (4, 4) takes them, until the project has them elsewhere."""
        self._way = way
        if self.shown:
            self.follow(drawn)

    def step_aside(self, on: bool) -> None:
        """Do not draw the bones for a while, without switching the skull off: another one is drawn in their place."""
        self._aside = on
        if self.shown:
            for bone in self._bones:
                bone.actor.SetVisibility(not on)

    def dye(self, dyes: tuple[FloatArray, FloatArray] | None) -> None:
        """Lay colours and how much they cover, (n, 4) for each bone, on the bones; nothing for none."""
        self._dye = dyes
        if self.shown:
            self._lay_on()

    def _lay_on(self) -> None:
        """Colours that do not fit, of a skull that is no longer there, are left off."""
        dyes: tuple[FloatArray | None, ...] = self._dye or (None, None)
        for bone, dye in zip(self._bones, dyes, strict=True):
            own = bone.undyed
            if dye is not None and len(dye) == len(own):
                mixed = own[:, :3] + dye[:, 3:] * (255 * dye[:, :3] - own[:, :3])
                bone.colours[:, :3] = np.clip(mixed + 0.5, 0, 255).astype(np.uint8)
            else:
                bone.colours[:] = own
            bone.recoloured()


class BoneSurface(Surface):
    """A bone as it is drawn.

    Attributes
    ----------
    undyed : its colours (n, 4) with nothing laid on them
    """

    def __init__(self, mesh: Mesh, undyed: ByteArray) -> None:
        self.undyed = undyed
        super().__init__(
            mesh.positions.astype(np.float32), mesh.normals.astype(np.float32), mesh.triangles, undyed.copy()
        )
        apply(self.actor, BONE, openness=True)
        self.actor.ForceOpaqueOn()


def bone_surface(mesh: Mesh) -> BoneSurface:
    """Bone as it is seen; one that was only moved or scaled keeps its colours."""
    for triangles, colours in tuple(_known):
        if triangles is mesh.triangles:
            return BoneSurface(mesh, colours)
    open_ = openness(mesh, mesh, max(FEWEST_RAYS, min(RAYS, BUDGET // max(1, len(mesh.positions)))))
    made = bytes_of(np.column_stack([np.broadcast_to(BONE_COLOUR, (len(open_), 3)), open_]))
    _known.append((mesh.triangles, made))
    return BoneSurface(mesh, made)


_known: deque[tuple[IntArray, ByteArray]] = deque(maxlen=KEPT)

"""The skull behind the skin: the cranium stands still, the mandible turns with the jaw."""

from __future__ import annotations

from collections import deque

import numpy as np

from facemodel.mesh import Mesh
from fem.types import FloatArray, IntArray
from ui.viewport.look import bytes_of
from ui.viewport.occlusion import openness
from ui.viewport.overlays.overlay import Drawn, Overlay
from ui.viewport.parts import moved_by
from ui.viewport.shading import BONE, apply
from ui.viewport.surface import ByteArray, Surface

BONE_COLOUR = (0.865, 0.815, 0.720)
RAYS = 48
"""Bone is smooth and half hidden: half the rays of the skin will do."""

KEPT = 8
"""Bones whose openness is remembered."""


class SkullOverlay(Overlay):
    """Cranium and mandible."""

    def build(self, drawn: Drawn) -> None:
        """Make both bones."""
        skull = drawn.project.face.skull
        self._cranium, self._mandible = _bone(skull.cranium), _bone(skull.mandible)
        self._way = np.eye(4)
        for bone in (self._cranium, self._mandible):
            self.add(bone.actor)

    def follow(self, drawn: Drawn) -> None:
        """Turn the mandible with the jaw."""
        moved_by(self._cranium, self._way)
        moved_by(self._mandible, self._way @ drawn.figure.posed.jaw)

    def carry(self, drawn: Drawn, way: FloatArray) -> None:
        """Draw both bones where an affine map (4, 4) takes them, as long as they are shown."""
        self._way = way
        if self.shown:
            self.follow(drawn)


def _bone(mesh: Mesh) -> Surface:
    surface = Surface(
        mesh.positions.astype(np.float32), mesh.normals.astype(np.float32), mesh.triangles, _colours(mesh)
    )
    apply(surface.actor, BONE, openness=True)
    surface.actor.ForceOpaqueOn()
    return surface


def _colours(mesh: Mesh) -> ByteArray:
    """Colours and openness (n, 4); a bone that was only moved or scaled keeps those that it had."""
    for triangles, colours in tuple(_known):
        if triangles is mesh.triangles:
            return colours
    open_ = openness(mesh, mesh, RAYS)
    made = bytes_of(np.column_stack([np.broadcast_to(BONE_COLOUR, (len(open_), 3)), open_]))
    _known.append((mesh.triangles, made))
    return made


_known: deque[tuple[IntArray, ByteArray]] = deque(maxlen=KEPT)

"""The skull behind the skin: the cranium stands still, the mandible turns with the jaw."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from facemodel.mesh import Mesh
from ui.viewport.look import bytes_of
from ui.viewport.occlusion import openness
from ui.viewport.overlays.overlay import Drawn, Overlay
from ui.viewport.parts import moved_by
from ui.viewport.shading import BONE, apply
from ui.viewport.surface import ByteArray, Surface

BONE_COLOUR = (0.865, 0.815, 0.720)
RAYS = 48
"""Bone is smooth and half hidden: half the rays of the skin will do."""


class SkullOverlay(Overlay):
    """Cranium and mandible."""

    def build(self, drawn: Drawn) -> None:
        """Make both bones."""
        skull = drawn.project.face.skull
        self._mandible = _bone(skull.mandible)
        self.add(_bone(skull.cranium).actor)
        self.add(self._mandible.actor)

    def follow(self, drawn: Drawn) -> None:
        """Turn the mandible with the jaw."""
        moved_by(self._mandible, drawn.figure.posed.jaw)


def _bone(mesh: Mesh) -> Surface:
    surface = Surface(
        mesh.positions.astype(np.float32), mesh.normals.astype(np.float32), mesh.triangles, _colours(mesh)
    )
    apply(surface.actor, BONE, openness=True)
    surface.actor.ForceOpaqueOn()
    return surface


@lru_cache(maxsize=8)
def _colours(mesh: Mesh) -> ByteArray:
    open_ = openness(mesh, mesh, RAYS)
    return bytes_of(np.column_stack([np.broadcast_to(BONE_COLOUR, (len(open_), 3)), open_]))

"""Where the skin is held: a dot on every vertex of the solved face that a support holds."""

from __future__ import annotations

import numpy as np
from vtkmodules.vtkRenderingCore import vtkActor

from facemodel.face import Face
from facemodel.sampling import points_of_vertices
from fem import Support
from fem.types import Float32Array, IntArray
from ui.viewport.overlays.overlay import Drawn, Overlay
from ui.viewport.surface import companion

COLOURS = {Support.VALUE: (0.353, 0.694, 0.941), Support.CLAMPED: (0.910, 0.725, 0.286)}
"""Held in place; held in place and slope."""
SIZE = 6.0
"""Pixels."""


HELD = (0.60, 0.54, 0.40)
HELD_COVER = 0.55
"""Colour laid on the part of the head that is not solved, and how much of the skin it covers."""


def held_paint(drawn: Drawn) -> Float32Array:
    """Colours (P, 4) that mark the part of the skin that stands still."""
    display = drawn.figure.posed.basis.display
    colours = np.zeros((len(display.points), 4), dtype=np.float32)
    colours[display.moving :] = (*HELD, HELD_COVER)
    return colours


def held_vertices(face: Face) -> dict[Support, IntArray]:
    """Solved skin vertices by how they are held; those on the seam to the held rest of the head are clamped."""
    kinds = np.array(face.layers.supports)
    solved = np.zeros(len(kinds), dtype=bool)
    solved[face.skin.triangles[face.solved]] = True
    kinds[face.skin.triangles[~face.solved]] = Support.CLAMPED
    return {kind: np.flatnonzero(solved & (kinds == kind)) for kind in COLOURS}


class SupportsOverlay(Overlay):
    """Dots on held vertices."""

    def build(self, drawn: Drawn) -> None:
        """Make the dots; they share the skin's points."""
        face, figure = drawn.project.face, drawn.figure
        at = points_of_vertices(face, figure.posed.basis.display)
        for kind, vertices in held_vertices(face).items():
            self.add(_dots(drawn, at[vertices], COLOURS[kind]))


def _dots(drawn: Drawn, points: IntArray, colour: tuple[float, float, float]) -> vtkActor:
    actor = companion(drawn.figure.skin.surface, points[:, None])
    mapper = actor.GetMapper()
    mapper.SetResolveCoincidentTopologyToPolygonOffset()
    mapper.SetRelativeCoincidentTopologyPointOffsetParameter(-8.0)
    shown = actor.GetProperty()
    shown.SetColor(*colour)
    shown.SetLighting(False)
    shown.SetPointSize(SIZE)
    shown.RenderPointsAsSpheresOn()
    return actor

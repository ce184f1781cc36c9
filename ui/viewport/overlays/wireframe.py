"""The edges of the finite elements on the smooth skin; they share the skin's points and so move with it."""

from __future__ import annotations

import numpy as np
from vtkmodules.vtkRenderingCore import vtkActor

from facemodel.display import DisplaySurface
from facemodel.face import Face
from fem.types import IntArray
from ui.viewport.overlays.overlay import Drawn, Overlay
from ui.viewport.surface import companion

SOLVED, HELD = (0.06, 0.07, 0.09), (0.30, 0.32, 0.36)
"""Colours of the edges of solved elements and of the held rest."""
NOWHERE = 1e-6
"""A barycentric coordinate below this means that the point does not hang on that corner."""


def element_edges(face: Face, display: DisplaySurface, triangles: IntArray) -> IntArray:
    """Segments (n, 2) of some drawn triangles (t, 3) that lie on edges of elements.

    A segment does so if both its ends hang on the same two corners.
    """
    pairs = np.sort(triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    pairs = np.unique(pairs, axis=0)
    corners = np.where(display.barycentric > NOWHERE, face.skin.triangles[display.elements], -1)
    both = np.sort(np.concatenate([corners[pairs[:, 0]], corners[pairs[:, 1]]], axis=1), axis=1)
    distinct = (np.diff(both, axis=1) > 0).sum(axis=1) + (both[:, 0] >= 0)
    return np.asarray(pairs[distinct <= 2])


class WireframeOverlay(Overlay):
    """Element edges, dark on what is solved and pale on what is held."""

    def build(self, drawn: Drawn) -> None:
        """Make the lines."""
        display = drawn.figure.posed.basis.display
        edges = element_edges(drawn.project.face, display, drawn.figure.skin.triangles)
        held = (edges >= display.moving).any(axis=1)
        for chosen, colour in ((edges[~held], SOLVED), (edges[held], HELD)):
            self.add(_lines(drawn, chosen, colour))


def _lines(drawn: Drawn, edges: IntArray, colour: tuple[float, float, float]) -> vtkActor:
    actor = companion(drawn.figure.skin.surface, edges)
    mapper = actor.GetMapper()
    mapper.SetResolveCoincidentTopologyToPolygonOffset()
    mapper.SetRelativeCoincidentTopologyLineOffsetParameters(-1.0, -4.0)
    shown = actor.GetProperty()
    shown.SetColor(*colour)
    shown.SetLighting(False)
    shown.SetLineWidth(1.0)
    return actor

"""Ellipses on the skin: how stiff it is along and across its grain."""

from __future__ import annotations

import numpy as np
from scipy.spatial import cKDTree

from app.view_state import ViewState
from facemodel.face import Face
from fem.types import Float32Array, FloatArray, IntArray
from ui.viewport.overlays.iso_lines import LIFT, Lines
from ui.viewport.overlays.overlay import Drawn
from ui.viewport.overlays.supports import points_of_vertices
from ui.workspaces.workspace import Parts

SPACING = 8.0
"""Millimetres between two ellipses."""

LARGEST = 3.4
"""Half the longer axis, millimetres, of the ellipse of the stiffest place."""

SMALLEST = 0.25
"""Least share of the longest half axis: a softer place still shows its direction."""

AROUND = 20
INK = (0.97, 0.97, 0.95)

BENDING = "bending"


class Glyphs:
    """Ellipses of stretching, or of bending while a layer of bending is in hand; axes are as long as it is stiff."""

    def __init__(self, parts: Parts) -> None:
        self._parts = parts
        self._view = parts.context.view
        self._lines = Lines(INK, 1.4)
        self._on = False
        self._dirty = True
        self._places: tuple[Face, IntArray] | None = None
        document = parts.context.document
        for signal in (document.project_changed, document.layers_changed, document.expression_changed):
            signal.connect(self._stale)
        document.solution_changed.connect(self._stale)
        self._view.changed.connect(self._look)
        parts.viewport.canvas.before_frame.append(self._follow)

    def switch(self, on: bool) -> None:
        """Begin to draw, or take the ellipses off."""
        renderer = self._parts.viewport.scene.renderer
        renderer.AddViewProp(self._lines.actor) if on else renderer.RemoveViewProp(self._lines.actor)
        self._on = on
        self._stale()

    def _stale(self, *_now: object) -> None:
        self._dirty = True

    def _look(self, now: ViewState, before: ViewState) -> None:
        if (now.glyphs, now.layer) != (before.glyphs, before.layer):
            self._stale()

    def _follow(self) -> None:
        if not self._dirty:
            return
        self._dirty = False
        drawn, state = self._parts.viewport.scene.drawn, self._view.state
        face = self._parts.context.document.project.face
        fits = drawn is not None and len(drawn.project.face.skin.positions) == len(face.skin.positions)
        if drawn is None or not fits or not (self._on and state.glyphs):
            self._lines.hide()
            return
        ends = _ellipses(face, drawn, self._places_on(face), state.layer.startswith(BENDING))
        self._lines.show(ends)

    def _places_on(self, face: Face) -> IntArray:
        if self._places is None or self._places[0].skin is not face.skin:
            self._places = face, scattered(face)
        return self._places[1]


def scattered(face: Face) -> IntArray:
    """Vertices of the solved skin that are `SPACING` apart: in every round those that are first among neighbours."""
    solved = np.unique(face.skin.triangles[face.solved])
    near = cKDTree(face.skin.positions[solved]).query_pairs(SPACING, output_type="ndarray")
    rank = np.random.default_rng(0).permutation(len(solved))
    open_, chosen = np.ones(len(solved), dtype=np.bool_), np.zeros(len(solved), dtype=np.bool_)
    while open_.any():
        pairs = near[open_[near].all(axis=1)]
        beaten = np.where(rank[pairs[:, 0]] < rank[pairs[:, 1]], pairs[:, 1], pairs[:, 0])
        first = open_.copy()
        first[beaten] = False
        chosen |= first
        open_ &= ~first
        open_[near[first[near[:, 0]], 1]] = False
        open_[near[first[near[:, 1]], 0]] = False
    return np.asarray(solved[chosen])


def _ellipses(face: Face, drawn: Drawn, vertices: IntArray, bending: bool) -> Float32Array:
    """Ends (2 n, 3) of the segments of all ellipses on the posed skin."""
    posed = drawn.figure.posed
    at = points_of_vertices(face, posed.basis.display)[vertices]
    normal = posed.normals[at].astype(np.float64)
    along = face.layers.direction[vertices]
    along = along - np.einsum("ij,ij->i", along, normal)[:, None] * normal
    along /= np.maximum(np.linalg.norm(along, axis=1, keepdims=True), 1e-9)
    across = np.cross(normal, along)
    stiff: FloatArray = (face.layers.bending if bending else face.layers.stretching)[:, :2]
    size = LARGEST * np.maximum(stiff[vertices] / max(float(stiff.max()), 1e-12), SMALLEST)
    turn = np.linspace(0, 2 * np.pi, AROUND + 1)
    ring = (
        (posed.points[at] + 2 * LIFT * normal)[:, None]
        + np.cos(turn)[:, None] * (size[:, :1] * along)[:, None]
        + np.sin(turn)[:, None] * (size[:, 1:] * across)[:, None]
    )
    ends = np.stack([ring[:, :-1], ring[:, 1:]], axis=2)
    return ends.reshape(-1, 3).astype(np.float32)

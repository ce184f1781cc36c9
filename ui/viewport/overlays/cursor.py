"""The cursor of the brush: a ring of its geodesic radius that hugs the skin, and another where its image paints."""

from __future__ import annotations

import numpy as np

from app.tools.ground import Ground
from app.tools.pointer import Hit
from app.tools.sight import Ring
from facemodel.display import DisplaySurface
from facemodel.face import Face
from facemodel.painting.geodesic import SurfacePoint
from facemodel.painting.surface import PaintSurface
from fem.types import Float32Array, FloatArray
from ui.viewport.overlays.iso_lines import Crossings, Lines, crossings, drawn_on
from ui.viewport.overlays.overlay import Drawn
from ui.workspaces.workspace import Parts

OUTER, CORE, IMAGE = (1.0, 1.0, 1.0), (0.80, 0.80, 0.80), (0.80, 0.80, 0.80)
SHADOW = (0.16, 0.15, 0.16)
AROUND = 48
ABOVE = 0.3
"""Millimetres by which the ring lies above the skin; its shadow is below it."""

SHORT = 1e-6
"""Millimetres; less than between any two places that are told apart."""

BEYOND = 1.5
"""Distances are asked for beyond the radius by this factor, so that there are some on both sides of the ring."""

FLAT = 5.0
"""Millimetres; a ring smaller than this lies within a triangle or two, and skin is as good as flat there."""


class BrushRing:
    """Draws the ring that the brush asks for, as soon as distances on this skin are known."""

    def __init__(self, parts: Parts) -> None:
        self._viewport = parts.viewport
        self._ground: Ground = parts.bench.ground
        self._ring: Ring | None = None
        self._lines = {
            "shadow": Lines(SHADOW, 3.6, nearer=2.0),
            "outer": Lines(OUTER, 1.8, nearer=40.0),
            "core": Lines(CORE, 1.2),
            "image": Lines(IMAGE, 1.2),
        }
        self._on = False
        parts.bench.sight.ring_changed.connect(self._take)

    def switch(self, on: bool) -> None:
        """Begin to draw, or take the ring off."""
        renderer = self._viewport.scene.renderer
        for lines in self._lines.values():
            renderer.AddViewProp(lines.actor) if on else renderer.RemoveViewProp(lines.actor)
        self._on = on
        self._take(None)

    def _take(self, ring: Ring | None) -> None:
        self._ring = ring
        drawn = self._viewport.scene.drawn
        if not self._on or drawn is None:
            return
        for lines in self._lines.values():
            lines.hide()
        if ring is not None:
            self._draw(ring, drawn)
        self._viewport.canvas.ask_frame()

    def _draw(self, ring: Ring, drawn: Drawn) -> None:
        surface = self._ground.surface(drawn.project.face)
        outer = _circle(surface, drawn, ring.hit, ring.radius)
        self._lines["shadow"].show(outer)
        self._lines["outer"].show(outer)
        if 0.05 < ring.core < 0.95:
            self._lines["core"].show(_circle(surface, drawn, ring.hit, ring.core * ring.radius))
        if ring.mirrored is not None:
            self._lines["image"].show(_circle(surface, drawn, ring.mirrored, ring.radius))


def _circle(surface: PaintSurface, drawn: Drawn, hit: Hit, radius: float) -> Float32Array:
    """Ends (2 n, 3) of segments on the posed skin; a flat circle while it is small or distances are not known yet."""
    face, posed = drawn.project.face, drawn.figure.posed
    if radius < FLAT or "geodesics" not in vars(surface):
        return _flat(face, posed.points, posed.normals, posed.basis.display, hit, radius)
    display, reach = posed.basis.display, BEYOND * radius
    ball = surface.geodesics.within(SurfacePoint(hit.triangle, hit.barycentric), reach)
    # Triangles of the skin are coarse, and distance is far from linear on them; how much longer the way on the skin is
    # than through the air is nearly so.  Beyond the ball it is at least as long as that is wide.
    through = np.maximum(np.linalg.norm(face.skin.positions - hit.position, axis=1), SHORT)
    away = np.full(len(through), reach)
    away[ball.vertices] = ball.distances
    longer = np.maximum(away / through, 1.0)
    inside = np.zeros(len(through), dtype=np.bool_)
    inside[ball.vertices] = True
    triangles = drawn_on(display, np.flatnonzero(inside[face.skin.triangles].any(axis=1)))
    points, local = np.unique(triangles, return_inverse=True)
    air = np.linalg.norm(display.points[points] - hit.position, axis=1)
    corners = face.skin.triangles[display.elements[points]]
    at = air * np.einsum("pk,pk->p", display.barycentric[points], longer[corners])
    found = crossings(at, local.reshape(-1, 3), np.array([radius]))
    ends = Crossings(points[found.one], points[found.other], found.share)
    return ends.on(posed.points, posed.normals, ABOVE)


def _flat(
    face: Face, points: Float32Array, normals: Float32Array, display: DisplaySurface, hit: Hit, radius: float
) -> Float32Array:
    corners = face.skin.triangles[hit.triangle]
    rest = face.skin.positions[corners]
    candidates = np.flatnonzero(display.elements == hit.triangle)
    if len(candidates):
        there = display.barycentric[candidates] @ rest
        at = int(candidates[np.linalg.norm(there - hit.position, axis=1).argmin()])
        moved: FloatArray = points[at] - display.points[at]
        normal: FloatArray = normals[at].astype(np.float64)
    else:
        moved, normal = np.zeros(3), hit.normal
    across = np.cross(normal, [0.0, 1.0, 0.0] if abs(normal[1]) < 0.9 else [1.0, 0.0, 0.0])
    across /= np.linalg.norm(across)
    up = np.cross(normal, across)
    turn = np.linspace(0, 2 * np.pi, AROUND + 1)
    ring = (
        hit.position + moved + ABOVE * normal + radius * (np.cos(turn)[:, None] * across + np.sin(turn)[:, None] * up)
    )
    return np.repeat(ring, 2, axis=0)[1:-1].astype(np.float32)

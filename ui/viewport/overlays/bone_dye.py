"""Which bone is jaw and which is selected, as colours on the bone, and the ball of the brush about the pointer."""

from __future__ import annotations

import numpy as np

from app.tools.bone_brush import BoneBrush
from app.tools.bone_lasso import BoneLasso
from app.tools.bone_part import BonePart
from app.tools.jaw_axis import JawAxisTool
from app.tools.sight import Ball
from facemodel.skull.jaw_region import whole_skull
from facemodel.skull.placement import carried
from fem.types import FloatArray
from ui.viewport.overlays.marks import Colour, Marks, chain
from ui.viewport.overlays.solids import circle
from ui.workspaces.workspace import Parts

SELECTED: Colour = (0.949, 0.518, 0.361)
JAW: Colour = (0.40, 0.58, 0.78)
COVER_SELECTED, COVER_JAW = 0.82, 0.42

JAW_TOOLS = (BoneBrush, BoneLasso, BonePart, JawAxisTool)
"""Tools in whose hands it is told which bone is jaw."""

RING: Colour = (1.0, 1.0, 1.0)
SHADOW: Colour = (0.16, 0.15, 0.16)


class BoneDye:
    """Dyes the bone: what is selected in the accent, and the jaw while it is worked on."""

    def __init__(self, parts: Parts) -> None:
        self._parts = parts
        self._scene, self._canvas = parts.viewport.scene, parts.viewport.canvas
        self._rings = (Marks(SHADOW, 3.6, lines=True), Marks(RING, 1.6, lines=True))
        self._ball: Ball | None = None
        self._on = self._due = False
        document = parts.context.document
        for signal in (parts.bench.bones.changed, document.skull_changed, document.project_changed):
            signal.connect(self._ask)
        parts.toolbox.tool_changed.connect(self._ask)
        parts.bench.sight.ball_changed.connect(self._take_ball)
        self._canvas.before_frame.append(self._before_frame)

    def switch(self, on: bool) -> None:
        """Begin to dye, or leave the bone as it is."""
        for ring in self._rings:
            renderer = self._scene.renderer
            renderer.AddViewProp(ring.actor) if on else renderer.RemoveViewProp(ring.actor)
            ring.hide()
        self._on = on
        if not on:
            self._scene.skull.dye(None)
        self._ask()

    def _ask(self, *_what: object) -> None:
        if self._on:
            self._due = True
            self._canvas.ask_frame()

    def _take_ball(self, ball: Ball | None) -> None:
        self._ball = ball
        if self._on:
            self._canvas.ask_frame()

    def _before_frame(self) -> None:
        if not self._on:
            return
        if self._due:
            self._due = False
            self._scene.skull.dye(self._dyes())
        self._draw_ball()

    def _dyes(self) -> tuple[FloatArray, FloatArray] | None:
        """Colours and cover (n, 4) of the vertices of both bones."""
        skull = self._parts.context.document.project.face.skull
        selected = self._parts.bench.bones.selected(skull)
        tells_jaw = isinstance(self._parts.toolbox.tool, JAW_TOOLS)
        if selected is None and not tells_jaw:
            return None
        own = len(skull.cranium.positions)
        corners = whole_skull(skull).corners
        dye = np.zeros((len(corners), 4))
        if tells_jaw:
            dye[own:] = (*JAW, COVER_JAW)
        if selected is not None:
            dye[selected[corners]] = (*SELECTED, COVER_SELECTED)
        return dye[:own], dye[own:]

    def _draw_ball(self) -> None:
        ball, drawn, projector = self._ball, self._scene.drawn, self._parts.bench.projector
        if ball is None or drawn is None or projector is None:
            for ring in self._rings:
                ring.hide()
            return
        centre = ball.centre
        if ball.surface == "mandible":
            centre = carried(centre[None], self._scene.skull.jaw(drawn))[0]
        ends = chain(circle(centre, projector.towards(centre), ball.radius, 64))
        for ring in self._rings:
            ring.show(ends)

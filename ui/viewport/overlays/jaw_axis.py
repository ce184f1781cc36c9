"""The axis of the jaw with an end at each condyle, as long as it is worked on."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from app.tools.jaw_axis import JawAxisTool
from app.view_state import ViewState
from fem.types import FloatArray
from ui.viewport.overlays.marks import Colour, Marks, chain
from ui.viewport.overlays.solids import circle
from ui.workspaces.workspace import Parts

LEFT: Colour = (0.353, 0.694, 0.941)
RIGHT: Colour = (0.941, 0.478, 0.588)
LINE: Colour = (0.97, 0.97, 0.95)
GROUND: Colour = (0.13, 0.14, 0.15)
HELD: Colour = (1.0, 0.86, 0.42)

BEYOND = 0.35
"""How far the line goes on beyond both ends, as a share of it."""

DOT, RING = 9.0, 8.0
"""Pixels: diameter of an end, and radius of the ring about the one that would be taken."""


class JawAxis:
    """Draws the axis while its tool is in hand or a turn of the jaw is looked at."""

    def __init__(self, parts: Parts) -> None:
        self._parts = parts
        self._viewport, self._document = parts.viewport, parts.context.document
        self._marks = {
            "beyond": Marks(LINE, 1.0, lines=True),
            "ground": Marks(GROUND, 4.2, lines=True),
            "line": Marks(LINE, 2.0, lines=True),
            "rim": Marks(GROUND, DOT + 4),
            "right": Marks(RIGHT, DOT),
            "left": Marks(LEFT, DOT),
            "ring": Marks(HELD, 2.0, lines=True),
        }
        self._marks["beyond"].actor.GetProperty().SetOpacity(0.5)
        self._axis: FloatArray | None = None
        self._end: int | None = None
        self._on = False
        sight = parts.bench.sight
        sight.axis_changed.connect(self._take_axis)
        sight.end_changed.connect(self._take_end)
        parts.toolbox.tool_changed.connect(self._ask)
        parts.context.view.changed.connect(self._look)
        self._document.skull_changed.connect(self._ask)
        self._viewport.canvas.before_frame.append(self._before_frame)

    def switch(self, on: bool) -> None:
        """Begin to draw, or take the axis off."""
        renderer = self._viewport.scene.renderer
        for marks in self._marks.values():
            renderer.AddViewProp(marks.actor) if on else renderer.RemoveViewProp(marks.actor)
        self._on, self._axis, self._end = on, None, None
        self._viewport.scene.skull.hinge = None
        self._ask()

    def _take_axis(self, axis: FloatArray | None) -> None:
        """The jaw turns about the axis in the hand."""
        if not self._on or (axis is None and self._axis is None):
            return
        self._axis = axis
        scene, jaw = self._viewport.scene, self._document.project.face.skull.jaw
        scene.skull.hinge = None if axis is None else replace(jaw, axis=axis)
        if scene.drawn is not None and scene.skull.shown:
            scene.skull.follow(scene.drawn)
        self._ask()

    def _take_end(self, end: int | None) -> None:
        if end != self._end:
            self._end = end
            self._ask()

    def _look(self, now: ViewState, before: ViewState) -> None:
        if now.jaw_tried != before.jaw_tried:
            self._ask()

    def _ask(self, *_what: object) -> None:
        if self._on:
            self._viewport.canvas.ask_frame()

    def _before_frame(self) -> None:
        """Drawn anew for every frame, since the ring is as large on the screen at every zoom."""
        if not self._on:
            return
        projector, state = self._parts.bench.projector, self._parts.context.view.state
        for marks in self._marks.values():
            marks.hide()
        if projector is None or not (isinstance(self._parts.toolbox.tool, JawAxisTool) or state.jaw_tried):
            return
        axis = self._document.project.face.skull.jaw.axis if self._axis is None else self._axis
        right, left = axis
        beyond = BEYOND * (left - right)
        self._marks["beyond"].show(np.array([right - beyond, left + beyond]))
        for name, places in {"ground": axis, "line": axis, "rim": axis, "right": axis[:1], "left": axis[1:]}.items():
            self._marks[name].show(places)
        if self._end is not None:
            at = axis[self._end]
            self._marks["ring"].show(chain(circle(at, projector.towards(at), RING * projector.millimetres(at))))

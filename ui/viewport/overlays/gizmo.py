"""The handles that move, turn and scale the skull, drawn as large on the screen at every zoom."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from PySide6.QtGui import QCursor

from app.tools.gizmo import FREE, RING, START, Gizmo, Part, gizmo_of
from app.tools.place_skull import PlaceTool
from app.tools.pose_text import told
from app.tools.tool import Tool
from facemodel.face import Pose
from facemodel.skull.placement import way_between
from fem.types import FloatArray
from ui.viewport.overlays.marks import Colour, Marks, chain
from ui.viewport.overlays.solids import Solids, box, circle, cone
from ui.workspaces.workspace import Parts

AXES: tuple[Colour, ...] = ((0.91, 0.36, 0.37), (0.47, 0.75, 0.38), (0.33, 0.60, 0.94))
"""x red, y green, z blue, as everywhere."""

MIDDLE: Colour = (0.93, 0.94, 0.95)
GROUND: Colour = (0.16, 0.17, 0.18)
HELD: Colour = (1.0, 0.86, 0.42)

SHAFT, THICK, HALO = 2.4, 3.6, 2.0
"""Pixels: width of a line, of the one that would be taken, and by how much its dark ground is wider."""

BRIGHTER = 0.35
"""How far the handle that would be taken goes to white."""

HEAD, HEAD_RADIUS, BOX = 0.17, 0.052, 0.042
"""Length and radius of an arrow's head, and half a box, as shares of an arm."""

BEHIND, ASIDE = 0.28, 0.22
"""Opacity of what lies behind, and of the other handles while one is held."""

GUIDE = 40.0
"""Arms that the line along a held axis reaches both ways."""


@dataclass(frozen=True, eq=False)
class _Look:
    """How one handle is drawn: colour, width of its lines, opacity."""

    colour: Colour
    width: float
    opacity: float


class SkullGizmo:
    """Draws the handles of the tool in hand, and the bone where it is dragged."""

    def __init__(self, parts: Parts) -> None:
        self._parts = parts
        self._viewport = parts.viewport
        self._pose: Pose | None = None
        self._part: Part | None = None
        self._on = False
        self._lines = [(Marks(GROUND, 1.0, lines=True), Marks(MIDDLE, 1.0, lines=True)) for _ in range(4)]
        self._far = [Marks(MIDDLE, 1.0, lines=True) for _ in range(4)]
        self._heads = [Solids(MIDDLE) for _ in range(3)]
        self._guide = Marks(MIDDLE, 1.0, lines=True)
        sight = parts.bench.sight
        sight.pose_changed.connect(self._take_pose)
        sight.part_changed.connect(self._take_part)
        parts.toolbox.tool_changed.connect(self._ask)
        parts.toolbox.busy_changed.connect(self._ask)
        self._viewport.canvas.before_frame.append(self._before_frame)

    @property
    def _props(self) -> list[Marks | Solids]:
        near = [marks for pair in self._lines for marks in pair]
        return [self._guide, *self._far, *near, *self._heads]

    @property
    def _tool(self) -> PlaceTool | None:
        tool: Tool = self._parts.toolbox.tool
        return tool if isinstance(tool, PlaceTool) else None

    def switch(self, on: bool) -> None:
        """Begin to draw, or take the handles off."""
        renderer = self._viewport.scene.renderer
        for each in self._props:
            renderer.AddViewProp(each.actor) if on else renderer.RemoveViewProp(each.actor)
        self._on, self._part, self._pose = on, None, None
        self._ask()

    def _take_pose(self, pose: Pose | None) -> None:
        """Draw the bone where the hand has it, or where the project has it again."""
        if not self._on or (pose is None and self._pose is None):
            return
        self._pose = pose
        scene, skull = self._viewport.scene, self._parts.context.document.project.face.skull
        if scene.drawn is not None:
            scene.skull.carry(scene.drawn, np.eye(4) if pose is None else way_between(skull, pose))
        self._say()
        self._ask()

    def _take_part(self, part: Part | None) -> None:
        if part != self._part:
            self._part = part
            self._ask()

    def _say(self) -> None:
        """What the hand has done so far, beside the pointer."""
        start = self._parts.context.document.project.face.skull.placement.pose
        text = "" if self._pose is None or self._part is None else told(start, self._pose, self._part)
        self._viewport.pointer.say(text, self._viewport.canvas.mapFromGlobal(QCursor.pos()))

    def _ask(self, *_what: object) -> None:
        if self._on:
            self._viewport.canvas.ask_frame()

    def _before_frame(self) -> None:
        """Draw anew for every frame: the camera may have moved, and there is little to draw."""
        if not self._on:
            return
        for each in self._props:
            each.hide()
        tool, projector = self._tool, self._parts.bench.projector
        if tool is None or projector is None or self._viewport.scene.drawn is None:
            return
        skull = self._parts.context.document.project.face.skull
        gizmo = gizmo_of(skull, tool.mode, projector.millimetres, self._pose)
        towards = projector.towards(gizmo.centre)
        for axis in range(3):
            self._draw_ring(gizmo, axis, towards) if tool.mode == "turn" else self._draw_arm(gizmo, axis)
        if tool.mode != "turn":
            around = circle(gizmo.centre, towards, 0.72 * START * gizmo.arm)
            self._draw_line(FREE, around, self._look(gizmo, FREE))
        self._draw_guide(gizmo)

    def _draw_arm(self, gizmo: Gizmo, axis: int) -> None:
        look, along = self._look(gizmo, axis), gizmo.arm * gizmo.axes[axis]
        end = gizmo.centre + (1 - HEAD if gizmo.mode == "move" else 1 - BOX) * along
        self._draw_line(axis, np.array([gizmo.centre + START * along, end]), look)
        if gizmo.mode == "move":
            shape = cone(end, HEAD * along, HEAD_RADIUS * gizmo.arm)
        else:
            shape = box(gizmo.centre + along, gizmo.axes, BOX * gizmo.arm)
        self._heads[axis].show(*shape, look.colour, look.opacity)

    def _draw_ring(self, gizmo: Gizmo, axis: int, towards: FloatArray) -> None:
        """Bright where it is turned to the eye, faint behind."""
        ring, look = gizmo.ring(axis), self._look(gizmo, axis)
        middles = (ring[:-1] + ring[1:]) / 2 - gizmo.centre
        near = middles @ towards > -0.02 * RING * gizmo.arm
        segments = np.stack([ring[:-1], ring[1:]], axis=1)
        self._draw_line(axis, segments[near].reshape(-1, 3), look, joined=False)
        _styled(self._far[axis], look.colour, 1.0, BEHIND * look.opacity).show(segments[~near].reshape(-1, 3))

    def _draw_line(self, number: int, places: FloatArray, look: _Look, joined: bool = True) -> None:
        ends = chain(places) if joined else places
        ground, line = self._lines[number]
        if look.opacity == 1.0:
            # Only what is opaque is drawn in the order of the actors, the dark ground below the line.
            _styled(ground, GROUND, look.width + HALO, 1.0).show(ends)
        _styled(line, look.colour, look.width, look.opacity).show(ends)

    def _draw_guide(self, gizmo: Gizmo) -> None:
        """A long thin line along the axis that is held."""
        part = self._part
        if part is None or part.axis == FREE or not self._parts.toolbox.busy:
            return
        along = GUIDE * gizmo.arm * gizmo.axes[part.axis]
        ends = np.array([gizmo.centre - along, gizmo.centre + along])
        _styled(self._guide, AXES[part.axis], 1.0, 0.55).show(ends)

    def _look(self, gizmo: Gizmo, axis: int) -> _Look:
        own = MIDDLE if axis == FREE else AXES[axis]
        if self._part != Part(gizmo.mode, axis):
            return _Look(own, SHAFT, ASIDE if self._parts.toolbox.busy else 1.0)
        if self._parts.toolbox.busy:
            return _Look(HELD, THICK, 1.0)
        red, green, blue = (BRIGHTER + (1 - BRIGHTER) * share for share in own)
        return _Look((red, green, blue), THICK, 1.0)


def _styled(marks: Marks, colour: Colour, width: float, opacity: float) -> Marks:
    shown = marks.actor.GetProperty()
    shown.SetColor(*colour)
    shown.SetLineWidth(width)
    shown.SetOpacity(opacity)
    return marks

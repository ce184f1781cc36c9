"""What a hand can take hold of in the selected muscles: ends, bends, rings, and whatever is measured by a handle."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from app.tools.sight import Ghost, Grip
from app.view_state import ViewState
from facemodel.laying.handles import handles
from facemodel.muscles import Muscle
from facemodel.project import Project
from fem.types import FloatArray
from ui.viewport.overlays.dots import Dots
from ui.viewport.overlays.glow import ACCENT
from ui.viewport.overlays.iso_lines import Lines, crossings
from ui.viewport.overlays.marks import Marks
from ui.viewport.overlays.muscle_outlines import on_skin, outlines, place_of, reach, spoke
from ui.viewport.overlays.on_skin import OnSkin
from ui.viewport.overlays.overlay import Drawn
from ui.workspaces.workspace import Parts

GROUND = (0.09, 0.10, 0.11)
BONE = (0.93, 0.89, 0.82)
QUIET = (0.62, 0.70, 0.78)
HELD = (1.0, 1.0, 1.0)

KINDS = {"origin": "bone", "attachment": "skin", "via": "bone"}
"""Which dots stand for handles by what they move; the others are quiet."""


class MuscleHandles:
    """Draws handles and lines of the selected muscles, and of those in the hand instead while it drags."""

    def __init__(self, parts: Parts) -> None:
        self._viewport, self._view, self._document = parts.viewport, parts.context.view, parts.context.document
        self._marks = {
            "line": Marks(GROUND, 4.0, lines=True),
            "body": Marks(ACCENT, 1.8, lines=True, rank=1),
            "edges": Marks(QUIET, 1.4, lines=True, rank=1),
            "spoke": Marks(QUIET, 1.0, lines=True, rank=1),
        }
        self._dots = {
            "quiet": Dots(QUIET, 12.0, rank=2),
            "bone": Dots(BONE, 13.0, rank=3),
            "skin": Dots(ACCENT, 13.0, rank=3),
            "grip": Dots(HELD, 16.0, rank=4),
        }
        self._reach = Lines(QUIET, 1.4)
        self._ghost: Ghost | None = None
        self._grip: Grip | None = None
        self._on = False
        self._due = False
        sight, document = parts.bench.sight, self._document
        sight.ghost_changed.connect(self._take_ghost)
        sight.grip_changed.connect(self._take_grip)
        self._view.changed.connect(self._follow)
        for signal in (
            document.muscles_changed,
            document.project_changed,
            document.expression_changed,
            document.solution_changed,
        ):
            signal.connect(self._ask)
        parts.viewport.canvas.before_frame.append(self._before_frame)

    def switch(self, on: bool) -> None:
        """Begin to draw, or take all handles off."""
        renderer = self._viewport.scene.renderer
        for drawing in (*self._marks.values(), *self._dots.values(), self._reach):
            renderer.AddViewProp(drawing.actor) if on else renderer.RemoveViewProp(drawing.actor)
        self._on = on
        self._ghost = self._grip = None
        self._ask()

    def _take_ghost(self, ghost: Ghost | None) -> None:
        self._ghost = ghost if ghost is not None and ghost.muscles else None
        self._ask()

    def _take_grip(self, grip: Grip | None) -> None:
        if grip is not self._grip:
            self._grip = grip
            self._ask()

    def _follow(self, now: ViewState, before: ViewState) -> None:
        if (now.selected, now.hidden, now.locked) != (before.selected, before.hidden, before.locked):
            self._grip = None
            self._ask()

    def _ask(self, *_what: object) -> None:
        if self._on:
            self._due = True
            self._viewport.canvas.ask_frame()

    def _before_frame(self) -> None:
        drawn = self._viewport.scene.drawn
        if self._on and self._due and drawn is not None:
            self._due = False
            self._draw(drawn)

    def _draw(self, drawn: Drawn) -> None:
        project = self._document.project
        muscles = self._ghost.muscles if self._ghost else _selected(project, self._view.state)
        at = OnSkin(drawn)
        lines = [outlines(muscle, project.face, at) for muscle in muscles]
        body = _stacked(piece for each in lines for piece in each.body)
        self._marks["line"].show(body)
        self._marks["body"].show(body)
        self._marks["edges"].show(_stacked(piece for each in lines for piece in each.edges))
        self._reach.show(_stacked(_end_of_influence(muscle, drawn) for muscle in muscles))
        locked = self._view.state.locked
        found = [
            (muscle, handle)
            for muscle in muscles
            if muscle.key not in locked
            for handle in handles(muscle, project.face)
        ]
        self._marks["spoke"].show(_stacked(spoke(muscle, handle, project.face, at) for muscle, handle in found))
        places: dict[str, list[FloatArray]] = {"bone": [], "skin": [], "quiet": []}
        for muscle, handle in found:
            kind = KINDS.get(handle.part, "quiet")
            kind = "skin" if kind == "bone" and on_skin(muscle, handle) else kind
            places[kind].append(place_of(muscle, handle, at)[None])
        for kind, points in places.items():
            self._dots[kind].show(_stacked(points))
        grip = self._grip if self._ghost is None else None
        self._dots["grip"].show(_stacked([place_of(grip.muscle, grip.handle, at)[None]] if grip else []))


def _end_of_influence(muscle: Muscle, drawn: Drawn) -> FloatArray:
    """Segments on the posed skin where the influence of a muscle ends sharply."""
    display, posed = drawn.figure.posed.basis.display, drawn.figure.posed
    found = reach(muscle, display.points.astype(np.float64))
    if found is None:
        return np.zeros((0, 3))
    ends = crossings(found[0], display.triangles, np.array([found[1]]))
    return ends.on(posed.points, posed.normals).astype(np.float64)


def _selected(project: Project, state: ViewState) -> tuple[Muscle, ...]:
    return tuple(muscle for muscle in project.muscles if muscle.key in state.selected - state.hidden)


def _stacked(pieces: Iterable[FloatArray]) -> FloatArray:
    return np.concatenate([np.zeros((0, 3)), *pieces])

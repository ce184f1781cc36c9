"""What a hand can take hold of in the selected muscles: their ends, bends, radii, rings and boxes."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np

from app.tools.sight import Ghost, Grip
from app.view_state import ViewState
from facemodel.laying.handles import Handle, handles
from facemodel.muscles import Muscle
from facemodel.muscles.curve import path
from facemodel.muscles.models import MODELS
from facemodel.project import Project
from fem.types import FloatArray
from ui.viewport.overlays.glow import ACCENT
from ui.viewport.overlays.marks import Marks, chain
from ui.viewport.overlays.overlay import Drawn
from ui.viewport.overlays.supports import points_of_vertices
from ui.workspaces.workspace import Parts

GROUND = (0.09, 0.10, 0.11)
BONE = (0.93, 0.89, 0.82)
QUIET = (0.62, 0.70, 0.78)
HELD = (1.0, 1.0, 1.0)

KINDS = {"origin": BONE, "attachment": ACCENT, "via": BONE}
"""Colours of handles by what they move; the others are quiet."""

ON_SKIN = ("attachment", "centre", "long", "short", "radius")
STEPS = 16
AROUND = 64


class MuscleHandles:
    """Draws the handles and central fibres of the selected muscles, and of those in the hand instead while it drags."""

    def __init__(self, parts: Parts) -> None:
        self._viewport, self._view, self._document = parts.viewport, parts.context.view, parts.context.document
        self._bench = parts.bench
        self._marks = {
            "line": Marks(GROUND, 4.0, lines=True),
            "fibre": Marks(ACCENT, 1.8, lines=True, rank=1),
            "spoke": Marks(QUIET, 1.0, lines=True, rank=1),
            "ground": Marks(GROUND, 12.0, rank=2),
            "quiet": Marks(QUIET, 8.0, rank=3),
            "bone": Marks(BONE, 8.0, rank=3),
            "skin": Marks(ACCENT, 8.0, rank=3),
            "grip": Marks(HELD, 13.0, rank=4),
        }
        self._ghost: Ghost | None = None
        self._grip: Grip | None = None
        self._on = False
        self._due = False
        sight, document = parts.bench.sight, self._document
        sight.ghost_changed.connect(self._take_ghost)
        sight.grip_changed.connect(self._take_grip)
        self._view.changed.connect(self._follow)
        document.muscles_changed.connect(self._ask)
        document.project_changed.connect(self._ask)
        document.expression_changed.connect(self._ask)
        document.solution_changed.connect(self._ask)
        parts.viewport.canvas.before_frame.append(self._before_frame)

    def switch(self, on: bool) -> None:
        """Begin to draw, or take all handles off."""
        renderer = self._viewport.scene.renderer
        for marks in self._marks.values():
            renderer.AddViewProp(marks.actor) if on else renderer.RemoveViewProp(marks.actor)
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
        lines = [_line(muscle, at) for muscle in muscles]
        ends = np.concatenate(lines) if lines else np.zeros((0, 3))
        self._marks["line"].show(ends)
        self._marks["fibre"].show(ends)
        locked = self._view.state.locked
        free = [muscle for muscle in muscles if muscle.key not in locked]
        found = [(muscle, handle) for muscle in free for handle in handles(muscle, project.face)]
        self._marks["spoke"].show(_stacked([_spoke(muscle, handle, at) for muscle, handle in found]))
        places = {"bone": [], "skin": [], "quiet": []}  # type: dict[str, list[FloatArray]]
        for _, handle in found:
            kind = {BONE: "bone", ACCENT: "skin"}.get(KINDS.get(handle.part, QUIET), "quiet")
            places[kind].append(at.place(handle))
        for kind, points in places.items():
            self._marks[kind].show(_stacked([point[None] for point in points]))
        self._marks["ground"].show(_stacked([point[None] for points in places.values() for point in points]))
        grip = self._grip if self._ghost is None else None
        self._marks["grip"].show(_stacked([at.place(grip.handle)[None]] if grip else []))


class OnSkin:
    """Where places of the face at rest are on the posed one."""

    def __init__(self, drawn: Drawn) -> None:
        self._face = drawn.project.face
        display, posed = drawn.figure.posed.basis.display, drawn.figure.posed.points
        self._moved = bool(drawn.expression)
        self._shift = posed - display.points if self._moved else None
        self._points = points_of_vertices(self._face, display) if self._moved else None

    def shift(self, point: FloatArray) -> FloatArray:
        """How far (3,) the skin nearest to a place has gone."""
        if self._shift is None or self._points is None:
            return np.zeros(3)
        vertex = int(self._face.skin.tree.query(point)[1])
        return np.asarray(self._shift[self._points[vertex]], dtype=np.float64)

    def place(self, handle: Handle) -> FloatArray:
        """Where a handle is seen."""
        return handle.point + self.shift(handle.point) if handle.part in ON_SKIN else handle.point


def _selected(project: Project, state: ViewState) -> tuple[Muscle, ...]:
    return tuple(muscle for muscle in project.muscles if muscle.key in state.selected - state.hidden)


def _line(muscle: Muscle, at: OnSkin) -> FloatArray:
    """Segments of the central fibres, which end where the skin has gone, or of the ellipse of a ring."""
    if MODELS[muscle.model].geometry == "fibres":
        share = np.linspace(0.0, 1.0, STEPS + 1)[:, None] ** 2
        runs = [path(fibre, STEPS) + share * at.shift(fibre.attachment) for fibre in muscle.fibres]
        return _stacked([chain(run) for run in runs])
    if muscle.ring is None:
        return np.zeros((0, 3))
    ring, turn = muscle.ring, np.linspace(0.0, 2 * np.pi, AROUND, endpoint=False)[:, None]
    ellipse = ring.centre + np.cos(turn) * ring.long_axis + np.sin(turn) * ring.short_axis
    return chain(ellipse + at.shift(ring.centre), closed=True)


def _spoke(muscle: Muscle, handle: Handle, at: OnSkin) -> FloatArray:
    """From what a handle measures to the handle."""
    if handle.part in ("origin", "attachment", "via", "centre"):
        return np.zeros((0, 3))
    fibres = MODELS[muscle.model].geometry == "fibres"
    centre = muscle.fibres[handle.fibre].attachment if fibres or muscle.ring is None else muscle.ring.centre
    return np.array([centre + at.shift(centre), at.place(handle)])


def _stacked(pieces: Iterable[FloatArray]) -> FloatArray:
    return np.concatenate([np.zeros((0, 3)), *pieces])

"""A skull from elsewhere while it is fitted: its bone, what is picked on it, and where that should lie."""

from __future__ import annotations

import numpy as np
from PySide6.QtGui import QCursor

from app.skull_fitting import SkullFitting, title_of
from facemodel.mesh import Mesh
from fem.types import FloatArray
from ui.viewport.overlays.marks import Colour, Marks, chain
from ui.viewport.overlays.overlay import Drawn
from ui.viewport.overlays.skull import BoneSurface, bone_surface
from ui.viewport.overlays.solids import circle
from ui.workspaces.workspace import Parts

PICKED: Colour = (0.97, 0.97, 0.95)
WANTED: Colour = (0.36, 0.75, 0.62)
ASKED: Colour = (0.949, 0.518, 0.361)
GROUND: Colour = (0.12, 0.13, 0.14)

DOT = 8.0
RING, ASKED_RING = 5.0, 9.0
"""Pixels: diameter of what is picked, and radii of where it should lie, and of what is asked for."""


class GuestSkull:
    """Draws the skull that is being fitted in the place of the head's own."""

    def __init__(self, parts: Parts) -> None:
        self._parts = parts
        self._viewport = parts.viewport
        self._fitting: SkullFitting = parts.bench.fitting
        self._bone: BoneSurface | None = None
        self._drawn_mesh: Mesh | None = None
        self._said = ""
        self._marks = {
            "way ground": Marks(GROUND, 4.0, lines=True),
            "way": Marks(WANTED, 2.0, lines=True),
            "wanted ground": Marks(GROUND, 3.6, lines=True),
            "wanted": Marks(WANTED, 1.8, lines=True),
            "asked ground": Marks(GROUND, 4.2, lines=True),
            "asked": Marks(ASKED, 2.2, lines=True),
            "rim": Marks(GROUND, DOT + 4),
            "picked": Marks(PICKED, DOT),
            "active": Marks(ASKED, DOT),
        }
        self._on = self._due = False
        self._fitting.changed.connect(self._ask)
        self._viewport.canvas.before_frame.append(self._before_frame)

    def switch(self, on: bool) -> None:
        """Begin to draw, or take all off."""
        renderer = self._viewport.scene.renderer
        for marks in self._marks.values():
            renderer.AddViewProp(marks.actor) if on else renderer.RemoveViewProp(marks.actor)
            marks.hide()
        self._on = on
        if not on:
            self._show_bone(None)
        self._ask()

    def _ask(self) -> None:
        self._due = True
        self._viewport.canvas.ask_frame()

    def _before_frame(self) -> None:
        """The bone when it is another; rings, which have a size on the screen, in every frame."""
        drawn = self._viewport.scene.drawn
        if not self._on or drawn is None:
            return
        if self._due:
            self._due = False
            self._say()
            self._show_bone(self._fitting.mesh if self._fitting.on else None)
        if self._fitting.on:
            self._draw_marks(drawn)
        else:
            for marks in self._marks.values():
                marks.hide()

    def _say(self) -> None:
        """Name the pick under the pointer, and say by how much it is missed."""
        name, fit = self._fitting.pointed, self._fitting.fit
        if name != self._said:
            self._said = name
            missed = f", {fit.residuals[name]:.1f} mm off" if fit is not None and name in fit.residuals else ""
            text = f"{title_of(name)}{missed}" if name else ""
            self._viewport.pointer.say(text, self._viewport.canvas.mapFromGlobal(QCursor.pos()))

    def _show_bone(self, mesh: Mesh | None) -> None:
        """The guest instead of the head's own skull, or that again."""
        scene = self._viewport.scene
        scene.skull.step_aside(mesh is not None)
        if mesh is self._drawn_mesh:
            return
        before, self._drawn_mesh = self._drawn_mesh, mesh
        if mesh is not None and before is not None and self._bone is not None and mesh.triangles is before.triangles:
            self._bone.points[:] = mesh.positions
            self._bone.normals[:] = mesh.normals
            self._bone.moved()
            return
        if self._bone is not None:
            scene.renderer.RemoveViewProp(self._bone.actor)
        self._bone = None if mesh is None else bone_surface(mesh)
        if self._bone is not None:
            scene.renderer.AddViewProp(self._bone.actor)

    def _draw_marks(self, drawn: Drawn) -> None:
        fitting, projector = self._fitting, self._parts.bench.projector
        assert fitting.guest is not None
        if projector is None:
            return
        names, targets = list(fitting.picked), fitting.guest.targets
        places = fitting.laid(np.array([fitting.picked[name] for name in names]).reshape(-1, 3))
        wanted = np.array([targets[name] for name in names]).reshape(-1, 3)
        ways = np.stack([places, wanted], axis=1).reshape(-1, 3)
        mine = np.array([name == fitting.active for name in names], dtype=np.bool_)

        def rings(centres: FloatArray, pixels: float) -> FloatArray:
            made = [chain(circle(at, projector.towards(at), pixels * projector.millimetres(at), 24)) for at in centres]
            return np.concatenate([np.zeros((0, 3)), *made])

        asked = targets[fitting.active][None] if fitting.active else np.zeros((0, 3))
        shown = {
            "way ground": ways,
            "way": ways,
            "wanted ground": (small := rings(wanted, RING)),
            "wanted": small,
            "asked ground": (large := rings(asked, ASKED_RING)),
            "asked": large,
            "rim": places,
            "picked": places[~mine],
            "active": places[mine],
        }
        for name, ends in shown.items():
            self._marks[name].show(ends)

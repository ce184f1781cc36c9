"""Sculpting in scripts: ``au(12).sculpt.pull("mouth_corner_L", (0, 2, 1), radius=15)``."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from app.authoring import sculpting
from app.authoring.units import unit_of
from app.commands.corrections import set_corrections
from app.scripting.desk import ScriptDesk
from app.scripting.painting import Painter, Where
from app.sculpt_work import sculpt_work
from facemodel.actions import ActionUnit, Side
from facemodel.errors import FaceError, PaintError
from facemodel.sculpting.brush import SCULPT_TITLES, SculptBrush, SculptMode
from facemodel.sculpting.sampler import correction_sampler
from facemodel.sculpting.stroke import SculptStroke


class SculptHandle:
    """What is sculpted on an action unit: a layer over its solved fields.

    Parameters
    ----------
    desk : what the script works on
    number : of the unit
    """

    def __init__(self, desk: ScriptDesk, number: int) -> None:
        self._desk, self._number = desk, number
        self._painter = Painter(desk)

    def __repr__(self) -> str:
        return f"sculpt of au({self._number}): up to {self.largest:.2f} mm, amount {self.amount:g}"

    @property
    def largest(self) -> float:
        """How far it moves the skin at most with the unit at 1, millimetres."""
        return sculpting.farthest(self._desk.project, self._unit)

    @property
    def amount(self) -> float:
        """How much of it is added to what is solved, 0 to 1; of two sides the larger one."""
        layers = sculpting.layers_of(self._desk.project, self._unit)
        return max((layer.amount for layer in layers.values()), default=1.0)

    @amount.setter
    def amount(self, amount: float) -> None:
        self._desk.edit(lambda project: sculpting.with_amount(project, self._number, amount), "Amount of the sculpt")

    @property
    def on(self) -> bool:
        """Whether it is added at all."""
        return all(layer.on for layer in sculpting.layers_of(self._desk.project, self._unit).values())

    @on.setter
    def on(self, on: bool) -> None:
        self._desk.edit(lambda project: sculpting.with_switch(project, self._number, on), "Switch the sculpt")

    def pull(
        self,
        at: Where,
        way: Sequence[float],
        *,
        radius: float = 18.0,
        strength: float = 1.0,
        hardness: float = 0.0,
        mirror: bool = False,
    ) -> None:
        """Pull the skin at a place by a way (x, y, z) in millimetres, with the unit at 1.

        Parameters
        ----------
        at : a landmark, a vertex or a point in millimetres
        way : in millimetres; x is to the subject's left, y up, z forward
        radius, strength, hardness : of the brush, see `facemodel.sculpting.brush.SculptBrush`
        mirror : sculpt the other side alike
        """
        by = np.asarray(way, dtype=np.float64)
        if by.shape != (3,) or not np.isfinite(by).all():
            raise PaintError("A way is three numbers of millimetres: to the left, up and forward.")
        stroke = self._begun(SculptBrush("pull", radius, strength, hardness), mirror)
        point = self._painter.on_skin(at)
        face, display = self._desk.project.face, self._desk.solution().basis.display
        if not face.solved[point.triangle]:
            raise FaceError("The head stands still there, where it is not solved; pull at a place of the face.")
        stroke.take(point, correction_sampler(face, display).shares_at(point))
        stroke.pull(by)
        self._keep(stroke)

    def stroke(
        self,
        mode: SculptMode,
        at: Where,
        to: Where | None = None,
        *,
        radius: float = 18.0,
        strength: float = 1.0,
        hardness: float = 0.0,
        reverse: bool = False,
        mirror: bool = False,
    ) -> None:
        """Raise, smooth, pinch or erase about a place, or in a stroke from it to another one, with the unit at 1.

        Parameters
        ----------
        mode : ``raise``, ``smooth``, ``pinch`` or ``erase``; to pull see `pull`
        at, to : a landmark, a vertex or a point in millimetres
        radius, strength, hardness, reverse : of the brush, see `facemodel.sculpting.brush.SculptBrush`
        mirror : sculpt the other side alike
        """
        if mode == "pull":
            raise PaintError("To pull needs a way; use sculpt.pull(at, (x, y, z)).")
        stroke = self._begun(SculptBrush(mode, radius, strength, hardness, reverse), mirror)
        for place in (at,) if to is None else (at, to):
            stroke.extend(self._painter.on_skin(place))
        self._keep(stroke)

    def clear(self) -> None:
        """Take all of it off."""
        self._desk.edit(lambda project: sculpting.cleared(project, self._number), "Clear the sculpt")

    def mirror(self, source: Side = "L") -> None:
        """Make the other side the mirror image of one, ``L`` or ``R``, the subject's own."""
        partners = self._desk.ground.partners(self._desk.project.face)
        self._desk.edit(lambda p: sculpting.symmetric(p, self._number, source, partners), "Mirror the sculpt")

    def copy_to(self, other: int) -> None:
        """Put it on another unit, by number, in place of what is sculpted there."""
        self._desk.edit(lambda project: sculpting.copied_to(project, self._number, other), "Copy the sculpt")

    @property
    def _unit(self) -> ActionUnit:
        return unit_of(self._desk.project, self._number)

    def _begun(self, brush: SculptBrush, mirror: bool) -> SculptStroke:
        project, unit = self._desk.project, self._unit
        layers = sculpting.layers_of(project, unit)
        if not all(layer.share for layer in layers.values()):
            raise FaceError(f"What is sculpted on action unit {unit.number} is off; set sculpt.on and sculpt.amount.")
        partners = self._desk.ground.partners(project.face) if mirror else None
        surface, basis = self._desk.ground.surface(project.face), self._desk.solved().basis
        return SculptStroke(sculpt_work(project, unit, basis, unit.full, surface, partners), brush)

    def _keep(self, stroke: SculptStroke) -> None:
        project, unit = self._desk.project, self._unit
        layers = {**sculpting.layers_of(project, unit), **stroke.corrections}
        made = sculpting.with_corrections(project, unit, layers)
        label = f"{SCULPT_TITLES[stroke.brush.mode]} AU {self._number}"
        self._desk.document.run(set_corrections(project.corrections, made.corrections, label))

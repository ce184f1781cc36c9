"""Sculpt the field of the action unit in hand by strokes on the posed face."""

from __future__ import annotations

from dataclasses import dataclass
from typing import ClassVar

import numpy as np

from app.authoring.sculpting import layers_of, with_corrections
from app.commands.corrections import set_corrections
from app.errors import UnitError
from app.sculpt_work import active_fields, sculpt_work, with_image
from app.solo import SCULPT, alone, seen, unit_in_hand
from app.tools.pointer import Hit, Pointer, Ray, skin_hit
from app.tools.sculpt_state import HandSculpt
from app.tools.sight import Ring
from app.tools.tool import Bench, Tool
from app.view_state import ViewState, Workspace
from facemodel.actions import ActionUnit, Expression
from facemodel.basis import Basis
from facemodel.errors import FaceError
from facemodel.painting.geodesic import SurfacePoint
from facemodel.project import Project
from facemodel.sculpting.brush import SCULPT_TITLES, SculptMode
from facemodel.sculpting.correction import NOTHING, Corrections
from facemodel.sculpting.sampler import CorrectionSampler, correction_sampler
from facemodel.sculpting.stroke import Moved, SculptStroke
from fem.types import FloatArray

DEEDS: dict[SculptMode, str] = {
    "pull": "Drag the skin along",
    "raise": "Stroke to raise the skin, with Ctrl to lower it",
    "smooth": "Stroke to even the field out",
    "pinch": "Stroke to gather the skin, with Ctrl to spread it",
    "erase": "Stroke to take off what is sculpted",
}

STEEPEST = 0.05
"""Cosine between a line of sight and the way the hand pulls in, below which the pointer says nothing of it any more."""


@dataclass(eq=False)
class _Gesture:
    """A stroke under way.

    Attributes
    ----------
    unit : whose fields are sculpted
    stroke : what is done to them
    sampler : from vertices to what is drawn
    hold : while skin is pulled, the line of sight and the place (3,) that it was taken hold of by
    """

    unit: ActionUnit
    stroke: SculptStroke
    sampler: CorrectionSampler
    hold: tuple[Ray, FloatArray] | None = None


class SculptTool(Tool):
    """A stroke moves skin from press to release; it is seen at once, and becomes one step when it ends."""

    id: ClassVar[str] = SCULPT
    title: ClassVar[str] = "Sculpt"
    shortcut: ClassVar[str] = "S"
    hint: ClassVar[str] = "Sculpt the action unit in hand · Shift smooths · [ ] size · Shift+[ ] strength · X mirror"
    workspaces: ClassVar[frozenset[Workspace]] = frozenset(("actions",))

    def __init__(self, bench: Bench) -> None:
        super().__init__(bench)
        self._gesture: _Gesture | None = None
        self._last: Hit | None = None
        bench.sculpt.changed.connect(self._redraw_ring)
        bench.view.changed.connect(self._follow_view)

    @property
    def brush(self) -> HandSculpt:
        """The brush that moves skin."""
        return self.bench.sculpt

    @property
    def advice(self) -> str:
        """Which unit is sculpted, as it is seen, and what a stroke does."""
        document, state = self.bench.document, self.bench.view.state
        unit = unit_in_hand(document.project, state)
        if unit is None:
            return "Choose an action unit to sculpt"
        single = alone(document.project, state, document.shown)
        how = "alone, at 1" if single is not None else f"in the mix, at {_weights(unit, document.shown)}"
        return f"AU {unit.number} {how} · {DEEDS[self.brush.state.mode]} · Shift smooths · [ ] size · X mirror"

    def press(self, pointer: Pointer) -> None:
        """Begin a stroke.

        Raises
        ------
        UnitError
            If no unit is in hand, or what is sculpted on it is switched off.
        FaceError
            If its fields are not solved as they are now.
        PaintError
            If both sides are to be sculpted alike and the face is not symmetric.
        """
        hit, face = pointer.skin, self._project.face
        if hit is None or not face.solved[hit.triangle]:
            return
        self._gesture = self._begun(hit, pointer)
        self.busy = True
        if self._gesture.hold is not None:
            self.leave()
        else:
            self.move(pointer)

    def move(self, pointer: Pointer) -> None:
        """Go on with the stroke; beside the face the brush is off the skin."""
        gesture = self._gesture
        if gesture is None:
            return
        if gesture.hold is not None:
            self._pull(gesture, *gesture.hold, pointer)
            return
        self.hover(pointer)
        if pointer.skin is None:
            gesture.stroke.lift()
        else:
            point = SurfacePoint(pointer.skin.triangle, pointer.skin.barycentric)
            self._show(gesture, gesture.stroke.extend(point, pointer.pressure))

    def release(self, pointer: Pointer) -> None:
        """End the stroke; it becomes one step."""
        gesture, self._gesture, self.busy = self._gesture, None, False
        if gesture is None:
            return
        project, unit = self._project, gesture.unit
        after = self._with_images(gesture.stroke.corrections, unit)
        made = with_corrections(project, unit, {**layers_of(project, unit), **after})
        label = f"{SCULPT_TITLES[gesture.stroke.brush.mode]} AU {unit.number}"
        command = set_corrections(project.corrections, made.corrections, label)
        if command.changes:
            self.bench.document.run(command)
        else:
            self.bench.sight.shifted.emit(None)

    def cancel(self) -> None:
        """Put the skin back."""
        gesture, self._gesture, self.busy = self._gesture, None, False
        if gesture is not None:
            self.bench.sight.shifted.emit(None)

    def hover(self, pointer: Pointer) -> None:
        """Show where the brush would work."""
        self._last = pointer.skin
        if pointer.skin is None:
            self.leave()
        else:
            self._redraw_ring()

    def leave(self) -> None:
        """Take the ring away."""
        self._last = None
        self.bench.sight.ring_changed.emit(None)

    @property
    def _project(self) -> Project:
        return self.bench.document.project

    def _begun(self, hit: Hit, pointer: Pointer) -> _Gesture:
        """A stroke that begins at a place; to pull, it takes hold of it in a plane across the line of sight."""
        document, ground, face = self.bench.document, self.bench.ground, self._project.face
        unit, basis = self._in_hand()
        expression = seen(document, self.bench.view.state)
        if any(not each.share for each in layers_of(document.project, unit).values()):
            raise UnitError(f"What is sculpted on action unit {unit.number} is off; switch it on to go on with it.")
        both = len(active_fields(unit, expression)) == len(unit.fields)
        partners = ground.partners(face) if self.brush.state.mirror else None
        work = sculpt_work(document.project, unit, basis, expression, ground.surface(face), partners if both else None)
        stroke = SculptStroke(work, self.brush.state.brush(pointer.modifiers))
        sampler = correction_sampler(face, basis.display)
        if stroke.brush.mode != "pull" or pointer.ray is None:
            return _Gesture(unit, stroke, sampler)
        point = SurfacePoint(hit.triangle, hit.barycentric)
        stroke.take(point, sampler.shares_at(point))
        place = hit.barycentric @ work.posed[face.skin.triangles[hit.triangle]]
        return _Gesture(unit, stroke, sampler, (pointer.ray, place))

    def _in_hand(self) -> tuple[ActionUnit, Basis]:
        document = self.bench.document
        unit = unit_in_hand(document.project, self.bench.view.state)
        if unit is None:
            raise UnitError("There is no action unit in hand to sculpt; choose one in the list.")
        if self.bench.view.state.before:
            raise FaceError("The face is shown as it was before the last solve; show it as it is now to sculpt it.")
        if document.solved is None or document.stale_fields & set(unit.fields):
            raise FaceError(f"Action unit {unit.number} is not solved as it is now; sculpt it when the solve is over.")
        return unit, document.solved.basis

    def _pull(self, gesture: _Gesture, first: Ray, place: FloatArray, pointer: Pointer) -> None:
        if pointer.ray is None or pointer.ray.along @ first.along < STEEPEST:
            return
        way = _on_plane(pointer.ray, place, first.along) - _on_plane(first, place, first.along)
        self._show(gesture, gesture.stroke.pull(way))

    def _show(self, gesture: _Gesture, moved: Moved) -> None:
        if len(moved.vertices):
            self.bench.sight.shifted.emit(gesture.sampler.change(moved.vertices, moved.by))

    def _with_images(self, after: Corrections, unit: ActionUnit) -> Corrections:
        """Of a side that was sculpted alone, the mirror image on the other side too where that is asked for."""
        if not self.brush.state.mirror or len(after) == len(unit.fields):
            return after
        (field,) = after
        (other,) = set(unit.fields) - {field}
        before = self._project.corrections
        one = before.get(field, NOTHING)
        if after[field] is one:
            return after
        partners = self.bench.ground.partners(self._project.face)
        return {**after, other: with_image(one, after[field], before.get(other, NOTHING), partners)}

    def _follow_view(self, now: ViewState, before: ViewState) -> None:
        """A stroke on what is no longer seen ends without a trace."""
        if (now.unit, now.solo, now.mixing) != (before.unit, before.solo, before.mixing):
            self.cancel()

    def _redraw_ring(self, *_now: object) -> None:
        hit, state = self._last, self.brush.state
        if hit is None:
            return
        mirrored = self._across(hit) if state.mirror else None
        self.bench.sight.ring_changed.emit(Ring(hit, mirrored, state.radius, state.hardness))

    def _across(self, hit: Hit) -> Hit:
        face = self._project.face
        other = self.bench.ground.mirrored(face, SurfacePoint(hit.triangle, hit.barycentric))
        return skin_hit(face, other.triangle, other.barycentric)


def _on_plane(ray: Ray, place: FloatArray, normal: FloatArray) -> FloatArray:
    """Where a line of sight meets the plane through a place (3,)."""
    return np.asarray(ray.origin + ((place - ray.origin) @ normal) / (ray.along @ normal) * ray.along)


def _weights(unit: ActionUnit, expression: Expression) -> str:
    own = [expression.get(name, 0.0) for name in unit.fields]
    return f"{own[0]:.2f}" if len(set(own)) == 1 else " · ".join(f"{w:.2f}" for w in own)

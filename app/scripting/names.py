"""The names that a script finds: a few functions and handles over the open document."""

from __future__ import annotations

from collections.abc import Mapping
from typing import Any

import numpy as np

from app.authoring import emotions, pad, units
from app.authoring.blending import blended
from app.authoring.facs_table import filled_from_facs
from app.expression_clipboard import expressions_of, expressions_text, with_pasted
from app.expression_text import format_expression, parse_expression
from app.quality import FLUID, checked_quality
from app.scripting.animating import PUBLIC, Animating
from app.scripting.desk import ScriptDesk
from app.scripting.exporting import Exporting
from app.scripting.muscle_handle import MuscleHandle
from app.scripting.muscle_names import MuscleNames
from app.scripting.painting import Painter, Where
from app.scripting.skull_handle import SkullHandle
from app.scripting.unit_handle import UnitHandle
from app.superposition_check import Posed, check_superposition
from facemodel.actions import Place, expand, find_emotion, resolve
from facemodel.face import Face
from facemodel.laying import collection
from facemodel.laying.clipboard import muscles_from, muscles_text
from facemodel.laying.fibres import laid_fibre
from fem.types import Float32Array


class Names:
    """What can be called in a script.  All of it goes through the commands that the mouse uses, and can be undone.

    Parameters
    ----------
    desk : what the script works on
    """

    def __init__(self, desk: ScriptDesk) -> None:
        self._desk = desk
        self._painter = Painter(desk)
        self._animating = Animating(desk)
        self._exporting = Exporting(desk)
        self._laying = MuscleNames(desk, self._painter)

    def namespace(self) -> dict[str, Any]:
        """All of it by name."""
        own = {name: getattr(self, name) for name in dir(type(self)) if not name.startswith("_")}
        own.pop("namespace")
        painting = {name: getattr(self._painter, name) for name in ("paint", "values", "set_values", "layers", "place")}
        animating = {name: getattr(self._animating, name) for name in PUBLIC}
        skull = SkullHandle(self._desk, self._painter)
        animating["export_animation"] = self._exporting.export_animation
        return {**own, **painting, **animating, **self._laying.namespace(), "skull": skull, "np": np}

    def linear_sum(self, on: bool = True) -> None:
        """Show the pure linear sum of the fields: no arc of the jaw, nothing that lids and lips meet; or no longer."""
        self._desk.show("the pure linear sum", linear=on)

    def drawing_quality(self, quality: str = "automatic", at_least: float = FLUID) -> None:
        """Draw ``full``, ``balanced`` or ``fast``; or ``automatic``: as fine as ``at_least`` frames a second allow."""
        chosen, rate = checked_quality(quality, at_least)
        self._desk.show("another quality", quality=chosen, least_rate=rate)

    def face(self) -> Face:
        """The face as it is now, a frozen value."""
        return self._desk.project.face

    def au(self, name: int | str) -> UnitHandle:
        """An action unit, by number or name."""
        (field, *_) = resolve(str(name), self._desk.project.units)
        number = next(unit.number for unit in self._desk.project.units if field in unit.fields)
        return UnitHandle(self._desk, number)

    def new_au(self, name: str = "", number: int | None = None) -> UnitHandle:
        """A new action unit, in which nothing moves yet."""
        project, made = units.with_new_unit(self._desk.project, name, number=number)
        self._desk.edit(lambda _: project, f"New action unit {made}")
        return UnitHandle(self._desk, made)

    def units(self) -> tuple[UnitHandle, ...]:
        """All action units, in order."""
        return tuple(UnitHandle(self._desk, unit.number) for unit in self._desk.project.units)

    def muscle(self, key: str) -> MuscleHandle:
        """A muscle, by name and side such as ``risorius_L``."""
        return MuscleHandle(self._desk, collection.muscle_of(self._desk.project, key).key)

    def muscles(self) -> tuple[MuscleHandle, ...]:
        """All muscles, in order."""
        return tuple(MuscleHandle(self._desk, muscle.key) for muscle in self._desk.project.muscles)

    def new_muscle(self, title: str, origin: Where, attachment: Where, group: str = "cheek") -> MuscleHandle:
        """A new muscle of one fibre, from the bone nearest to a place to the vertex of the skin nearest to another."""
        fibre = laid_fibre(self.face(), self._painter.place(origin), self._painter.place(attachment))
        made = collection.new_muscle(self._desk.project, title, group, fibres=(fibre,))
        self._desk.edit(lambda project: collection.with_muscle(project, made), f"Lay {made.title}")
        return MuscleHandle(self._desk, made.key)

    def copy_muscles(self, *keys: str) -> str:
        """Muscles as text for another project; all of them without keys."""
        chosen = [collection.muscle_of(self._desk.project, key) for key in keys] or self._desk.project.muscles
        return muscles_text(chosen, self.face())

    def paste_muscles(self, text: str) -> tuple[MuscleHandle, ...]:
        """Muscles from a text, fitted to this head."""
        project, keys = collection.added(self._desk.project, muscles_from(text, self.face()))
        self._desk.edit(lambda _: project, "Paste muscles")
        return tuple(MuscleHandle(self._desk, key) for key in keys)

    def jaw_axis(self, right: Where, left: Where) -> None:
        """Let the jaw turn about the line through two places, the subject's right condyle and the left one."""
        SkullHandle(self._desk, self._painter).jaw_axis(right, left)

    def expression(self) -> str:
        """What is shown, as text such as ``12L=0.8 12R=0.8``."""
        return format_expression(self._desk.document.shown, self._desk.project.units)

    def show(self, weights: str | Mapping[str, float]) -> None:
        """Show an expression and nothing else: a text, or weights by any name."""
        given = parse_expression(weights, self._desk.project.units) if isinstance(weights, str) else weights
        self._desk.document.set_expression(given, "Show expression")

    def emotion(self, name: str, strength: float = 1.0) -> None:
        """Show a named expression and nothing else."""
        find_emotion(name, self._desk.project.emotions)
        self._desk.document.apply_emotion(name, strength)

    def place_expression(self, name: str, place: Place | None) -> None:
        """Lay a named expression on the pad at a place (x, y) from 0 to 1; none takes it off."""
        self._desk.edit(lambda project: pad.with_place(project, name, place), f"Place {name} on the pad")

    def blend_at(self, x: float, y: float, rest: bool = True) -> None:
        """Show what is seen at a place of the pad, with the face at rest in its middle or without."""
        self._desk.document.set_expression(pad.blend_at(self._desk.project, (x, y), rest), "Blend expressions")

    def copy_expressions(self, *names: str) -> str:
        """Named expressions as text for another project; all of them without names."""
        project = self._desk.project
        chosen = [find_emotion(name, project.emotions) for name in names] or project.emotions
        return expressions_text(chosen, project.units)

    def paste_expressions(self, text: str) -> tuple[str, ...]:
        """Named expressions from a text; returns what they are called here.  What has no unit here is left out."""
        read = expressions_of(text, self._desk.project.units)
        project, names = with_pasted(self._desk.project, read)
        self._desk.edit(lambda _: project, "Paste expressions")
        return names

    def check_superposition(self) -> tuple[float, float]:
        """Solve the summed loads of what is shown in full: largest and rms distance from it, millimetres."""
        document = self._desk.document
        found = check_superposition(Posed(document.project, self._desk.solved().basis, document.shown))
        return found.largest, found.rms

    def blend(self, places: Mapping[str, Place], at: Place) -> None:
        """Show what is seen at a place of a pad on which named expressions lie: the nearer one, the more of it."""
        fields = {name: self._fields_of(name) for name in places}
        parts = {name: (place, fields[name]) for name, place in places.items()}
        self._desk.document.set_expression(blended(parts, at), "Blend expressions")

    def neutral(self) -> None:
        """Set every slider to zero."""
        self._desk.document.reset_expression()

    def save_expression(self, name: str) -> None:
        """Keep what is shown under a name."""
        shown = self._desk.document.shown
        self._desk.edit(lambda project: emotions.with_expression(project, name, shown), f"Save expression {name}")

    def delete_expression(self, name: str) -> None:
        """Take a named expression out of the project."""
        self._desk.edit(lambda project: emotions.without(project, [name]), f"Delete expression {name}")

    def fill_from_facs(self) -> dict[int, tuple[str, ...]]:
        """Fill all action units from the table; returns the muscles that it names and the face does not have."""
        filling = filled_from_facs(self._desk.project)
        self._desk.edit(lambda _: filling.project, "Fill from FACS")
        return dict(filling.missing)

    def field(self, name: str) -> Float32Array:
        """Displacement (P, 3) of every drawn point by one field, such as ``12L``, at weight 1; millimetres."""
        (own,) = resolve(name, self._desk.project.units)
        return self._desk.solution().basis.field(own)

    def _fields_of(self, name: str) -> dict[str, float]:
        project = self._desk.project
        return expand(find_emotion(name, project.emotions).weights, project.units)

    def undo(self) -> None:
        """Take back the last step of this script."""
        self._desk.document.undo()

    def redo(self) -> None:
        """Do the step again that was taken back."""
        self._desk.document.redo()

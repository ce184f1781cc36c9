"""Muscles in scripts: ``muscle("risorius_L").width = 12``."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from app.scripting.desk import ScriptDesk
from facemodel.errors import MuscleError
from facemodel.laying import collection, values
from facemodel.laying.fibres import End, added_fibre, bent, laid_fibre, with_end
from facemodel.laying.places import on_bone, on_skin
from facemodel.muscles import Muscle, Profile
from facemodel.muscles.models import MODELS
from facemodel.muscles.muscle import Model
from facemodel.project import Project
from fem.types import FloatArray

Place = Sequence[float] | FloatArray
"""A point, three millimetres."""

SPOKEN = frozenset(("title", "group", "colour", "model"))
"""Members for people that are no parameters of a model."""


class MuscleHandle:
    """A muscle of the project, by its key; its parameters are attributes, those of parts by ``get`` and ``set``.

    Parameters
    ----------
    desk : what the script works on
    key : of the muscle, for example ``risorius_L``
    """

    _desk: ScriptDesk
    _key: str

    def __init__(self, desk: ScriptDesk, key: str) -> None:
        object.__setattr__(self, "_desk", desk)
        object.__setattr__(self, "_key", key)

    def __repr__(self) -> str:
        muscle = self.value
        return f"muscle({muscle.key!r}): {muscle.title}, {muscle.model}"

    @property
    def value(self) -> Muscle:
        """The muscle as it is now, a frozen value."""
        return collection.muscle_of(self._desk.project, self._key)

    @property
    def key(self) -> str:
        """Name and side."""
        return self._key

    def __getattr__(self, name: str) -> object:
        if name.startswith("_"):
            raise AttributeError(name)
        if name in SPOKEN:
            return getattr(self.value, name)
        return self.get(name)

    def __setattr__(self, name: str, value: object) -> None:
        setters: dict[str, Callable[[Muscle], Muscle]] = {
            "title": lambda muscle: values.titled(muscle, str(value)),
            "group": lambda muscle: values.grouped(muscle, str(value)),
            "colour": lambda muscle: values.coloured(muscle, str(value)),
            "model": lambda muscle: values.with_model(muscle, _model(value)),
        }
        if name in setters:
            self._change(setters[name], "Change")
        else:
            self.set(name, value)  # type: ignore[arg-type]

    def get(self, name: str) -> float | Profile:
        """The value of a parameter such as ``width``, ``kappa``, ``ring.focus`` or ``profiles.sigma``."""
        values.parameter_of(self.value, name)
        return values.values(self.value)[name]

    def set(self, name: str, value: float | Profile) -> None:
        """Give a parameter another value."""
        given = value if isinstance(value, Profile) else float(value)
        self._change(lambda muscle: values.changed(muscle, name, given), "Change")

    def move(self, end: End, to: Place, fibre: int = 0) -> None:
        """Move the origin to the bone nearest to a point, or the attachment to the nearest vertex of the skin."""
        face, point = self._desk.project.face, np.array(to, dtype=np.float64)
        place = on_bone(face, point) if end == "origin" else on_skin(face, point)
        self._change(lambda muscle: with_end(muscle, fibre, end, place), "Move")

    def bend(self, through: Place, fibre: int = 0) -> None:
        """Lead a fibre through one more point."""
        self._change(lambda muscle: bent(muscle, fibre, np.array(through, dtype=np.float64))[0], "Bend")

    def add_fibre(self, origin: Place, attachment: Place) -> None:
        """Give it one more central fibre."""
        face = self._desk.project.face
        fibre = laid_fibre(face, np.array(origin, dtype=np.float64), np.array(attachment, dtype=np.float64))
        self._change(lambda muscle: added_fibre(muscle, fibre), "Add fibre to")

    def rename(self, name: str) -> None:
        """Give it another name without side, on both sides and in all action units."""
        old = self.value
        self._desk.edit(lambda project: collection.renamed(project, old.name, name), f"Rename {old.title}")
        object.__setattr__(self, "_key", self._key.replace(old.name, name, 1))

    def mirror(self) -> MuscleHandle:
        """Lay its mirror image on the other side, in place of what is there."""
        return self._made(collection.on_other_side, "Mirror")

    def duplicate(self) -> MuscleHandle:
        """A copy of it at the same place."""
        return self._made(collection.duplicated, "Duplicate")

    def delete(self) -> None:
        """Take it out of the project, and out of the units if it is gone on both sides."""
        title = self.value.title
        self._desk.edit(lambda project: collection.deleted(project, [self._key]).project, f"Delete {title}")

    def _made(self, make: Callable[[Project, list[str]], tuple[Project, tuple[str, ...]]], verb: str) -> MuscleHandle:
        project, (key,) = make(self._desk.project, [self._key])
        self._desk.edit(lambda _: project, f"{verb} {self.value.title}")
        return MuscleHandle(self._desk, key)

    def _change(self, change: Callable[[Muscle], Muscle], verb: str) -> None:
        changed = change(self.value)
        self._desk.edit(lambda project: collection.with_muscle(project, changed), f"{verb} {changed.title}")


def _model(value: object) -> Model:
    """The model of a name."""
    for model in MODELS:
        if model == value:
            return model
    raise MuscleError(f"There is no model “{value}” of muscles; choose one of {', '.join(MODELS)}.")

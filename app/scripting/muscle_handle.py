"""Muscles in scripts: ``muscle("risorius_L").width = 12``."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import replace

from app.scripting.desk import ScriptDesk
from app.scripting.muscle_places import PlacedMuscle
from facemodel.errors import MuscleError
from facemodel.laying import collection, values
from facemodel.laying.sides import linked, partner, unlinked
from facemodel.muscles import Muscle, Profile
from facemodel.muscles.models import MODELS, comparable_models
from facemodel.muscles.muscle import Model
from facemodel.project import Project

SPOKEN = frozenset(("title", "group", "colour", "model", "linked"))
"""Members for people that are no parameters of a model."""


class MuscleHandle(PlacedMuscle):
    """A muscle of the project, by its key; its parameters are attributes, those of parts by ``get`` and ``set``.

    Parameters
    ----------
    desk : what the script works on
    key : of the muscle, for example ``risorius_L``
    """

    def __init__(self, desk: ScriptDesk, key: str) -> None:
        object.__setattr__(self, "_desk", desk)
        object.__setattr__(self, "_key", key)

    def __repr__(self) -> str:
        muscle = self.value
        return f"muscle({muscle.key!r}): {muscle.title}, {muscle.model}"

    @property
    def key(self) -> str:
        """Name and side."""
        return self._key

    @property
    def models(self) -> tuple[Model, ...]:
        """The models that can work on what it is made of."""
        return comparable_models(self.value)

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
        if name == "linked":
            self._link(bool(value))
        elif name in setters:
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

    def reset(self, name: str) -> None:
        """Give a parameter the value that a new muscle gets."""
        self._change(lambda muscle: values.reset(muscle, name), "Reset")

    def draw(self, name: str, knots: Sequence[tuple[float, float]]) -> None:
        """Draw a profile of a mouth, ``sigma`` or ``tau``, through knots of distance and value."""
        at, heights = zip(*knots, strict=True) if knots else ((), ())
        profile = Profile(tuple(map(float, at)), tuple(map(float, heights)))
        self._change(lambda muscle: values.changed(muscle, f"profiles.{name}", profile), "Draw profile of")

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

    def _link(self, on: bool) -> None:
        """Keep it in step with its partner, or no longer."""
        muscle, project = self.value, self._desk.project
        if partner(project.muscles, muscle) is None:
            raise MuscleError(f"“{muscle.key}” has no partner to be in step with; mirror it first.")
        muscles = linked(project.muscles, muscle, project.face) if on else unlinked(project.muscles, muscle)
        label = f"{'Link' if on else 'Unlink'} sides of {muscle.title}"
        self._desk.edit(lambda before: replace(before, muscles=muscles), label)

    def _made(self, make: Callable[[Project, list[str]], tuple[Project, tuple[str, ...]]], verb: str) -> MuscleHandle:
        project, (key,) = make(self._desk.project, [self._key])
        self._desk.edit(lambda _: project, f"{verb} {self.value.title}")
        return MuscleHandle(self._desk, key)


def _model(value: object) -> Model:
    """The model of a name."""
    for model in MODELS:
        if model == value:
            return model
    raise MuscleError(f"There is no model “{value}” of muscles; choose one of {', '.join(MODELS)}.")

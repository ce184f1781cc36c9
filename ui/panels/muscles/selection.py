"""Which muscles are selected, in the terms of a project."""

from __future__ import annotations

from collections.abc import Iterable

from app.view_state import ViewState
from facemodel.laying.sides import partner
from facemodel.muscles import Muscle
from facemodel.project import Project


def chosen(project: Project, state: ViewState) -> tuple[Muscle, ...]:
    """The selected muscles, the one selected last first, the others in the order of the project."""
    there = [muscle for muscle in project.muscles if muscle.key in state.selected]
    return tuple(sorted(there, key=lambda muscle: muscle.key != state.muscle))


def with_partners(project: Project, muscles: Iterable[Muscle]) -> tuple[Muscle, ...]:
    """Muscles with the partners that are kept in step with them, each once."""
    found: dict[str, Muscle] = {}
    for muscle in muscles:
        found.setdefault(muscle.key, muscle)
        other = partner(project.muscles, muscle)
        if other is not None and in_step(project, muscle):
            found.setdefault(other.key, other)
    return tuple(found.values())


def in_step(project: Project, muscle: Muscle) -> bool:
    """Whether a muscle and its partner are each other's mirror image, now and from now on."""
    other = partner(project.muscles, muscle)
    return other is not None and muscle.linked and other.linked


def titles(muscles: Iterable[Muscle]) -> str:
    """The titles of some muscles, each once: one or two in full, of more the number."""
    names = tuple(dict.fromkeys(muscle.title for muscle in muscles))
    return " and ".join(names) if len(names) <= 2 else f"{len(names)} muscles"

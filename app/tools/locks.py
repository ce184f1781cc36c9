"""Muscles that no hand changes: which of those that would be changed are locked, in a sentence."""

from __future__ import annotations

from collections.abc import Iterable

from app.view_state import ViewState
from facemodel.errors import MuscleError
from facemodel.laying.sides import partner
from facemodel.muscles import Muscle
from facemodel.project import Project


def locked_among(project: Project, state: ViewState, muscles: Iterable[Muscle]) -> tuple[Muscle, ...]:
    """Those muscles that are locked, and the locked partners that a change of them would change too."""
    found: dict[str, Muscle] = {}
    for muscle in muscles:
        other = partner(project.muscles, muscle)
        follows = other is not None and muscle.linked and other.linked
        for each in (muscle, other if follows else None):
            if each is not None and each.key in state.locked:
                found.setdefault(each.key, each)
    return tuple(found.values())


def refuse_locked(project: Project, state: ViewState, muscles: Iterable[Muscle]) -> None:
    """Nothing, unless one of some muscles may not be changed.

    Raises
    ------
    MuscleError
        If one of them, or a partner that is kept in step with it, is locked.
    """
    for muscle in locked_among(project, state, muscles):
        side = {"L": " on the left", "R": " on the right", "M": ""}[muscle.side]
        raise MuscleError(f"{muscle.title}{side} is locked; open its padlock in the tree to change it.")

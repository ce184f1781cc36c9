"""Muscles of another head in a project, and a project's own muscles on another head."""

from __future__ import annotations

from dataclasses import dataclass, replace
from typing import Literal

from facemodel.errors import MuscleError
from facemodel.laying.atlas_fit import AtlasFit, fit_atlas
from facemodel.laying.collection import deleted
from facemodel.muscles import Muscle
from facemodel.project import Project

Keeping = Literal["same", "others", "none"]
"""What becomes of the muscles that a project has: those of the same names are replaced and the others stay; all stay
and only what is missing comes; or all of them go."""


@dataclass(frozen=True, eq=False)
class Fitted:
    """A project with muscles that were fitted to its head.

    Attributes
    ----------
    project : with them
    fit : how well that went
    """

    project: Project
    fit: AtlasFit


def with_fitted_muscles(project: Project, source: Project, keeping: Keeping = "same") -> Fitted:
    """A project with the muscles of another one, fitted to its head by landmarks with non-proportional scale.

    Raises
    ------
    MuscleError
        If the other project has no muscles, or the heads share too few landmarks.
    """
    if not source.muscles:
        raise MuscleError(f"The project of “{source.face.title}” has no muscles to fit.")
    fit = fit_atlas(source.muscles, source.face, project.face)
    own = {muscle.key: muscle for muscle in project.muscles}
    new = {muscle.key: muscle for muscle in fit.muscles}
    if keeping == "none":
        gone = [key for key, muscle in own.items() if muscle.name not in {each.name for each in fit.muscles}]
        return Fitted(replace(deleted(project, gone).project, muscles=fit.muscles), fit)
    taken = {**own, **new} if keeping == "same" else {**new, **own}
    return Fitted(replace(project, muscles=_in_order(taken, project.muscles)), fit)


def carried_to(project: Project, other: Project) -> Fitted:
    """Another head with the muscles of a project, fitted to it, and with its action units and expressions.

    Parameters
    ----------
    other : whose face, settings and paint stay

    Raises
    ------
    MuscleError
        If the heads share too few landmarks.
    """
    fit = fit_atlas(project.muscles, project.face, other.face)
    content = replace(
        other,
        muscles=fit.muscles,
        units=project.units,
        emotions=project.emotions,
        expression=project.expression,
    )
    return Fitted(content, fit)


def _in_order(taken: dict[str, Muscle], before: tuple[Muscle, ...]) -> tuple[Muscle, ...]:
    """Muscles in the order in which they were, new ones at the end."""
    first = [muscle.key for muscle in before]
    return tuple(taken[key] for key in dict.fromkeys([*first, *taken]))

"""The expression that ``--au`` and ``--emotion`` ask for."""

from __future__ import annotations

from collections.abc import Sequence

from app.weights import checked_weights, emotion_weights
from facemodel.actions import Expression, mixed
from facemodel.project import Project

Named = Sequence[tuple[str, float]]


def asked_expression(project: Project, emotions: Named, units: Named) -> Expression:
    """The emotions mixed, then the weights of single action units; the project's own expression without either.

    Raises
    ------
    UnknownNameError
        If the project has no such emotion or action unit.
    NumberError
        If a weight is not a number in range.
    """
    if not emotions and not units:
        return project.expression
    felt = mixed(emotion_weights(name, strength, project) for name, strength in emotions)
    for name, value in units:
        felt |= checked_weights({name: value}, project)
    return {name: value for name, value in felt.items() if value != 0}

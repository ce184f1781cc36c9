"""The named expressions of a project: save the sliders as one, rename, order and delete them."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

from facemodel.actions import Emotion, Expression, find_emotion
from facemodel.errors import ActionError
from facemodel.project import Project

LONGEST_NAME = 100
"""Characters of a name, as in the project file."""


def checked_emotion_name(project: Project, name: str, but: str = "") -> str:
    """The name itself, without white space at its ends, if an expression may have it.

    Raises
    ------
    ActionError
        If it is empty, too long or taken, whatever its case.
    """
    plain = " ".join(name.split())
    if not plain or len(plain) > LONGEST_NAME:
        raise ActionError(f"An expression needs a name of 1 to {LONGEST_NAME} characters.")
    for emotion in project.emotions:
        if emotion.name.lower() == plain.lower() and emotion.name != but:
            raise ActionError(f"There is an expression “{emotion.title}” already; choose another name.")
    return plain


def saved(project: Project, name: str, expression: Expression) -> Project:
    """A project with one more named expression, made of weights by field.

    Raises
    ------
    ActionError
        If it cannot have that name, or the face is at rest.
    """
    weights = told(project, expression)
    if not weights:
        raise ActionError("The face is at rest; move some sliders first, then save them as an expression.")
    return replace(project, emotions=(*project.emotions, Emotion(checked_emotion_name(project, name), weights)))


def replaced(project: Project, name: str, expression: Expression) -> Project:
    """A project in which a named expression is made of other weights by field; raises `ActionError` at rest."""
    emotion = find_emotion(name, project.emotions)
    weights = told(project, expression)
    if not weights:
        raise ActionError("The face is at rest; move some sliders first, then save them as an expression.")
    return _with(project, emotion, replace(emotion, weights=weights))


def renamed_emotion(project: Project, name: str, to: str) -> Project:
    """A project in which a named expression has another name; raises `ActionError` if it cannot have it."""
    emotion = find_emotion(name, project.emotions)
    return _with(project, emotion, replace(emotion, name=checked_emotion_name(project, to, but=emotion.name)))


def deleted_emotion(project: Project, name: str) -> Project:
    """A project without a named expression."""
    emotion = find_emotion(name, project.emotions)
    return replace(project, emotions=tuple(each for each in project.emotions if each is not emotion))


def placed(project: Project, name: str, place: int) -> Project:
    """A project in which a named expression stands at another place, counted from 0 among all of them."""
    emotion = find_emotion(name, project.emotions)
    others = [each for each in project.emotions if each is not emotion]
    others.insert(min(max(place, 0), len(others)), emotion)
    return replace(project, emotions=tuple(others))


def told(project: Project, expression: Expression) -> dict[str, float]:
    """Weights by field as a person tells them: both sides in one where they are alike, and nothing of what is zero."""
    weights: dict[str, float] = {}
    for unit in project.units:
        own = [expression.get(field, 0.0) for field in unit.fields]
        if own[0] == own[-1]:
            named: Mapping[str, float] = {str(unit.number): own[0]}
        else:
            named = dict(zip(unit.fields, own, strict=True))
        weights.update({name: weight for name, weight in named.items() if weight})
    return weights


def _with(project: Project, old: Emotion, new: Emotion) -> Project:
    return replace(project, emotions=tuple(new if each is old else each for each in project.emotions))

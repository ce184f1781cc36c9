"""Emotions and other named expressions: keep the sliders under a name, rename, order and delete them."""

from __future__ import annotations

from collections.abc import Collection, Sequence
from dataclasses import replace

from app.errors import UnitError
from facemodel.actions import ActionUnit, Emotion, Expression, find_emotion
from facemodel.project import Project

LONGEST_NAME = 100


def with_expression(project: Project, name: str, expression: Expression) -> Project:
    """A project that keeps an expression under a name: at the end of the emotions, or in place of the one so called.

    Raises
    ------
    UnitError
        If the name cannot be one, or nothing moves in the expression.
    """
    weights = told_weights(expression, project.units)
    if not weights:
        raise UnitError("There is nothing to keep: every slider is at zero; move some first.")
    emotion = Emotion(_checked(name), weights)
    others = {each.name.lower(): each for each in project.emotions}
    if emotion.name.lower() in others:
        changed = replace(others[emotion.name.lower()], weights=weights)
        emotions = tuple(changed if each.name == changed.name else each for each in project.emotions)
        return replace(project, emotions=emotions)
    return replace(project, emotions=(*project.emotions, emotion))


def renamed(project: Project, name: str, to: str) -> Project:
    """A project in which an emotion has another name; raises `UnitError` if that is taken or cannot be one."""
    emotion, plain = find_emotion(name, project.emotions), _checked(to)
    if any(each is not emotion and each.name.lower() == plain.lower() for each in project.emotions):
        raise UnitError(f"There is an expression “{plain}” already; choose another name.")
    new = replace(emotion, name=plain)
    return replace(project, emotions=tuple(new if each is emotion else each for each in project.emotions))


def moved(project: Project, name: str, place: int) -> Project:
    """A project in which an emotion stands at another place of the list, counted from 0."""
    emotion = find_emotion(name, project.emotions)
    others = [each for each in project.emotions if each is not emotion]
    others.insert(min(max(place, 0), len(others)), emotion)
    return replace(project, emotions=tuple(others))


def without(project: Project, names: Collection[str]) -> Project:
    """A project without some emotions; raises `UnknownNameError` if there is no such one."""
    gone = {find_emotion(name, project.emotions).name for name in names}
    return replace(project, emotions=tuple(each for each in project.emotions if each.name not in gone))


def free_name(project: Project, wanted: str = "expression") -> str:
    """A name that no emotion has: the one that is wanted, else with the first free number."""
    taken = {each.name.lower() for each in project.emotions}
    names = (wanted, *(f"{wanted} {count}" for count in range(2, len(taken) + 3)))
    return next(name for name in names if name.lower() not in taken)


def told_weights(expression: Expression, units: Sequence[ActionUnit]) -> dict[str, float]:
    """Weights as a person tells them: both sides in one where they are alike, and nothing of what is zero."""
    told: dict[str, float] = {}
    for unit in units:
        sides = {field: float(expression.get(field, 0.0)) for field in unit.fields}
        alike = len(set(sides.values())) == 1
        told.update({str(unit.number): sides[unit.fields[0]]} if alike else sides)
    return {name: weight for name, weight in told.items() if weight}


def _checked(name: str) -> str:
    plain = " ".join(name.split())
    if not plain or len(plain) > LONGEST_NAME:
        raise UnitError(f"An expression needs a name of at most {LONGEST_NAME} characters; type another one.")
    return plain

"""The weights of expression and emotions when the fields of a project come to have other names."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import replace

from facemodel.actions import ActionUnit, Emotion, resolve
from facemodel.animation.respelling import respelled
from facemodel.project import Project
from facemodel.sculpting.correction import Correction, Corrections, joined

Renaming = Callable[[str], str | None]
"""Another name for a field, or none if it is gone."""


def refielded(project: Project, units: Mapping[int, ActionUnit | None], name_now: Renaming) -> Project:
    """A project with other units under some numbers, or none, and its weights under the names of their fields now.

    What is sculpted on a field goes with it, and so does what animates it; where two become one, what is sculpted on
    both lies on top of each other, and the first one's track stays.
    """
    kept = tuple(units.get(each.number, each) for each in project.units)
    emotions = tuple(_emotion_now(each, project, name_now) for each in project.emotions)
    return replace(
        project,
        units=tuple(unit for unit in kept if unit is not None),
        emotions=emotions,
        expression=_largest(project.expression, name_now),
        corrections=_together(project, name_now),
        animation=respelled(project.animation, lambda name: tuple(filter(None, [name_now(name)]))),
    )


def _together(project: Project, name_now: Renaming) -> Corrections:
    """The corrections under the names that their fields have now; the very same if nothing sculpted is touched."""
    if all(name_now(name) == name for name in project.corrections):
        return project.corrections
    found: dict[str, Correction] = {}
    for name, each in project.corrections.items():
        now = name_now(name)
        if now is not None:
            found[now] = joined(found[now], each, len(project.face.skin.positions)) if now in found else each
    return dict(sorted(found.items()))


def _emotion_now(emotion: Emotion, project: Project, name_now: Renaming) -> Emotion:
    """An emotion in the names of the fields now; one that is not touched keeps the names it was written in."""
    fields = {field: weight for name, weight in emotion.weights.items() for field in resolve(name, project.units)}
    if all(name_now(field) == field for field in fields):
        return emotion
    return replace(emotion, weights=_largest(fields, name_now))


def spelled(project: Project, fields: Mapping[str, tuple[str, ...]]) -> Project:
    """A project whose emotions say fields where they named a unit by a name that it no longer has."""

    def now(emotion: Emotion) -> Emotion:
        if fields.keys().isdisjoint(emotion.weights):
            return emotion
        spelled = {f: weight for name, weight in emotion.weights.items() for f in fields.get(name, (name,))}
        return replace(emotion, weights=spelled)

    return replace(project, emotions=tuple(map(now, project.emotions)))


def _largest(weights: Mapping[str, float], name_now: Renaming) -> dict[str, float]:
    found: dict[str, float] = {}
    for name, weight in weights.items():
        now = name_now(name)
        if now is not None:
            found[now] = max(found.get(now, weight), weight)
    return found

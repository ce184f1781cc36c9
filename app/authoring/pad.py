"""The pad that blends between expressions: which of them lie on it, and where."""

from __future__ import annotations

import math
from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from app.authoring.blending import blended
from app.errors import UnitError
from facemodel.actions import Emotion, Expression, Place, expand, find_emotion
from facemodel.project import Project

MIDDLE: Place = (0.5, 0.5)
"""Where the face at rest lies, if it is on the pad."""

AT_REST = ""
"""Name of the face at rest among the parts of a blend."""

ROUND = 0.38
"""Radius of the circle on which expressions are arranged; the pad is 1 wide."""


def on_pad(project: Project) -> tuple[Emotion, ...]:
    """The expressions that lie on the pad."""
    return tuple(emotion for emotion in project.emotions if emotion.place is not None)


def with_place(project: Project, name: str, place: Place | None) -> Project:
    """A project in which an expression lies elsewhere on the pad, or no longer on it.

    Raises
    ------
    UnitError
        If the place is not within 0 and 1 both ways.
    """
    emotion = find_emotion(name, project.emotions)
    if place is not None and not all(math.isfinite(x) and 0 <= x <= 1 for x in place):
        raise UnitError(f"The pad reaches from 0 to 1 both ways; ({place[0]:g}, {place[1]:g}) is not on it.")
    at = None if place is None else (float(place[0]), float(place[1]))
    if at == emotion.place:
        return project
    moved = replace(emotion, place=at)
    return replace(project, emotions=tuple(moved if each is emotion else each for each in project.emotions))


def free_place(project: Project) -> Place:
    """A place far from all that lies on the pad and from its middle."""
    taken = [MIDDLE, *(emotion.place for emotion in on_pad(project) if emotion.place is not None)]
    ring = [_on_circle(turn) for turn in np.linspace(0, 2 * np.pi, 24, endpoint=False)]
    return max(ring, key=lambda place: round(min(math.dist(place, other) for other in taken), 9))


def arranged(project: Project) -> Project:
    """A project in which all expressions lie on a circle, in their order, the first one on top.

    Variants of one that is there are left off: they would crowd it, and each can be laid where a hand wants it.
    """
    names = {emotion.name for emotion in project.emotions}
    laid = [emotion.name for emotion in project.emotions if emotion.family not in names]
    turns = dict(zip(laid, np.linspace(0, 2 * np.pi, len(laid), endpoint=False), strict=True))
    return replace(
        project,
        emotions=tuple(
            replace(emotion, place=_on_circle(turns[emotion.name]) if emotion.name in turns else None)
            for emotion in project.emotions
        ),
    )


def emptied(project: Project) -> Project:
    """A project in which no expression lies on the pad."""
    return replace(project, emotions=tuple(replace(each, place=None) for each in project.emotions))


def parts_on(project: Project, rest: bool) -> dict[str, tuple[Place, Expression]]:
    """Place and weights by field of what is blended; with the face at rest in the middle where that is asked for."""
    parts: dict[str, tuple[Place, Expression]] = {AT_REST: (MIDDLE, {})} if rest else {}
    for emotion in on_pad(project):
        if emotion.place is not None:
            parts[emotion.name] = emotion.place, expand(emotion.weights, project.units)
    return parts


def blend_at(project: Project, pointer: Place, rest: bool = True) -> Mapping[str, float]:
    """The expression, by field, that is seen with the pointer at a place of the pad.

    Raises
    ------
    UnitError
        If no expression lies on the pad.
    """
    if not on_pad(project):
        raise UnitError("No expression lies on the pad yet; drag some there from the list.")
    return blended(parts_on(project, rest), pointer)


def _on_circle(turn: float) -> Place:
    """A place on the circle, clockwise from the top."""
    return round(0.5 + ROUND * math.sin(turn), 4), round(0.5 + ROUND * math.cos(turn), 4)

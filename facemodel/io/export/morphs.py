"""Morph targets: what each action unit does to every mesh, and what the expression in hand does beyond their sum."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from facemodel.actions import Expression
from facemodel.basis import Basis
from facemodel.io.export.pieces import Piece, eye_pieces, moved
from facemodel.io.export.targets import gaze_targets, target_weights, targets
from facemodel.kinematics import rig_of
from facemodel.project import Project
from facemodel.superposition import Superposition
from fem.types import Float32Array

POSED = "posed"
"""Name of the target that makes the sum of the others what is seen."""

SEEN = 0.01
"""Millimetres by which the sum has to miss what is seen for there to be such a target."""


@dataclass(frozen=True, eq=False)
class Morph:
    """One target.

    Attributes
    ----------
    name : ``AU12``, ``AU12L``, or `POSED`
    weight : what it has in the expression in hand
    moves : change (n, 3) of every moving mesh by its name, millimetres
    turns : change (n, 3) of normals, of the meshes that bend
    """

    name: str
    weight: float
    moves: Mapping[str, Float32Array]
    turns: Mapping[str, Float32Array]


def morphs_of(project: Project, basis: Basis) -> list[Morph]:
    """All targets of a project, that for what is seen last; none if nothing moves."""
    face = project.face
    pose = Superposition(face, basis, rig_of(project.units))
    eyes = [(piece, number) for number, eye in enumerate(face.eyes) for piece in eye_pieces(eye)]
    rest = _seen(pose, {}, eyes)
    shapes = (*targets(project.units, basis), *gaze_targets(project.units, basis))
    made = []
    for shape, weight in zip(shapes, target_weights(project.expression, shapes), strict=True):
        now = _seen(pose, dict.fromkeys(shape.fields, 1.0), eyes)
        made.append(Morph(f"AU{shape.name}", weight, _change(now[0], rest[0]), _change(now[1], rest[1])))
    if any(morph.weight for morph in made):
        now = _seen(pose, project.expression, eyes)
        beyond = [_beyond(made, _change(each, at), kind) for kind, (each, at) in enumerate(zip(now, rest, strict=True))]
        if max(float(np.abs(change).max(initial=0.0)) for change in beyond[0].values()) > SEEN:
            made.append(Morph(POSED, 1.0, beyond[0], beyond[1]))
    return made


Meshes = dict[str, Float32Array]


def _seen(pose: Superposition, expression: Expression, eyes: Sequence[tuple[Piece, int]]) -> tuple[Meshes, Meshes]:
    """Points of all meshes in an expression, copied, and normals of those that bend or turn; the head is upright."""
    pose.pose(expression)
    points: Meshes = {"skin": pose.points.copy(), **{name: each.copy() for name, each in pose.parts.items()}}
    normals: Meshes = {"skin": pose.normals.copy()}
    for piece, number in eyes:
        turned = moved(piece, pose.stance.eyes[number])
        points[piece.name], normals[piece.name] = turned.positions, turned.normals
    return points, normals


def _change(now: Meshes, rest: Meshes) -> Meshes:
    return {name: now[name] - rest[name] for name in rest}


def _beyond(morphs: list[Morph], change: Meshes, kind: int) -> Meshes:
    """What a change has beyond the weighted sum of targets: of their moves (0) or turns (1)."""
    for morph in morphs:
        if morph.weight:
            for name, part in (morph.moves, morph.turns)[kind].items():
                change[name] -= np.float32(morph.weight) * part
    return change

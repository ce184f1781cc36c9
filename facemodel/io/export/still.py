"""A face that stands still as a performance of one frame: a shape for every action unit, the head as it is held."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from facemodel.basis import Basis
from facemodel.io.export.joints import joints_of
from facemodel.io.export.morphs import morphs_of
from facemodel.io.export.performance import Performance, Shape
from facemodel.kinematics import rig_of, stance_of
from facemodel.project import Project


def still_performance(project: Project, basis: Basis) -> Performance:
    """One frame that shows the project's expression; jaw and eyes move by their shapes, the head by its joint."""
    face = project.face
    morphs = morphs_of(project, basis)
    upright = stance_of(face, rig_of(()).posture(face, {}), np.eye(4))
    held = stance_of(face, rig_of(project.units).posture(face, project.expression), np.eye(4)).head
    joints = joints_of(face, [replace(upright, head=held)])
    shapes = tuple(Shape(morph.name, morph.moves, morph.turns) for morph in morphs)
    weights = np.array([morph.weight for morph in morphs]).reshape(1, len(shapes))
    return Performance(24.0, np.zeros(1), shapes, weights, joints, 0.0, still=True)

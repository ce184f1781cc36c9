"""A face that stands still as a performance of one frame: a shape for every action unit, joints at rest."""

from __future__ import annotations

import numpy as np

from facemodel.animation.rigid import rigid_pose
from facemodel.basis import Basis
from facemodel.io.export.joints import joints_of
from facemodel.io.export.performance import Performance, Shape
from facemodel.io.export.targets import target_weights, targets
from facemodel.project import Project
from facemodel.superposition import Superposition


def still_shapes(project: Project, basis: Basis) -> list[Shape]:
    """Every target of a face with what it does to each mesh, the parts on the jaw among them."""
    pose = Superposition(project.face, basis)
    rest = {"skin": pose.points.copy(), **{name: points.copy() for name, points in pose.parts.items()}}
    upright = pose.normals.copy()
    shapes = []
    for target in targets(project.units, basis):
        pose.pose(dict.fromkeys(target.fields, 1.0))
        now = {"skin": pose.points, **pose.parts}
        moved = {name: now[name] - points for name, points in rest.items()}
        shapes.append(Shape(f"AU{target.name}", moved, pose.normals - upright))
    return shapes


def still_performance(project: Project, basis: Basis) -> Performance:
    """One frame that shows the project's expression; the lower teeth and the tongue move by their shapes."""
    weights = target_weights(project.expression, targets(project.units, basis))
    joints = joints_of(project.face, [rigid_pose(project.face, {})], [np.eye(4)])
    shapes = tuple(still_shapes(project, basis))
    return Performance(24.0, np.zeros(1), shapes, np.array(weights).reshape(1, len(shapes)), joints, 0.0)

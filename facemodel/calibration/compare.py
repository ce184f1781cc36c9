"""Solve the action units on a measured face, or take those of a project, and compare them with what was measured."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from facemodel.basis import Basis
from facemodel.calibration.measured import MeasuredFace
from facemodel.calibration.measured_face import PosedFace, posed_face
from facemodel.calibration.report import Report, make_report
from facemodel.face import Face
from facemodel.laying.fitting import fitted_atlas
from facemodel.project import Project, Settings
from facemodel.sampling import points_of_vertices
from facemodel.sculpted import read_sculpted
from facemodel.solution import Progress, silent
from facemodel.solve import solve_project
from fem.types import FloatArray


@dataclass(frozen=True, eq=False)
class Fitted:
    """A measured face with the anatomy of a project.

    Attributes
    ----------
    posed : the face and its measured fields
    project : its muscles carried over by landmarks, and the action units as they are
    """

    posed: PosedFace
    project: Project


def carried_over(measured: MeasuredFace, project: Project) -> Fitted:
    """Put the muscles of a project on a measured face.

    Raises
    ------
    FaceError, MuscleError
        If the measured surface cannot be solved, or its landmarks do not fit.
    """
    posed = posed_face(measured, project.face)
    muscles = fitted_atlas(project.muscles, project.face, posed.face)
    settings = replace(project.settings, density=1)
    return Fitted(posed, Project(posed.face, muscles, project.units, (), settings=settings))


def measured_report(source: str, fitted: Fitted, progress: Progress = silent) -> Report:
    """Solve a fitted face and compare all its measured expressions.

    Raises
    ------
    FaceError, Cancelled
        As `facemodel.solve.solve_project` does.
    """
    basis = solve_project(fitted.project, progress).basis
    face = fitted.posed.face
    measured = dict(zip(fitted.posed.names, fitted.posed.fields, strict=True))
    return make_report(source, measured, vertex_fields(face, basis), face.skin.vertex_areas)


def sculpted_report(source: str, project: Project, progress: Progress = silent) -> Report:
    """Compare the solved fields of a project with the units that an artist sculpted on its head.

    Raises
    ------
    FaceError, ProjectError
        If no sculpted units ship for the head of this project, or they are damaged.
    """
    sculpted = read_sculpted(project.face)
    basis = solve_project(replace(project, settings=Settings(project.settings.element, 1)), progress).basis
    fields = dict(zip(sculpted.names, sculpted.fields.astype(np.float64), strict=True))
    return make_report(source, fields, vertex_fields(project.face, basis), project.face.skin.vertex_areas)


def vertex_fields(face: Face, basis: Basis) -> dict[str, FloatArray]:
    """Displacement (N, 3) of every vertex of the skin by each field of a basis, millimetres."""
    point = points_of_vertices(face, basis.display)
    return {name: basis.field(name)[point].astype(np.float64) for name in basis.names}

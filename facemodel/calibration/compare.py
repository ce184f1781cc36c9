"""Solve the action units on a measured face, or take those of a project, and compare them with what was measured."""

from __future__ import annotations

from dataclasses import dataclass, replace

import numpy as np

from facemodel.actions import field_names
from facemodel.anatomy.recipe import Anatomy
from facemodel.basis import Basis
from facemodel.calibration.adjust import Learned, Trial, goals, learned, with_mixtures
from facemodel.calibration.forward import Forward, Lender
from facemodel.calibration.measured import MeasuredFace
from facemodel.calibration.measured_face import PosedFace, posed_face
from facemodel.calibration.report import Report, make_report, wanted_fields
from facemodel.errors import FaceError
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
    head : the one that lent them
    """

    posed: PosedFace
    project: Project
    head: Face


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
    return Fitted(posed, Project(posed.face, muscles, project.units, (), settings=settings), project.face)


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


@dataclass(frozen=True, eq=False)
class Adjusted:
    """What was learned on a measured face, and how near it comes there.

    Attributes
    ----------
    learned : the recipe and the mixtures
    report : of the adjusted anatomy, solved anew
    """

    learned: Learned
    report: Report


def adjusted(source: str, fitted: Fitted, anatomy: Anatomy, progress: Progress = silent) -> Adjusted:
    """Turn the knobs of a recipe until a measured face is met as nearly as its bounds allow, and compare again.

    Raises
    ------
    FaceError
        If the face cannot be solved, or no expression is answered by one action unit alone.
    Cancelled
        If the progress callback raised it.
    """
    posed, units = fitted.posed, fitted.project.units
    forward = Forward(posed.face, Lender(fitted.head, posed.lent))
    measured = dict(zip(posed.names, posed.fields, strict=True))
    wanted, _ = wanted_fields(posed.names, field_names(units))
    aims = goals(measured, wanted, units)
    if not aims:
        raise FaceError(
            "None of the measured expressions is answered by one action unit alone; there is nothing to learn."
        )
    found = learned(Trial(forward, aims, units), anatomy, lambda text, share: progress(text, 0.9 * share))
    face = forward.painted(found.anatomy)
    muscles = forward.muscles(found.anatomy)
    project = replace(fitted.project, face=face, muscles=muscles, units=with_mixtures(units, found.mixtures))
    final = Fitted(replace(posed, face=face), project, fitted.head)
    return Adjusted(found, measured_report(source, final, lambda text, share: progress(text, 0.9 + 0.1 * share)))


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

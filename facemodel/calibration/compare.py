"""Solve the action units on a measured face, or take those of a project, and compare them with what was measured."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np

from facemodel.actions import ActionUnit, field_names
from facemodel.anatomy.recipe import Anatomy
from facemodel.basis import Basis
from facemodel.calibration.adjust import Learned, learned
from facemodel.calibration.forward import Forward, Lender
from facemodel.calibration.goals import goals, with_mixtures
from facemodel.calibration.hold_out import HeldOut, cross_checks
from facemodel.calibration.measured import MeasuredFace
from facemodel.calibration.measured_face import PosedFace, posed_face
from facemodel.calibration.report import Report, make_report, wanted_fields
from facemodel.calibration.trial import Trial
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
    checks : what was learned, told where it was not learned, if that was asked for
    """

    learned: Learned
    report: Report
    checks: tuple[HeldOut, ...] = ()


LEARNING, CHECKING = 0.9, 0.75
"""Shares of the time that learning takes if nothing is checked, and that cross-checks take of the whole."""


def adjusted(
    source: str, fitted: Fitted, anatomy: Anatomy, progress: Progress = silent, hold_out: Project | None = None
) -> Adjusted:
    """Turn the knobs of a recipe until a measured face is met as nearly as its bounds allow, and compare again.

    Parameters
    ----------
    source : what was measured, for the report
    fitted, anatomy : the face, and the recipe at first
    progress : if it raises `Cancelled` while something is learned, what was learned until then is compared
    hold_out : a project on the head with sculpted units; if given, what was learned is cross-checked

    Raises
    ------
    FaceError
        If the face cannot be solved, or no expression is answered by one action unit alone.
    Cancelled
        If the progress callback raised it before or after something was learned.
    """
    rest = 1.0 if hold_out is None else 1 - CHECKING
    trial = measured_trial(fitted)
    found = learned([trial], anatomy, lambda text, share: progress(text, rest * LEARNING * share))
    report = learned_report(
        source, fitted, trial, found, lambda text, share: progress(text, rest * (LEARNING + (1 - LEARNING) * share))
    )
    if hold_out is None or found.stopped:
        return Adjusted(found, report)
    sculpted = sculpted_trial(hold_out)
    checks = cross_checks(
        trial,
        sculpted,
        fitted.project.units,
        anatomy,
        found,
        lambda text, share: progress(text, rest + CHECKING * share),
    )
    return Adjusted(found, report, checks)


def learned_report(source: str, fitted: Fitted, trial: Trial, found: Learned, progress: Progress) -> Report:
    """Solve a fitted face with what was learned on it, and compare all its measured expressions."""
    face, muscles = trial.forward.painted(found.anatomy), trial.forward.muscles(found.anatomy)
    units = with_mixtures(fitted.project.units, found.mixtures)
    project = replace(fitted.project, face=face, muscles=muscles, units=units)
    return measured_report(source, Fitted(replace(fitted.posed, face=face), project, fitted.head), progress)


def measured_trial(fitted: Fitted) -> Trial:
    """A measured face on which recipes are tried out.

    Raises
    ------
    FaceError
        If no expression is answered by one action unit alone.
    """
    posed, units = fitted.posed, fitted.project.units
    measured = dict(zip(posed.names, posed.fields, strict=True))
    return _trial(Forward(posed.face, Lender(fitted.head, posed.lent)), measured, units)


def sculpted_trial(project: Project) -> Trial:
    """The head of a project with the units that an artist sculpted on it.

    Raises
    ------
    FaceError, ProjectError
        If no sculpted units ship for it, or they are damaged.
    """
    sculpted = read_sculpted(project.face)
    fields = dict(zip(sculpted.names, sculpted.fields.astype(np.float64), strict=True))
    return _trial(Forward(project.face, Lender(project.face)), fields, project.units)


def _trial(forward: Forward, measured: Mapping[str, FloatArray], units: Sequence[ActionUnit]) -> Trial:
    wanted, _ = wanted_fields(list(measured), field_names(units))
    aims = goals(measured, wanted, units)
    if not aims:
        raise FaceError(
            "None of the measured expressions is answered by one action unit alone; there is nothing to learn."
        )
    return Trial(forward, aims, units)


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

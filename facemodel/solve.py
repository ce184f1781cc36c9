"""Solve every action unit of a project at once; `facemodel.solver` is for solving it again after an edit."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from facemodel.basis import Basis
from facemodel.columns import displacing, jaw_columns, muscle_action_of
from facemodel.fields import face_sampler, jaw_table
from facemodel.jaw.modes import JawMode
from facemodel.project import Project
from facemodel.sampling import ELEMENTS, HeadSurface, SolvedRegion
from facemodel.solution import Cancelled, Clock, Progress, Solution, silent
from facemodel.solver import FaceSolver
from facemodel.sources import recipes
from facemodel.system import (
    HeldFace,
    face_material,
    face_supports,
    face_surfaces,
    face_tissue,
    held_system,
    stiffened,
    tissue_coupling,
)
from fem import SurfaceSystem
from fem.types import FloatArray

__all__ = [
    "Cancelled",
    "Clock",
    "FaceSystem",
    "Progress",
    "Solution",
    "face_system",
    "sampled_basis",
    "silent",
    "solve_project",
]


@dataclass(frozen=True, eq=False)
class FaceSystem:
    """The linear system of a face and the loads its action units put on it.

    Attributes
    ----------
    head : the smooth surface of the whole skin
    region : the solved part of it
    system : its stiffness, springs and supports
    names : M field names
    loads : (n_dofs, 3, M) consistent loads at activation 1; muscles that displace add none
    """

    head: HeadSurface
    region: SolvedRegion
    system: SurfaceSystem
    names: tuple[str, ...]
    loads: FloatArray


def face_system(project: Project) -> FaceSystem:
    """Assemble stiffness, tissue, supports and the loads of all action units, without factorising.

    Raises
    ------
    FaceError
        If a part of the face has neither support nor spring, or a unit names a muscle that is not there.
    """
    face = project.face
    surfaces = face_surfaces(face, ELEMENTS[project.settings.element])
    region = surfaces.region
    assembler, vertices = region.assembler, region.vertices
    tissue, supports = face_tissue(face, vertices), face_supports(face, vertices)
    stiffness = stiffened(None, assembler, face_material(face, vertices)).stiffness
    system = held_system(surfaces, supports, stiffness, tissue_coupling(tissue, assembler))
    held = HeldFace(surfaces, tissue, supports, stiffness, system)
    made_of = recipes(project)
    muscles = {muscle.key: muscle for muscle in project.muscles}
    sources = dict.fromkeys(source for recipe in made_of.values() for source, _ in recipe)
    jaw = jaw_columns([source for source in sources if isinstance(source, JawMode)], face, held)
    known = {s: jaw[s].action if s in jaw else muscle_action_of(muscles[str(s)], face, held) for s in sources}
    acting = np.zeros((len(made_of), len(vertices), 4))
    opened = np.zeros((assembler.dofs.n_dofs, 3, len(made_of)))
    for number, recipe in enumerate(made_of.values()):
        for source, weight in recipe:
            if not displacing(source, muscles):
                acting[number, :, : known[source].shape[1]] += weight * known[source]
            if source in jaw:
                opened[..., number] += weight * jaw[source].coefficients
    loads = held.consistent_loads(list(acting)) + held.room(opened)
    return FaceSystem(surfaces.head, region, system, tuple(made_of), loads)


def sampled_basis(project: Project, assembled: FaceSystem, fields: FloatArray) -> Basis:
    """Sample coefficients (n_dofs, 3, M) on what is drawn."""
    sampler = face_sampler(project.face, assembled.head, assembled.region, project.settings.density)
    return Basis(assembled.names, sampler.display, *sampler.rows(fields), jaw_table(project.units))


def solve_project(project: Project, progress: Progress = silent) -> Solution:
    """Solve all displacement fields of a project.

    Parameters
    ----------
    project : what to solve
    progress : told of every step; raising `Cancelled` in it stops the solve

    Raises
    ------
    FaceError
        If the face cannot be solved as it is held, or a unit names a muscle that is not there.
    Cancelled
        If the progress callback raised it.
    """
    return FaceSolver().solve(project, progress)

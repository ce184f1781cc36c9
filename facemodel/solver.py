"""The living solver of an editing session: an edit costs what it touches, not a new solve of the face."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from dataclasses import dataclass, replace

import numpy as np
from scipy.sparse import csc_array

from facemodel.basis import Basis
from facemodel.chart import ChartFigures, chart_figures
from facemodel.columns import Column, Columns
from facemodel.errors import FaceError
from facemodel.face import Face, Jaw
from facemodel.fields import FieldSampler, face_sampler, jaw_table
from facemodel.jaw.arc import JawArc
from facemodel.jaw.lining import Lining, carry_lining, lining_of
from facemodel.jaw.modes import JawMode
from facemodel.mesh import Mesh
from facemodel.project import Project
from facemodel.sameness import Kept, same
from facemodel.sampling import ELEMENTS
from facemodel.solution import Clock, Progress, Solution, silent
from facemodel.sources import Recipe, jaw_carried, jaw_modes, recipes
from facemodel.system import (
    HeldFace,
    Stiffened,
    Surfaces,
    Tissue,
    face_material,
    face_supports,
    face_surfaces,
    face_tissue,
    factorise,
    held_system,
    stiffened,
    tissue_coupling,
)
from fem import Assembler, FemError, SurfaceSystem
from fem.types import BoolArray, Float32Array, FloatArray, IntArray

Mix = tuple[tuple[Column, float], ...]
"""Columns and their weights that make up a field."""


@dataclass(frozen=True)
class Work:
    """What a solve had to do.

    Attributes
    ----------
    triangles : whose stiffness was integrated
    factorised : whether the system was
    columns : muscles and motions of the jaw whose displacement was found
    fields : that were mixed of them and sampled
    """

    triangles: int = 0
    factorised: bool = False
    columns: int = 0
    fields: int = 0


@dataclass(frozen=True, eq=False)
class _Rows:
    """Rows of fields and modes of the jaw, what they were sampled from, and the basis made of them."""

    sampler: FieldSampler
    mixes: Mapping[str | JawMode, Mix]
    turning: tuple[FloatArray, BoolArray, Jaw]
    fields: Float32Array
    slopes: Float32Array
    basis: Basis


class FaceSolver:
    """Solves one project after another and keeps what still holds from the last one.

    The smooth surface and the samplers hold as long as skin, chart, solved region and settings are the same; element
    matrices where the painted layers are; the factorisation as long as material, tissue and supports are; what a muscle
    does alone as long as it acts the same.  A field is the weighted sum of what its muscles and its motion of the jaw
    do alone, which is exact to rounding, so that another weight costs no solve at all.

    A solve that is cancelled or fails leaves the solver fit for any other, and what it gives never depends on what was
    solved before.  A solver belongs to one thread.

    Attributes
    ----------
    work : what the last solve had to do
    """

    def __init__(self) -> None:
        self.work = Work()
        self._surfaces: Kept[Surfaces] = Kept()
        self._stiffened: Stiffened | None = None
        self._tissue: Kept[Tissue] = Kept()
        self._coupling: Kept[csc_array] = Kept()
        self._system: Kept[SurfaceSystem] = Kept()
        self._columns = Columns()
        self._sampler: Kept[FieldSampler] = Kept()
        self._lining: Kept[Lining | None] = Kept()
        self._figures: Kept[ChartFigures] = Kept()
        self._rows: _Rows | None = None

    def solve(self, project: Project, progress: Progress = silent) -> Solution:
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
        try:
            return self._solve(project, progress)
        except FemError as error:
            raise FaceError(f"The face “{project.face.title}” cannot be solved: {error}") from error

    def _solve(self, project: Project, progress: Progress) -> Solution:
        self.work = Work()
        clock = Clock()
        progress("Assembling the skin", 0.02)
        made_of = recipes(project)
        surfaces = self._surfaces_of(project)
        clock.lap("surface")
        held = self._held_face(project.face, surfaces, progress, clock)
        self._solve_columns(project, made_of, held, progress)
        clock.lap("solve")
        progress("Sampling the smooth surface", 0.82)
        basis = self._basis(project, made_of, surfaces)
        clock.lap("sample")
        figures = self._figures_of(project.face)
        clock.lap("chart")
        progress(f"Solved {len(basis.names)} fields", 1.0)
        return Solution(basis, figures, held.system.n_unknowns, clock.laps)

    def _surfaces_of(self, project: Project) -> Surfaces:
        face, element = project.face, project.settings.element
        made_from = (element, face.skin.positions, face.skin.triangles, face.chart, face.solved)
        return self._surfaces.get(made_from, lambda: face_surfaces(face, ELEMENTS[element]))

    def _held_face(self, face: Face, surfaces: Surfaces, progress: Progress, clock: Clock) -> HeldFace:
        assembler, vertices = surfaces.region.assembler, surfaces.region.vertices
        material, supports = face_material(face, vertices), face_supports(face, vertices)
        tissue = self._tissue_of(face, assembler, vertices)
        stiff = self._stiffened = stiffened(self._stiffened, assembler, material)
        coupling = self._coupling.get((assembler, *tissue.stiff), lambda: tissue_coupling(tissue, assembler))
        clock.lap("assembly")
        progress("Factorising the stiffness", 0.10)

        def factorised() -> SurfaceSystem:
            self.work = replace(self.work, factorised=True)
            self._columns.forget()
            return factorise(held_system(surfaces, supports, stiff.stiffness, coupling), surfaces)

        self.work = replace(self.work, triangles=len(stiff.touched))
        system = self._system.get((assembler, material, *tissue.stiff, supports), factorised)
        clock.lap("factorisation")
        return HeldFace(surfaces, tissue, supports, stiff.stiffness, system)

    def _tissue_of(self, face: Face, assembler: Assembler, vertices: IntArray) -> Tissue:
        skull, layers = face.skull, face.layers
        painted = (layers.stiffness, layers.thickness, layers.sliding, layers.volume)
        made_from = (assembler, *painted, skull.anchors, skull.jawbone, skull.cranium, skull.mandible)
        return self._tissue.get(made_from, lambda: face_tissue(face, vertices))

    def _solve_columns(
        self, project: Project, made_of: Mapping[str, Recipe], held: HeldFace, progress: Progress
    ) -> None:
        def told(done: int, of: int) -> None:
            self.work = replace(self.work, columns=done)
            if of:
                progress(f"Solving action units, {done} of {of}", 0.35 + 0.45 * done / of)

        sources = dict.fromkeys(source for recipe in made_of.values() for source, _ in recipe)
        sources |= dict.fromkeys(jaw_modes(project))
        self._columns.update(project, tuple(sources), held, told)

    def _basis(self, project: Project, made_of: Mapping[str, Recipe], surfaces: Surfaces) -> Basis:
        """The basis, of which only those rows are sampled that are mixed otherwise than in the last one."""
        sampler = self._sampler_of(project, surfaces)
        modes = jaw_modes(project)
        whole: dict[str | JawMode, Recipe] = dict(made_of.items())
        whole |= {mode: ((mode, 1.0),) for mode in modes}
        mixes = {name: tuple((self._columns[s], weight) for s, weight in recipe) for name, recipe in whole.items()}
        turning = jaw_table(project.units), jaw_carried(project), project.face.skull.jaw
        last = self._rows if self._rows is not None and self._rows.sampler is sampler else None
        old = {} if last is None else {n: k for k, n in enumerate(last.mixes) if mixes.get(n) == last.mixes[n]}
        fresh = [name for name in mixes if name not in old]
        self.work = replace(self.work, fields=sum(isinstance(name, str) for name in fresh))
        if last is not None and not fresh and tuple(mixes) == tuple(last.mixes) and same(turning, last.turning):
            return last.basis
        sampled = sampler.rows(_mixed([mixes[name] for name in fresh], sampler.unknowns))
        carry_lining(
            sampled[0],
            [whole[name] for name in fresh],
            self._lining_of(project.face),
            lambda mode: sampler.at_vertices(self._columns[mode].coefficients),
        )
        rows = []
        for new, kept in zip(sampled, (last.fields, last.slopes) if last else sampled, strict=True):
            row = np.empty((len(mixes), new.shape[1]), dtype=np.float32)
            for number, name in enumerate(mixes):
                row[number] = kept[old[name]] if name in old else new[fresh.index(name)]
            rows.append(row)
        (fields, slopes), (jaw, carried, hinge), named = rows, turning, len(made_of)
        arc = JawArc(hinge, jaw, carried, modes, fields[named:], slopes[named:])
        basis = Basis(tuple(made_of), sampler.display, fields[:named], slopes[:named], jaw, arc=arc)
        self._rows = _Rows(sampler, mixes, turning, fields, slopes, basis)
        return basis

    def _sampler_of(self, project: Project, surfaces: Surfaces) -> FieldSampler:
        face, density = project.face, project.settings.density
        carried = tuple((p.name, p.anchors, p.shares, p.mesh) for p in face.parts if p.carrier == "skin")
        made_from = (surfaces.region.assembler, density, carried)
        return self._sampler.get(made_from, lambda: face_sampler(face, surfaces.head, surfaces.region, density))

    def _lining_of(self, face: Face) -> Lining | None:
        return self._lining.get((face.parts, face.skin, face.skull.jaw), lambda: lining_of(face))

    def _figures_of(self, face: Face) -> ChartFigures:
        made_from = (face.skin.positions, face.skin.triangles, face.solved, face.chart)
        return self._figures.get(
            made_from,
            lambda: chart_figures(Mesh(face.skin.positions, face.skin.triangles[face.solved]), face.chart),
        )


def _mixed(mixes: Sequence[Mix], unknowns: int) -> FloatArray:
    """Coefficients (n_dofs, 3, k) of k fields."""
    total = np.zeros((len(mixes), unknowns, 3))
    for field, mix in zip(total, mixes, strict=True):
        for column, weight in mix:
            field += weight * column.coefficients
    return np.ascontiguousarray(total.transpose(1, 2, 0))

"""Solve every action unit of a project once: chart, stiffness, one factorisation, all fields, samples."""

from __future__ import annotations

import time
from collections.abc import Callable, Mapping
from dataclasses import dataclass

import numpy as np

from facemodel.actions import ActionUnit
from facemodel.basis import Basis
from facemodel.chart import ChartFigures, chart_figures
from facemodel.displaced import displaced_fields
from facemodel.errors import FaceError
from facemodel.face import Face
from facemodel.loads import field_forces, jaw_forces, springs_carry_jaw
from facemodel.mesh import Mesh
from facemodel.project import Project
from facemodel.sampling import (
    ELEMENTS,
    HeadSurface,
    SolvedRegion,
    carried_points,
    display_surface,
    field_sampler,
    head_surface,
    solved_region,
)
from facemodel.tissue import tissue_springs
from fem import (
    FemError,
    Foundation,
    Material,
    SingularSystemError,
    Support,
    Supports,
    SurfaceSystem,
    element_tensors,
    load_operator,
)
from fem.types import Float32Array, FloatArray, IntArray

Progress = Callable[[str, float], None]
"""Told what is being done and the share of the whole that is done (0..1); may raise `Cancelled`."""


class Cancelled(Exception):  # noqa: N818 - it is a request, not an error
    """Raised by a progress callback to stop a solve; what was solved before stays as it was."""


@dataclass(frozen=True, eq=False)
class Solution:
    """A solved project.

    Attributes
    ----------
    basis : every displacement field
    chart : figures of the chart of the solved face
    unknowns : size of the linear system
    seconds : time of each step
    """

    basis: Basis
    chart: ChartFigures
    unknowns: int
    seconds: Mapping[str, float]


@dataclass(frozen=True, eq=False)
class FaceSystem:
    """The linear system of a face and the loads its action units put on it.

    Attributes
    ----------
    head : the smooth surface of the whole skin
    region : the solved part of it
    system : its stiffness, springs and supports
    names : M field names
    loads : (n_dofs, 3, M) consistent loads at activation 1
    """

    head: HeadSurface
    region: SolvedRegion
    system: SurfaceSystem
    names: tuple[str, ...]
    loads: FloatArray


class Clock:
    """Seconds between laps."""

    def __init__(self) -> None:
        self.laps: dict[str, float] = {}
        self._last = time.perf_counter()

    def lap(self, name: str) -> None:
        """Note the seconds since the last lap under a name."""
        now = time.perf_counter()
        self.laps[name] = now - self._last
        self._last = now


def silent(_text: str, _share: float) -> None:
    """Progress that nobody watches."""


def face_system(project: Project, clock: Clock | None = None) -> FaceSystem:
    """Assemble stiffness, tissue, supports and the loads of all action units.

    Parameters
    ----------
    project : whose face is assembled
    clock : takes the time of each step

    Raises
    ------
    FaceError
        If the supports and springs leave part of the face loose.
    """
    clock = clock or Clock()
    face, layers = project.face, project.face.layers
    head = head_surface(face, ELEMENTS[project.settings.element])
    region = solved_region(face, head)
    assembler, vertices = region.assembler, region.vertices
    clock.lap("surface")
    material = Material(layers.direction[vertices], layers.stretching[vertices], layers.bending[vertices])
    stiffness = assembler.assemble(element_tensors(assembler.surface, material)).matrix
    springs, anchors, jawbone = tissue_springs(face, vertices)
    coupling = Foundation(springs.blocks(len(vertices))).coupling(assembler)
    try:
        system = SurfaceSystem(assembler.dofs, stiffness, supports(face, region), coupling)
    except SingularSystemError as error:
        raise loose_face(error, vertices) from error
    clock.lap("assembly")
    names, forces = field_forces(project.units, project.muscles, face)
    on_region = forces[:, vertices]
    for unit in project.units:
        for name in unit.fields if springs_carry_jaw(unit, project.muscles) else ():
            on_region[names.index(name)] += jaw_forces(face, unit, springs, anchors, jawbone)
    flat = on_region.transpose(1, 2, 0).reshape(len(vertices), -1)
    loads = np.asarray(load_operator(assembler) @ flat).reshape(-1, 3, len(names))
    clock.lap("loads")
    return FaceSystem(head, region, system, names, loads)


def supports(face: Face, region: SolvedRegion) -> Supports:
    """Painted supports, with the rim where the solved face joins the held rest clamped."""
    kinds = face.layers.supports[region.vertices].copy()
    held_triangles = face.skin.triangles[~face.solved]
    kinds[np.isin(region.vertices, held_triangles)] = Support.CLAMPED
    return Supports(kinds)


def loose_face(error: SingularSystemError, vertices: IntArray) -> FaceError:
    """The error that tells a user where a face is loose."""
    place = int(vertices[error.vertices[0]]) if len(error.vertices) else 0
    return FaceError(
        f"The face is loose around skin vertex {place}: nothing holds it there. "
        "Paint tissue stiffness or a support on that region, then solve again."
    )


def solve_project(project: Project, progress: Progress = silent) -> Solution:
    """Solve all displacement fields of a project.

    Parameters
    ----------
    project : what to solve
    progress : told of every step; raising `Cancelled` in it stops the solve

    Raises
    ------
    FaceError
        If the face cannot be solved as it is held.
    Cancelled
        If the progress callback raised it.
    """
    try:
        return _solve(project, progress)
    except FemError as error:
        raise FaceError(f"The face “{project.face.title}” cannot be solved: {error}") from error


def _solve(project: Project, progress: Progress) -> Solution:
    clock = Clock()
    progress("Assembling the skin", 0.02)
    assembled = face_system(project, clock)
    progress("Factorising the stiffness", 0.10)
    try:
        assembled.system.factorise()
    except SingularSystemError as error:
        raise loose_face(error, assembled.region.vertices) from error
    clock.lap("factorisation")
    total = len(assembled.names)
    fields = assembled.system.solve(
        assembled.loads,
        progress=lambda done, of: progress(f"Solving action units, {done} of {of}", 0.35 + 0.45 * done / of),
    )
    displaced = displaced_fields(project, assembled.head, assembled.region, supports(project.face, assembled.region))
    if displaced is not None:
        fields = fields + displaced
    clock.lap("solve")
    progress("Sampling the smooth surface", 0.82)
    basis = sampled_basis(project, assembled, fields)
    clock.lap("sample")
    progress(f"Solved {total} fields", 1.0)
    figures = chart_figures(*_solved_chart(project.face))
    return Solution(basis, figures, assembled.system.n_unknowns, clock.laps)


def _solved_chart(face: Face) -> tuple[Mesh, FloatArray]:
    return Mesh(face.skin.positions, face.skin.triangles[face.solved]), face.chart


def sampled_basis(project: Project, assembled: FaceSystem, fields: FloatArray) -> Basis:
    """Sample coefficients (n_dofs, 3, M) on what is drawn."""
    face, region, names = project.face, assembled.region, assembled.names
    display = display_surface(face, assembled.head, project.settings.density)
    sample = field_sampler(face, display, region)
    flat = fields.reshape(len(fields), -1)
    at_vertices = np.zeros((len(face.skin.positions), flat.shape[1]))
    at_vertices[region.vertices] = flat[region.assembler.dofs.value_dofs]
    carried = carried_points(face, at_vertices)
    moved = np.concatenate([carried, sample.value @ flat])
    return Basis(
        names,
        display,
        _rows(moved, len(names)),
        np.concatenate([_planes(sample.d_u @ flat, len(names)), _planes(sample.d_v @ flat, len(names))], axis=1),
        jaw_table(project.units),
    )


def jaw_table(units: tuple[ActionUnit, ...]) -> FloatArray:
    """Opening in degrees and slide in millimetres of every field, (M, 2)."""
    rows = [(u.jaw.degrees, u.jaw.slide) if u.jaw else (0.0, 0.0) for u in units for _ in u.fields]
    return np.array(rows, dtype=np.float64).reshape(-1, 2)


def _rows(points: FloatArray, count: int) -> Float32Array:
    """(Q, 3 M) with the coordinate slower than the field, to (M, 3 Q)."""
    return np.ascontiguousarray(points.reshape(len(points), 3, count).transpose(2, 0, 1), dtype=np.float32).reshape(
        count, -1
    )


def _planes(slopes: FloatArray, count: int) -> Float32Array:
    """(S, 3 M) to (M, 3 S) with the coordinate slowest."""
    return np.ascontiguousarray(slopes.reshape(len(slopes), 3, count).transpose(2, 1, 0), dtype=np.float32).reshape(
        count, -1
    )

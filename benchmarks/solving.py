"""Solving the default face: assembly against factorisation, all fields against SciPy's own triangular solves."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np
from scipy.sparse import csc_array, eye_array, kron
from scipy.sparse.linalg import SuperLU, splu

from benchmarks.figure import Figure, alone, compared, interleaved
from facemodel.project import Project
from facemodel.projects import new_project
from facemodel.sampling import ELEMENTS
from facemodel.solve import face_system, solve_project
from facemodel.system import (
    Stiffened,
    Surfaces,
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

REPEATS = 5
ASSEMBLY_LIMIT, FIELDS_LIMIT = 1.0, 1.3


def figures() -> Iterator[Figure]:
    """Measure on the default face as it ships."""
    project = new_project()
    solving = _Solving(project)
    size = f"{solving.system.n_unknowns:,} unknowns"
    taken = interleaved(
        {
            "stiffness": solving.assemble_stiffness,
            "assembly": solving.assemble,
            "factorisation": solving.factorise,
            "fields": solving.solve,
            "scipy": solving.solve_with_scipy,
        },
        REPEATS,
    )
    count = solving.loads.shape[2]
    yield compared(
        f"assembly of the skin's stiffness, {size}",
        taken["stiffness"],
        "factorisation",
        taken["factorisation"],
        ASSEMBLY_LIMIT,
    )
    yield compared(
        "assembly with tissue and supports", taken["assembly"], "factorisation", taken["factorisation"], ASSEMBLY_LIMIT
    )
    yield compared(
        f"{count} fields after that", taken["fields"], "SciPy's triangular solves", taken["scipy"], FIELDS_LIMIT
    )
    yield alone("factorisation", taken["factorisation"])
    yield alone("the whole solve, samples included", interleaved({"solve": lambda: solve_project(project)}, 3)["solve"])


class _Solving:
    """The steps of solving one project, each on what the one before it made."""

    def __init__(self, project: Project) -> None:
        self._face = project.face
        self._surfaces: Surfaces = face_surfaces(project.face, ELEMENTS[project.settings.element])
        self.loads: FloatArray = face_system(project).loads
        self.assemble_stiffness()
        self.assemble()
        self._lu, self._free = self._scipy()

    def assemble_stiffness(self) -> None:
        """Integrate tensors and stiffness of the skin."""
        region = self._surfaces.region
        self._stiffened: Stiffened = stiffened(None, region.assembler, face_material(self._face, region.vertices))

    def assemble(self) -> None:
        """Assemble everything that is factorised, the skin's stiffness included."""
        region = self._surfaces.region
        self.assemble_stiffness()
        tissue = face_tissue(self._face, region.vertices)
        supports = face_supports(self._face, region.vertices)
        self._coupling: csc_array = tissue_coupling(tissue, region.assembler)
        self._supports = supports
        self.system: SurfaceSystem = held_system(self._surfaces, supports, self._stiffened.stiffness, self._coupling)

    def factorise(self) -> None:
        """Factorise what was assembled last."""
        self.system.factorise()

    def solve(self) -> None:
        """Solve all fields."""
        self.system.solve(self.loads)

    def solve_with_scipy(self) -> None:
        """Solve all fields by SciPy alone, in one call on a factorisation of the same matrix."""
        self._lu.solve(self._right)

    def _scipy(self) -> tuple[SuperLU, FloatArray]:
        matrix = csc_array(kron(self._stiffened.stiffness.matrix, eye_array(3), format="csc") + self._coupling)
        held = np.repeat(self._supports.held_dofs(self._surfaces.region.assembler.dofs), 3)
        free = np.flatnonzero(~held)
        self._right = np.asfortranarray(self.loads.reshape(matrix.shape[0], -1)[free])
        options = {"SymmetricMode": True}
        ordered = csc_array(matrix[:, free][free])
        return splu(ordered, permc_spec="MMD_AT_PLUS_A", diag_pivot_thresh=0.0, options=options), free

"""Charts: bijective on surfaces with holes, of low distortion, and honestly measured."""

from functools import cache

import numpy as np
import pytest
from hypothesis import assume, given
from hypothesis import strategies as st

from facemodel.chart import chart_figures, jacobians, make_chart
from facemodel.errors import FaceError
from facemodel.mesh import Mesh
from tests.facemodel.test_mesh import cube
from tests.fem.meshes import irregular, plate

ENTRY = st.floats(-3.0, 3.0)


@cache
def bulging_annulus() -> Mesh:
    """Return a dome with a hole, which no plane map keeps in shape."""
    surface = irregular()
    x, y = surface.chart.T
    return Mesh(np.column_stack([30 * x, 30 * y, -20 * (x**2 + y**2)]), surface.triangles)


@given(ENTRY, ENTRY, ENTRY, ENTRY)
def test_figures_of_an_affine_chart_are_its_singular_values(a: float, b: float, c: float, d: float) -> None:
    matrix = np.array([[a, b], [c, d]])
    assume(abs(np.linalg.det(matrix)) > 1e-2)
    surface = plate(2)
    mesh = Mesh(surface.positions, surface.triangles)
    uv = surface.chart @ matrix.T
    figures = chart_figures(mesh, uv)
    largest, smallest = np.linalg.svd(matrix, compute_uv=False)
    assert figures.worst == pytest.approx(max(largest, 1 / smallest))
    assert figures.p95 == pytest.approx(figures.worst)
    assert figures.flips == (len(mesh.triangles) if np.linalg.det(matrix) < 0 else 0)


def test_one_flipped_triangle_is_counted() -> None:
    surface = plate(1)
    mesh = Mesh(surface.positions, surface.triangles)
    uv = surface.chart.copy()
    uv[2] = [0.5, 0.2]
    assert chart_figures(mesh, uv).flips == 1


def test_the_chart_of_a_flat_plate_is_the_plate() -> None:
    surface = plate(4)
    mesh = Mesh(surface.positions, surface.triangles)
    figures = chart_figures(mesh, make_chart(mesh, iterations=60))
    assert figures.flips == 0
    assert figures.worst == pytest.approx(1.0, abs=0.01)


@pytest.mark.parametrize("energy", ["SYMMETRIC_DIRICHLET", "CONFORMAL", "LOG_ARAP"])
def test_a_dome_with_a_hole_is_charted_without_a_flip(energy: str) -> None:
    mesh = bulging_annulus()
    uv = make_chart(mesh, 20, energy)
    figures = chart_figures(mesh, uv)
    assert uv.shape == (len(mesh.positions), 2)
    assert figures.flips == 0
    assert figures.worst < 3.0
    area = np.abs(np.linalg.det(jacobians(mesh, uv))) @ np.linalg.norm(mesh.triangle_normals, axis=1)
    assert area / np.linalg.norm(mesh.triangle_normals, axis=1).sum() == pytest.approx(1.0, abs=0.35)


def test_more_iterations_distort_less() -> None:
    mesh = bulging_annulus()
    stretch = [chart_figures(mesh, make_chart(mesh, count)).p95 for count in (0, 30)]
    assert stretch[1] < stretch[0]


def test_a_closed_surface_is_refused_with_the_remedy() -> None:
    with pytest.raises(FaceError, match="closed and has no chart; cut it open"):
        make_chart(cube())

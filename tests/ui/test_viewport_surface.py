"""VTK draws the very arrays that the superposition writes."""

import numpy as np
import pytest
from vtkmodules.util.numpy_support import vtk_to_numpy

from facemodel.superposition import Superposition
from tests.ui.sitter import sitter, weights
from ui.viewport.figure import Figure
from ui.viewport.seams import seam_triangles
from ui.viewport.surface import Surface, companion

TRIANGLE = np.array([[0, 1, 2]])


def corner() -> tuple[np.ndarray, np.ndarray]:
    points = np.array([[0, 0, 0], [1, 0, 0], [0, 1, 0]], dtype=np.float32)
    return points, np.tile(np.float32([0, 0, 1]), (3, 1))


def test_points_normals_and_colours_are_the_arrays_given() -> None:
    points, normals = corner()
    colours = np.full((3, 4), 7, dtype=np.uint8)
    data = Surface(points, normals, TRIANGLE, colours).data
    for drawn, given in (
        (data.GetPoints().GetData(), points),
        (data.GetPointData().GetNormals(), normals),
        (data.GetPointData().GetScalars(), colours),
    ):
        assert np.shares_memory(vtk_to_numpy(drawn), given)


def test_what_is_written_is_seen_after_moved() -> None:
    points, normals = corner()
    surface = Surface(points, normals, TRIANGLE)
    assert surface.actor.GetBounds()[1] == 1.0
    points[1, 0] = 5.0
    surface.moved()
    assert surface.actor.GetBounds()[1] == 5.0


def test_an_array_that_vtk_would_have_to_copy_is_refused() -> None:
    points, normals = corner()
    with pytest.raises(ValueError, match="contiguous"):
        Surface(np.asfortranarray(points), normals, TRIANGLE)


def test_companions_stand_on_the_points_of_the_surface() -> None:
    points, normals = corner()
    surface = Surface(points, normals, TRIANGLE)
    lines = companion(surface, np.array([[0, 1], [1, 2]]))
    dots = companion(surface, np.array([[2]]))
    points[2, 1] = 9.0
    surface.moved()
    assert lines.GetBounds()[3] == 9.0
    assert dots.GetMapper().GetInput().GetPoints() is surface.data.GetPoints()


def test_the_skin_is_drawn_out_of_the_superposition() -> None:
    project, solution = sitter()
    posed = Superposition(project.face, solution.basis)
    figure = Figure(posed)
    data = figure.skin.surface.data
    posed.pose(weights(au12=1.0))
    assert np.shares_memory(vtk_to_numpy(data.GetPoints().GetData()), posed.points)
    assert np.shares_memory(vtk_to_numpy(data.GetPointData().GetNormals()), posed.normals)
    before = figure.skin.surface.actor.GetMTime(), data.GetPoints().GetMTime()
    figure.follow()
    assert data.GetPoints().GetMTime() > before[1]


def test_what_fills_the_slivers_of_the_openings_faces_as_the_skin_beside_it() -> None:
    display = sitter()[1].basis.display

    def ways(triangles: np.ndarray) -> set[tuple[int, int]]:
        return {(int(a), int(b)) for corners in triangles for a, b in zip(corners, np.roll(corners, -1), strict=True)}

    skin, slivers = ways(display.triangles), ways(seam_triangles(display))
    assert not slivers & skin
    assert len({(b, a) for a, b in slivers} & skin) > 50

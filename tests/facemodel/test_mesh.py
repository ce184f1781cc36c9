"""Normals, areas, edges, loops and parts of triangle meshes, against closed forms."""

from functools import cache

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from facemodel.mesh import Mesh, loop_length, submesh
from tests.fem.meshes import irregular, plate


def cube(size: float = 2.0) -> Mesh:
    """Return a closed cube, its faces counter-clockwise seen from outside."""
    corners = size * np.array([[x, y, z] for z in (0, 1) for y in (0, 1) for x in (0, 1)], dtype=np.float64)
    quads = np.array([[0, 2, 3, 1], [4, 5, 7, 6], [0, 1, 5, 4], [2, 6, 7, 3], [0, 4, 6, 2], [1, 3, 7, 5]])
    return Mesh(corners, np.concatenate([quads[:, [0, 1, 2]], quads[:, [0, 2, 3]]]))


@cache
def annulus() -> Mesh:
    surface = irregular()
    return Mesh(surface.positions, surface.triangles)


def test_normals_of_a_closed_mesh_point_outwards_and_sum_to_nothing() -> None:
    mesh = cube()
    assert mesh.triangle_normals.sum(axis=0) == pytest.approx(0.0, abs=1e-12)
    outward = mesh.positions - mesh.positions.mean(axis=0)
    assert np.all(np.einsum("ij,ij->i", mesh.normals, outward) > 0)
    assert np.linalg.norm(mesh.normals, axis=1) == pytest.approx(1.0)


def test_areas_of_vertices_sum_to_the_area_of_the_surface() -> None:
    assert cube(3.0).vertex_areas.sum() == pytest.approx(6 * 9.0)


def test_a_vertex_that_no_triangle_uses_has_neither_normal_nor_area() -> None:
    mesh = Mesh(np.eye(4, 3), np.array([[0, 1, 2]]))
    assert np.array_equal(mesh.normals[3], np.zeros(3))
    assert mesh.vertex_areas[3] == 0.0


def test_edges_come_once_and_obey_euler() -> None:
    mesh = cube()
    assert len(mesh.positions) - len(mesh.edges) + len(mesh.triangles) == 2
    assert np.all(mesh.edges[:, 0] < mesh.edges[:, 1])
    assert np.array_equal(mesh.adjacency.toarray(), mesh.adjacency.toarray().T)
    assert mesh.adjacency.sum() == 2 * len(mesh.edges)


def test_loops_run_along_edges_and_the_longest_comes_last() -> None:
    mesh = annulus()
    assert len(mesh.boundary_loops) == 2
    lengths = [loop_length(mesh.positions, loop) for loop in mesh.boundary_loops]
    assert lengths == sorted(lengths)
    for loop in mesh.boundary_loops:
        assert np.all(mesh.adjacency[loop, np.roll(loop, -1)] == 1)
    assert cube().boundary_loops == ()


def test_the_length_of_a_loop_is_closed() -> None:
    corners = np.array([[0.0, 0, 0], [3, 0, 0], [3, 4, 0], [0, 4, 0]])
    assert loop_length(corners, np.arange(4)) == 14.0


@given(st.integers(0, 2**32 - 1))
def test_a_part_keeps_its_triangles_where_they_are(seed: int) -> None:
    mesh = annulus()
    keep = np.random.default_rng(seed).random(len(mesh.triangles)) < 0.5
    part, vertices = submesh(mesh, keep)
    assert np.array_equal(mesh.positions[vertices], part.positions)
    assert np.array_equal(vertices[part.triangles], mesh.triangles[keep])
    assert np.array_equal(np.unique(part.triangles), np.arange(len(part.positions)))


def test_moving_a_mesh_renews_what_is_read_off_it() -> None:
    surface = plate(2)
    flat = Mesh(surface.positions, surface.triangles)
    assert flat.normals == pytest.approx(np.tile([0.0, 0, 1], (9, 1)))
    upright = flat.moved(flat.positions[:, [2, 0, 1]])
    assert upright.normals == pytest.approx(np.tile([1.0, 0, 0], (9, 1)))

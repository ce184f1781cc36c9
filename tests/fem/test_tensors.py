"""Material tensors in the frames of the triangles."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from fem import ElementTensors, FemError, Material, element_tensors, uniform_material
from tests.fem.meshes import domed, irregular, plate

ANGLES = st.floats(0.0, 6.3)
STIFFNESS = st.floats(0.0, 10.0)


def plate_tensors(angle: float, stretching: list[float], bending: list[float]) -> tuple[ElementTensors, np.ndarray]:
    surface = plate(2)
    count = surface.n_vertices
    direction = np.tile([np.cos(angle), np.sin(angle), 0.0], (count, 1))
    material = Material(direction, np.tile(stretching, (count, 1)), np.tile(bending, (count, 1)))
    return element_tensors(surface, material), surface.frames[:, :, :2]


@given(ANGLES, STIFFNESS, STIFFNESS, st.floats(-2.0, 2.0), st.floats(-2.0, 2.0))
def test_stretching_energy_of_a_slope(angle: float, along: float, across: float, x: float, y: float) -> None:
    tensors, frames = plate_tensors(angle, [along, across], [1.0, 1.0, 1.0])
    slope = frames @ np.array([x, y])
    found = np.einsum("ti,tcij,tj->tc", slope, tensors.stretching, slope)
    first, second = x * np.cos(angle) + y * np.sin(angle), y * np.cos(angle) - x * np.sin(angle)
    assert found == pytest.approx(along * first**2 + across * second**2, abs=1e-10)


@given(ANGLES, st.lists(STIFFNESS, min_size=3, max_size=3), st.lists(st.floats(-2.0, 2.0), min_size=3, max_size=3))
def test_bending_energy_of_a_curvature(angle: float, bending: list[float], curvature: list[float]) -> None:
    tensors, frames = plate_tensors(angle, [1.0, 1.0], bending)
    hessian = np.array([[curvature[0], curvature[2]], [curvature[2], curvature[1]]])
    in_frame = frames @ hessian @ np.swapaxes(frames, 1, 2)
    rows = np.stack([in_frame[:, 0, 0], in_frame[:, 1, 1], in_frame[:, 0, 1]], axis=1)
    found = np.einsum("ti,tcij,tj->tc", rows, tensors.bending, rows)
    axes = np.array([[np.cos(angle), np.sin(angle)], [-np.sin(angle), np.cos(angle)]])
    own = axes @ hessian @ axes.T
    exact = bending[0] * own[0, 0] ** 2 + bending[1] * own[1, 1] ** 2 + 2.0 * bending[2] * own[0, 1] ** 2
    assert found == pytest.approx(exact, abs=1e-9)


def test_length_and_normal_part_of_the_direction_do_not_matter() -> None:
    surface = plate(3)
    rng = np.random.default_rng(0)
    count = surface.n_vertices
    direction = rng.standard_normal((count, 3)) * [1.0, 1.0, 0.0]
    stiff = rng.uniform(0.1, 2.0, (count, 2)), rng.uniform(0.1, 2.0, (count, 3))
    plain = element_tensors(surface, Material(direction, *stiff))
    lifted = element_tensors(surface, Material(7.0 * direction + [0.0, 0.0, 2.0], *stiff))
    assert lifted.stretching == pytest.approx(plain.stretching)
    assert lifted.bending == pytest.approx(plain.bending)


@pytest.mark.parametrize("direction", [[0.0, 0.0, 1.0], [0.0, 0.0, 0.0]])
def test_a_direction_along_the_normal_falls_back_to_the_first_edge(direction: list[float]) -> None:
    surface = plate(1)
    material = Material(np.tile(direction, (4, 1)), np.tile([3.0, 1.0], (4, 1)), np.tile([1.0, 2.0, 3.0], (4, 1)))
    tensors = element_tensors(surface, material)
    assert tensors.stretching == pytest.approx(np.broadcast_to(np.diag([3.0, 1.0]), (2, 3, 2, 2)))
    assert tensors.bending == pytest.approx(np.broadcast_to(np.diag([1.0, 2.0, 6.0]), (2, 3, 3, 3)))


def test_isotropic_tensors_are_the_same_in_every_frame() -> None:
    surface = domed(irregular())
    tensors = element_tensors(surface, uniform_material(surface.n_vertices, stretching=2.0, bending=3.0))
    assert tensors.stretching == pytest.approx(np.broadcast_to(2.0 * np.eye(2), tensors.stretching.shape), abs=1e-12)
    expected = np.broadcast_to(np.diag([3.0, 3.0, 6.0]), tensors.bending.shape)
    assert tensors.bending == pytest.approx(expected, abs=1e-12)


def test_bad_materials_are_refused() -> None:
    good = uniform_material(4, 1.0, 1.0)
    negative = good.stretching.copy()
    negative[2, 1] = -0.5
    with pytest.raises(FemError, match=r"stretching of vertex 2 is \[1.0, -0.5\]"):
        Material(good.direction, negative, good.bending)
    with pytest.raises(FemError, match="bending of vertex 0"):
        Material(good.direction, good.stretching, np.full((4, 3), np.nan))
    with pytest.raises(FemError, match="direction of vertex 0"):
        Material(np.full((4, 3), np.inf), good.stretching, good.bending)
    with pytest.raises(FemError, match=r"\(4, 2\)"):
        Material(good.direction, good.bending, good.bending)
    with pytest.raises(FemError, match="4 vertices, the surface 9"):
        element_tensors(plate(2), good)


def test_indefinite_element_tensors_are_refused() -> None:
    surface = plate(1)
    good = element_tensors(surface, uniform_material(4, 1.0, 1.0))
    bending = good.bending.copy()
    bending[1, 2, 0, 1] = bending[1, 2, 1, 0] = 1.5
    with pytest.raises(FemError, match="bending of triangle 1"):
        ElementTensors(good.stretching, bending)
    stretching = good.stretching.copy()
    stretching[0, 0, 0, 1] = 0.5
    with pytest.raises(FemError, match="stretching of triangle 0"):
        ElementTensors(stretching, good.bending)

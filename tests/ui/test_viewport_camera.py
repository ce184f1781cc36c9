"""The camera frames the head at any shape of picture, and never rolls."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from vtkmodules.vtkRenderingCore import vtkCamera

from facemodel.faces import load_face
from ui.viewport.camera import (
    DIRECTIONS,
    LENS,
    MARGIN,
    POLE,
    Frame,
    angles,
    direction,
    face_frame,
    head_frame,
    look_along,
    look_from,
    orbit,
    pan,
    picture_scale,
    project_in_parallel,
    zoom,
)

HEAD = head_frame(load_face("ada"))
degrees = st.floats(-170.0, 170.0)


def seen(camera: vtkCamera, places: np.ndarray, aspect: float) -> np.ndarray:
    """Where places are in the picture, (n, 2): -1..1 from edge to edge."""
    matrix = camera.GetCompositeProjectionTransformMatrix(aspect, -1, 1)
    rows = np.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])
    flat = np.column_stack([places, np.ones(len(places))]) @ rows.T
    return flat[:, :2] / flat[:, 3:]


def edges(camera: vtkCamera) -> tuple[np.ndarray, np.ndarray]:
    """Unit vectors along the picture, to the right and up."""
    towards = np.array(camera.GetDirectionOfProjection())
    sideways = np.cross(towards, camera.GetViewUp())
    sideways /= np.linalg.norm(sideways)
    return sideways, np.cross(sideways, towards)


def looking(azimuth: float = 20.0, elevation: float = 10.0, aspect: float = 1.3) -> vtkCamera:
    camera = vtkCamera()
    look_along(camera, HEAD, azimuth, elevation, aspect)
    return camera


@pytest.mark.parametrize("view", DIRECTIONS)
@pytest.mark.parametrize("aspect", [0.5, 1.0, 1.33, 2.6])
def test_the_whole_head_is_seen_with_a_margin_and_fills_the_picture(view: str, aspect: float) -> None:
    camera = vtkCamera()
    look_from(camera, HEAD, view, aspect)
    places = seen(camera, HEAD.places, aspect)
    assert np.abs(places).max() == pytest.approx(1 / MARGIN, rel=0.01)
    assert np.abs(places.min(axis=0) + places.max(axis=0)).max() < 0.02


def test_the_lens_is_that_of_a_portrait() -> None:
    assert 20 <= LENS <= 25
    assert looking().GetViewAngle() == LENS


def test_left_and_right_are_the_subjects_own() -> None:
    for view, side in (("left", 1.0), ("right", -1.0)):
        camera = vtkCamera()
        look_from(camera, HEAD, view, 1.0)
        assert np.sign(camera.GetPosition()[0]) == side


def test_a_small_picture_shows_the_face_larger_than_a_whole_head() -> None:
    face = load_face("ada")
    whole, near = looking(0, 0), vtkCamera()
    look_along(near, face_frame(face), 0, 0, 1.3)
    assert near.GetDistance() < 0.8 * whole.GetDistance()


@given(st.lists(st.tuples(degrees, degrees), min_size=1, max_size=6))
@settings(max_examples=40)
def test_turning_never_rolls_and_never_goes_over_the_top(turns: list[tuple[float, float]]) -> None:
    camera = looking()
    for azimuth, elevation in turns:
        orbit(camera, HEAD.centre, azimuth, elevation)
    sideways = np.cross(camera.GetDirectionOfProjection(), camera.GetViewUp())
    assert abs(sideways[1]) < 1e-9
    assert abs(angles(camera)[1]) <= POLE + 1e-6


@given(degrees, st.floats(-60.0, 60.0))
@settings(max_examples=40)
def test_turning_keeps_the_distance_and_the_pivot_in_its_place(azimuth: float, elevation: float) -> None:
    camera = looking()
    pan(camera, 0.2, -0.1)
    pivot = HEAD.centre
    before = seen(camera, pivot[None], 1.3)
    away = np.linalg.norm(np.array(camera.GetPosition()) - pivot)
    orbit(camera, pivot, azimuth, elevation)
    assert np.linalg.norm(np.array(camera.GetPosition()) - pivot) == pytest.approx(away)
    assert seen(camera, pivot[None], 1.3) == pytest.approx(before, abs=1e-9)


def test_turning_goes_the_way_it_says() -> None:
    camera = looking(0, 0)
    orbit(camera, HEAD.centre, 30.0, 15.0)
    assert angles(camera) == pytest.approx((30.0, 15.0))
    assert direction(30.0, 15.0) == pytest.approx(-np.array(camera.GetDirectionOfProjection()))


@given(st.floats(0.3, 3.0), st.floats(-0.6, 0.6), st.floats(-0.5, 0.5), st.booleans())
@settings(max_examples=40)
def test_what_lies_under_the_pointer_stays_there_when_zooming(
    factor: float, right: float, up: float, parallel: bool
) -> None:
    camera = looking()
    project_in_parallel(camera, parallel)
    sideways, upwards = edges(camera)
    place = np.array(camera.GetFocalPoint()) + 2 * picture_scale(camera) * (right * sideways + up * upwards)
    before = seen(camera, place[None], 1.3)
    scale = picture_scale(camera)
    zoom(camera, factor, right, up)
    assert picture_scale(camera) == pytest.approx(scale / factor)
    assert seen(camera, place[None], 1.3) == pytest.approx(before, abs=1e-6)


def test_panning_moves_the_picture_with_the_hand() -> None:
    camera = looking()
    place = np.array(camera.GetFocalPoint())[None]
    pan(camera, 0.25, 0.1)
    x, y = seen(camera, place, 1.3)[0]
    assert (x * 1.3 / 2, y / 2) == pytest.approx((0.25, 0.1))


def test_parallel_projection_keeps_the_size_of_the_head_and_comes_back() -> None:
    camera = looking()
    focus, before = np.array(camera.GetFocalPoint()), np.array(camera.GetPosition())
    edge = (focus + edges(camera)[1] * picture_scale(camera))[None]
    at = seen(camera, edge, 1.3)
    project_in_parallel(camera, True)
    assert seen(camera, edge, 1.3) == pytest.approx(at, abs=1e-6)
    project_in_parallel(camera, False)
    assert np.array(camera.GetPosition()) == pytest.approx(before)


def test_a_frame_may_be_a_single_box() -> None:
    box = Frame(np.zeros(3), np.array([[-1.0, -2.0, -1.0], [1.0, 2.0, 1.0]]))
    camera = vtkCamera()
    look_along(camera, box, 0, 0, 1.0)
    assert np.abs(seen(camera, box.places, 1.0)).max() == pytest.approx(1 / MARGIN, rel=0.01)

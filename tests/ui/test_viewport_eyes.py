"""Eyes as they are drawn: a picture carries their colours, and turns with them."""

import numpy as np
import pytest
import pyvista as pv

from facemodel.eyeball import IRIS_RADIUS, PUPIL_RADIUS
from facemodel.faces import load_face
from facemodel.projects import new_project
from fem.types import FloatArray
from ui.viewport.camera import look_closely
from ui.viewport.complexion import PALETTES
from ui.viewport.eye_picture import eye_coordinates, eye_picture
from ui.viewport.eyes import EyesInLids
from ui.viewport.fineness import Occlusion
from ui.viewport.joined import Shape, joined
from ui.viewport.lids import lid_line
from ui.viewport.scene import Scene

BALL = 12.4
BROWN, BLUE = PALETTES["chen"].iris, (0.30, 0.42, 0.55)


def seen(picture: np.ndarray, away: float, turn: float, forward: bool = True) -> FloatArray:
    """The colour (3,) that lies so many millimetres from the axis of the eye."""
    z = np.sqrt(BALL**2 - away**2) * (1 if forward else -1)
    place = np.array([[away * np.cos(turn), away * np.sin(turn), z]])
    column, row = (eye_coordinates(place, BALL)[0] * [picture.shape[1], picture.shape[0]]).astype(int)
    return picture[row, column].astype(float)


def ring(picture: np.ndarray, away: float) -> FloatArray:
    return np.mean([seen(picture, away, turn) for turn in np.linspace(0, 2 * np.pi, 60)], axis=0)


def test_an_eye_is_black_in_the_middle_then_coloured_then_dark_then_white() -> None:
    picture = eye_picture(BALL, BLUE)
    pupil, iris, rim, white = (ring(picture, at).mean() for at in (0.5, 4.0, IRIS_RADIUS - 0.1, IRIS_RADIUS + 1.5))
    assert pupil < 10
    assert rim < 0.7 * iris < iris < 0.8 * white


def test_the_pupil_has_a_sharp_and_round_edge() -> None:
    picture = eye_picture(BALL, BLUE)
    for turn in np.linspace(0, 2 * np.pi, 24):
        assert seen(picture, PUPIL_RADIUS - 0.1, turn).mean() < 20
        assert seen(picture, PUPIL_RADIUS + 0.35, turn).mean() > 20


@pytest.mark.parametrize("iris", [BROWN, BLUE])
def test_an_iris_has_the_colour_of_its_owner(iris: tuple[float, float, float]) -> None:
    found = ring(eye_picture(BALL, iris), 4.3) / 255
    assert np.corrcoef(found / found.mean(), np.array(iris) / np.mean(iris))[0, 1] > 0.9


def test_every_place_of_the_ball_but_its_back_is_on_the_picture() -> None:
    angle, turn = np.meshgrid(np.linspace(0.0, np.radians(115), 40), np.linspace(0, 2 * np.pi, 60))
    away = BALL * np.sin(angle)
    places = np.stack([away * np.cos(turn), away * np.sin(turn), BALL * np.cos(angle)], axis=-1).reshape(-1, 3)
    at = eye_coordinates(places, BALL)
    assert at.min() > 0
    assert at.max() < 1
    order = np.hypot(*(at - 0.5).T).reshape(angle.shape)
    assert (np.diff(order, axis=1) > 0).all(), "the farther from the axis, the farther out"


def test_shapes_that_are_joined_are_drawn_where_they_are_written() -> None:
    one = Shape(np.zeros((3, 3), np.float32), np.zeros((3, 3), np.float32), np.array([[0, 1, 2]]))
    surface, (first, second) = joined([one, one])
    second.points[:] = 7.0
    assert surface.points[3:].min() == 7.0
    assert not surface.points[:3].any()
    assert np.shares_memory(surface.points, first.points)
    assert surface.data.GetNumberOfCells() == 2
    assert surface.data.GetCell(1).GetPointId(2) == 5


def test_each_eye_turns_by_its_own_motion() -> None:
    face = load_face("ada")
    lids = [lid_line(face.skin.positions, face.skin.triangles, eye) for eye in face.eyes]
    eyes = EyesInLids(face.eyes, lids, BLUE)
    assert eyes.balls is not None
    assert eyes.films is not None
    before = eyes.balls.points.copy()
    half = len(before) // 2
    moved = np.eye(4)
    moved[:3, 3] = 0.0, 0.0, 3.0
    eyes.follow([moved, np.eye(4)], face.skin.positions.astype(np.float32))
    assert np.allclose(eyes.balls.points[:half] - before[:half], [0.0, 0.0, 3.0], atol=1e-4)
    assert np.array_equal(eyes.balls.points[half:], before[half:])
    eyes.follow([np.eye(4), np.eye(4)], face.skin.positions.astype(np.float32))
    assert np.allclose(eyes.balls.points, before, atol=1e-4)


def test_ambient_occlusion_leaves_an_iris_as_bright_as_it_is() -> None:
    """The lids' shade is on it already: with more of it eyes would look dead."""
    project = new_project()
    plotter = pv.Plotter(off_screen=True, window_size=(480, 320), lighting="none")
    plotter.render_window.SetMultiSamples(0)
    scene, occlusion = Scene(plotter), None
    try:
        scene.show(project)
        eye = project.face.eyes[0]
        look_closely(scene.renderer, eye.centre + np.array([0.0, 0.0, eye.radius]), np.array([0.0, 0.0, 1.0]), 12.0)
        occlusion = Occlusion(scene.renderer)
        bright, skin = [], []
        for on in (False, True):
            occlusion.switch(on)
            scene.before_frame()
            plotter.render_window.Render()
            picture = plotter.screenshot(return_img=True).astype(float)
            bright.append(picture[190:215, 215:265].mean())
            skin.append(picture)
    finally:
        if occlusion is not None:
            occlusion.release()
        plotter.close()
    assert bright[1] == pytest.approx(bright[0], rel=0.02)
    assert skin[1].mean() < skin[0].mean(), "the skin about it is shaded"

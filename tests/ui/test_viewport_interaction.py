"""Right drag and Alt-drag turn, middle drag pans, the wheel zooms to the pointer, the left button is left alone."""

from collections.abc import Iterator

import numpy as np
import pytest
from vtkmodules.vtkRenderingCore import vtkCamera, vtkRenderer, vtkRenderWindow, vtkRenderWindowInteractor

from facemodel.faces import load_face
from ui.viewport.camera import angles, head_frame, look_from, picture_scale
from ui.viewport.interaction import CameraHands

HEAD = head_frame(load_face("ada"))
WIDE, HIGH = 800, 600


class Mouse:
    """A hand on an interactor that nobody sees."""

    def __init__(self) -> None:
        self.window = vtkRenderWindow()
        self.window.SetOffScreenRendering(True)
        self.window.SetSize(WIDE, HIGH)
        self.renderer = vtkRenderer()
        self.window.AddRenderer(self.renderer)
        self.interactor = vtkRenderWindowInteractor()
        self.interactor.SetRenderWindow(self.window)
        self.pictures = 0
        look_from(self.camera, HEAD, "front", WIDE / HIGH)
        self.hands = CameraHands(self.interactor, self.renderer, lambda: HEAD.centre, self.asked)

    @property
    def camera(self) -> vtkCamera:
        return self.renderer.GetActiveCamera()

    def asked(self) -> None:
        self.pictures += 1

    def at(self, x: int, y: int, event: str, alt: bool = False) -> None:
        self.interactor.SetEventInformation(x, y, 0, 0, "\0", 0, None)
        self.interactor.SetAltKey(alt)
        self.interactor.InvokeEvent(event)

    def drag(self, button: str, by: tuple[int, int], alt: bool = False) -> None:
        self.at(400, 300, f"{button}ButtonPressEvent", alt)
        for step in (1, 2, 3):
            self.at(400 + by[0] * step // 3, 300 + by[1] * step // 3, "MouseMoveEvent", alt)
        self.at(400 + by[0], 300 + by[1], f"{button}ButtonReleaseEvent", alt)

    def state(self) -> np.ndarray:
        return np.concatenate([self.camera.GetPosition(), self.camera.GetFocalPoint(), self.camera.GetViewUp()])


@pytest.fixture
def mouse() -> Iterator[Mouse]:
    made = Mouse()
    yield made
    made.hands.let_go()
    made.window.Finalize()


@pytest.mark.parametrize(("button", "alt"), [("Right", False), ("Left", True)])
def test_turning_follows_the_hand_about_the_head(mouse: Mouse, button: str, alt: bool) -> None:
    mouse.drag(button, (-90, -60), alt)
    azimuth, elevation = angles(mouse.camera)
    assert azimuth > 10
    assert elevation > 5
    away = np.linalg.norm(np.array(mouse.camera.GetPosition()) - HEAD.centre)
    look_from(mouse.camera, HEAD, "front", WIDE / HIGH)
    assert away == pytest.approx(np.linalg.norm(np.array(mouse.camera.GetPosition()) - HEAD.centre))


def test_the_left_button_alone_does_nothing_to_the_camera(mouse: Mouse) -> None:
    before = mouse.state()
    mouse.drag("Left", (80, 40))
    assert np.array_equal(mouse.state(), before)
    assert mouse.pictures == 0


def test_panning_moves_the_focus_and_keeps_the_direction(mouse: Mouse) -> None:
    before = np.array(mouse.camera.GetDirectionOfProjection())
    mouse.drag("Middle", (0, 60))
    assert mouse.camera.GetFocalPoint()[1] < HEAD.centre[1]
    assert np.array(mouse.camera.GetDirectionOfProjection()) == pytest.approx(before)


def test_the_wheel_brings_what_is_under_the_pointer_near(mouse: Mouse) -> None:
    before = picture_scale(mouse.camera)
    mouse.at(700, 300, "MouseWheelForwardEvent")
    assert picture_scale(mouse.camera) < before
    assert mouse.camera.GetFocalPoint()[0] > 1.0
    mouse.at(700, 300, "MouseWheelBackwardEvent")
    assert picture_scale(mouse.camera) == pytest.approx(before)


def test_a_motion_asks_for_one_picture_and_a_resting_hand_for_none(mouse: Mouse) -> None:
    mouse.at(400, 300, "RightButtonPressEvent")
    assert mouse.hands.busy
    mouse.at(410, 300, "MouseMoveEvent")
    mouse.at(410, 300, "MouseMoveEvent")
    assert mouse.pictures == 1
    mouse.at(410, 300, "RightButtonReleaseEvent")
    mouse.at(500, 300, "MouseMoveEvent")
    assert mouse.pictures == 1
    assert not mouse.hands.busy


def test_after_letting_go_nothing_follows(mouse: Mouse) -> None:
    mouse.hands.let_go()
    before = mouse.state()
    mouse.drag("Right", (50, 50))
    assert np.array_equal(mouse.state(), before)

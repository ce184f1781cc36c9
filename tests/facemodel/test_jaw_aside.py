"""A jaw that goes aside turns about the condyle of that side, and left and right are mirror images."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from facemodel.actions import ActionUnit, JawMotion
from facemodel.face import Jaw
from facemodel.fields import jaw_table
from facemodel.jaw.motion import jaw_motion
from facemodel.solve import solve_project
from facemodel.superposition import Superposition
from tests.app.conftest import small_project

JAW = Jaw(np.array([[-50.0, 0, -20], [50.0, 0, -20]]), np.array([0.0, -40, 65]))
SWAY = ActionUnit(30, "jaw sideways", "jaw", True, {}, 8.0, JawMotion(0.0, 0.0, 8.0))


def carried(motion: np.ndarray, point: np.ndarray) -> np.ndarray:
    return motion[:3, :3] @ point + motion[:3, 3]


@given(st.floats(1.0, 12.0), st.floats(0.0, 30.0), st.floats(0.0, 10.0))
def test_the_incisors_go_aside_and_the_condyle_of_that_side_stays(side: float, degrees: float, slide: float) -> None:
    middle, left = jaw_motion(JAW, degrees, slide), jaw_motion(JAW, degrees, slide, side)
    assert left[:3, :3] @ left[:3, :3].T == pytest.approx(np.eye(3), abs=1e-12)
    way = carried(left, JAW.teeth) - carried(middle, JAW.teeth)
    assert 0.6 * side < way[0] < 1.05 * side
    assert carried(left, JAW.axis[1]) == pytest.approx(carried(middle, JAW.axis[1]), abs=1e-9)
    right = jaw_motion(JAW, degrees, slide, -side)
    mirrored = carried(right, JAW.teeth * [-1, 1, 1]) * [-1, 1, 1]
    assert mirrored == pytest.approx(carried(left, JAW.teeth), abs=1e-9)


def test_the_incisors_draw_the_gothic_arch() -> None:
    way = carried(jaw_motion(JAW, 0.0, 0.0, 2.0), JAW.teeth) - JAW.teeth
    assert way[0] == pytest.approx(2.0, rel=0.05)
    off_midline = np.degrees(np.arctan2(way[0], np.hypot(way[1], way[2])))
    assert 55 < off_midline < 68


def test_no_shift_is_to_the_bit_what_it_was_before_there_was_one() -> None:
    assert np.array_equal(jaw_motion(JAW, 12.0, 3.0, 0.0), jaw_motion(JAW, 12.0, 3.0))


def test_skin_and_teeth_go_to_the_side_of_the_slider_and_both_sides_together_stay() -> None:
    project = replace(small_project(), units=(SWAY,))
    basis = solve_project(project).basis
    assert np.array_equal(jaw_table(project.units), [[0, 0, 8.0], [0, 0, -8.0]])
    over_jaw = basis.display.points[:, 1] < -25
    assert basis.field("30L")[over_jaw, 0].mean() > 0.5
    assert basis.field("30R")[over_jaw, 0].mean() < -0.5
    posed = Superposition(project.face, basis)
    rest = posed.parts["teeth-lower"].copy()
    posed.pose({"30L": 1.0})
    assert (posed.parts["teeth-lower"] - rest)[:, 0].min() > 4
    posed.pose({"30L": 1.0, "30R": 1.0})
    assert posed.parts["teeth-lower"] == pytest.approx(rest, abs=1e-5)

"""The tongue comes out between the lips and over the lower teeth, and is where it was when it is drawn back."""

import numpy as np
import pytest

from facemodel.basis import Basis
from facemodel.face import Face, Part
from facemodel.kinematics import rig_of
from facemodel.motions import TongueMotion
from facemodel.project import Project
from facemodel.superposition import Superposition
from facemodel.tongue import tongue_places


@pytest.fixture(scope="module")
def tongue(face: Face) -> Part:
    return next(part for part in face.parts if part.kind == "tongue")


def test_tongue_show_brings_the_tip_before_the_lips_and_back(project: Project, basis: Basis, tongue: Part) -> None:
    posed = Superposition(project.face, basis, rig_of(project.units))
    rest = posed.parts[tongue.name].copy()
    lip = project.face.skin.positions[project.face.landmarks["lower_lip_mid"], 2]
    assert rest[:, 2].max() < lip - 10
    posed.pose({"19": 1.0})
    assert posed.parts[tongue.name][:, 2].max() > lip + 5
    posed.pose({})
    assert np.array_equal(posed.parts[tongue.name], rest)


def test_a_tongue_that_is_out_lies_over_the_lower_teeth(face: Face, tongue: Part) -> None:
    teeth = next(part for part in face.parts if part.kind == "teeth" and part.carrier == "jaw").mesh.positions
    incisors = teeth[teeth[:, 2] > teeth[:, 2].max() - 4.0]
    places = tongue_places(face, tongue, TongueMotion(30.0))
    over = places[np.abs(places[:, 2] - teeth[:, 2].max()) < 3.0]
    assert len(over) > 0
    assert over[:, 1].min() > incisors[:, 1].max()


def test_the_back_of_the_tongue_stays_and_the_tip_goes_all_the_way(face: Face, tongue: Part) -> None:
    rest = tongue.mesh.positions
    moved = tongue_places(face, tongue, TongueMotion(20.0)) - rest
    assert np.abs(moved[rest[:, 2].argmin()]).max() < 1e-9
    assert moved[rest[:, 2].argmax(), 2] == pytest.approx(20.0)


def test_a_tip_that_is_bent_goes_up_or_down(face: Face, tongue: Part) -> None:
    tip = tongue.mesh.positions[:, 2].argmax()
    up, level, down = (tongue_places(face, tongue, TongueMotion(30.0, lift))[tip, 1] for lift in (30.0, 0.0, -30.0))
    assert up > level + 3
    assert down < level - 3

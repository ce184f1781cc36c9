"""The one interface: every model on the default face, in the fields that are solved, and as a panel of numbers."""

from dataclasses import replace

import numpy as np
import pytest

from facemodel.actions import ActionUnit, JawMotion
from facemodel.errors import FaceError
from facemodel.face import Face
from facemodel.loads import bone_forces, field_forces, springs_carry_jaw
from facemodel.muscles import Muscle, Profile
from facemodel.muscles.models import MODELS, comparable_models, muscle_action, muscle_forces
from facemodel.muscles.muscle import Model
from facemodel.muscles.parameters import Parameter, ProfileParameter, value_of, with_value
from facemodel.project import Project, Settings
from facemodel.solve import solve_project
from tests.facemodel.places import vertex_fields
from tests.facemodel.skin import sizes

SMILE = ActionUnit(12, "lip corner puller", "diagonal", True, {"zygomaticus_major": 1.0}, 10.0)


def named(project: Project, key: str) -> Muscle:
    return next(muscle for muscle in project.muscles if muscle.key == key)


def jaw_muscle() -> Muscle:
    return Muscle("jaw_opening", "M", "Opening of the jaw", "chin", "jaw", (), None, 10.0, 1.0, 0.01, 1)


@pytest.mark.parametrize("model", ["fibre", "quadrilateral", "cosine"])
@pytest.mark.parametrize("side", ["L", "R"])
def test_every_model_of_a_zygomaticus_pulls_the_mouth_corner_up_and_out(
    project: Project, side: str, model: Model
) -> None:
    face = project.face
    muscle = replace(named(project, f"zygomaticus_major_{side}"), model=model)
    action = muscle_action(muscle, face)
    corner = face.landmarks[f"mouth_corner_{side}"]
    out = 1.0 if side == "L" else -1.0
    around = sizes(face.skin.positions - face.skin.positions[corner]) < 8.0
    pull = action[around].mean(axis=0)
    assert pull[1] > 0.3 * np.linalg.norm(pull), "up"
    assert out * pull[0] > 0.3 * np.linalg.norm(pull), "and out"
    assert sizes(action)[corner] > 0.5 * sizes(action).max(), "and near its strongest"
    assert sizes(action)[out * face.skin.positions[:, 0] < -15].max() == 0.0, "on its own side only"


def test_models_differ_in_kind_and_not_in_what_they_are_asked_for(project: Project) -> None:
    assert comparable_models(named(project, "zygomaticus_major_L")) == ("fibre", "quadrilateral", "cosine")
    assert comparable_models(named(project, "orbicularis_oris_marginal")) == (
        "sphincter",
        "mouth",
        "cosine_ring",
        "lid",
        "pressure",
    )
    assert comparable_models(jaw_muscle()) == ("jaw",)


@pytest.mark.parametrize("model", ["sphincter", "mouth", "cosine_ring"])
def test_every_model_of_a_mouth_narrows_it_alike_on_both_sides(project: Project, model: Model) -> None:
    face = project.face
    whole = named(project, "orbicularis_oris_marginal")
    assert whole.ring is not None
    action = muscle_action(replace(whole, model=model), face)
    left, right = (face.landmarks[f"mouth_corner_{side}"] for side in "LR")
    assert action[left, 0] < 0 < action[right, 0]
    assert action[face.mirror] == pytest.approx(action * [-1, 1, 1], abs=1e-3 * np.abs(action).max())


@pytest.mark.parametrize("model", MODELS)
def test_a_model_that_displaces_has_no_forces_and_one_that_pulls_has(project: Project, model: Model) -> None:
    geometry = {"fibres": "zygomaticus_major_L", "ring": "orbicularis_oculi_orbitalis_L"}.get(MODELS[model].geometry)
    muscle = replace(named(project, geometry) if geometry else jaw_muscle(), model=model)
    forces = muscle_forces(muscle, project.face)
    assert forces.any() == (MODELS[model].action == "force")
    assert muscle_action(muscle, project.face).any()


@pytest.mark.parametrize("model", MODELS)
def test_a_panel_can_be_made_of_every_model(project: Project, model: Model) -> None:
    geometry = {"fibres": "zygomaticus_major_L", "ring": "orbicularis_oculi_orbitalis_L"}.get(MODELS[model].geometry)
    muscle = replace(named(project, geometry) if geometry else jaw_muscle(), model=model)
    names = [parameter.name for parameter in MODELS[model].parameters]
    assert len(set(names)) == len(names)
    before = muscle_action(muscle, project.face)
    for parameter in MODELS[model].parameters:
        value = value_of(muscle, parameter.name)
        if isinstance(parameter, ProfileParameter):
            other: float | Profile = Profile((0.0, 0.7, 1.2), (0.0, 0.2, 0.0))
        else:
            assert parameter.least <= parameter.default <= parameter.most
            assert parameter.least <= value <= parameter.most
            other = _elsewhere(parameter, value)
        changed = with_value(muscle, parameter.name, other)
        assert value_of(changed, parameter.name) == other
        assert not np.array_equal(muscle_action(changed, project.face), before), parameter.name


def _elsewhere(parameter: Parameter, value: float) -> float:
    """A value well apart, so that every parameter shows; a box has to come close to cut anything off."""
    if parameter.name.startswith("cosine.box"):
        return 4.0
    half = (parameter.least + parameter.most) / 2
    return round(half) if parameter.whole else half if abs(half - value) > 1e-9 else parameter.least


def test_a_turned_force_lies_along_the_bone_and_the_jaws_own_does_not_turn(project: Project) -> None:
    face = project.face
    normals = face.skin.normals
    smile = bone_forces(named(project, "zygomaticus_major_L"), face)
    assert np.einsum("ij,ij->i", smile, normals).min() >= -1e-12
    assert np.array_equal(bone_forces(jaw_muscle(), face), muscle_action(jaw_muscle(), face))


def test_a_muscle_on_one_side_has_no_part_in_the_other(project: Project) -> None:
    only = (named(project, "zygomaticus_major_L"),)
    names, forces = field_forces((SMILE,), only, project.face)
    assert names == ("12L", "12R")
    assert forces[0].any()
    assert not forces[1].any()


def test_a_unit_without_its_muscle_says_which(project: Project) -> None:
    with pytest.raises(FaceError, match=r"12 \(lip corner puller\) contracts the muscle “zygomaticus_major”.*lay it"):
        field_forces((SMILE,), (), project.face)


def test_the_springs_carry_the_jaw_unless_a_muscle_pushes_it() -> None:
    drop = ActionUnit(26, "jaw drop", "jaw", False, {}, 12.0, JawMotion(12.0))
    pushed = replace(drop, muscles={"jaw_opening": 1.0})
    assert springs_carry_jaw(drop, (jaw_muscle(),))
    assert not springs_carry_jaw(pushed, (jaw_muscle(),))
    assert not springs_carry_jaw(SMILE, ())


@pytest.fixture(scope="module")
def pseudo_fields(project: Project) -> dict[str, np.ndarray]:
    """A smile by a pseudo-muscle on the left and by fibres on the right, solved at the coarsest density."""
    left = replace(named(project, "zygomaticus_major_L"), model="cosine", linked=False)
    muscles = (left, named(project, "zygomaticus_major_R"))
    pseudo = Project(project.face, muscles, (SMILE,), (), {}, Settings("hct9", 1))
    return vertex_fields(project.face, solve_project(pseudo).basis)


def test_a_displacing_muscle_moves_the_vertices_of_its_field_as_it_says(
    project: Project, pseudo_fields: dict[str, np.ndarray]
) -> None:
    face = project.face
    left = replace(named(project, "zygomaticus_major_L"), model="cosine")
    inner = np.ones(len(face.skin.positions), dtype=bool)
    inner[face.skin.triangles[~face.solved]] = False
    expected = muscle_action(left, face) * (inner & (face.layers.supports == 0))[:, None]
    assert pseudo_fields["12L"] == pytest.approx(expected, abs=1e-4)


def test_beside_it_the_fields_of_forces_are_solved_as_ever(face: Face, pseudo_fields: dict[str, np.ndarray]) -> None:
    corner = face.landmarks["mouth_corner_R"]
    assert pseudo_fields["12R"][corner, 0] < -1.0
    assert pseudo_fields["12R"][corner, 1] > 1.0
    far = face.landmarks["mouth_corner_L"]
    assert sizes(pseudo_fields["12R"])[far] < 0.2 * sizes(pseudo_fields["12R"])[corner]

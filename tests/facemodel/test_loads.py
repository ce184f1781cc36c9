"""From action units to loads: forces along the bone, sides that add up, and the pull of a turned jaw."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from facemodel.actions import skin_units
from facemodel.jaw.modes import JawMode, mode_shares
from facemodel.jaw.motion import jaw_motion
from facemodel.loads import STEEP, along_bone, bone_forces, field_forces, jaw_forces
from facemodel.muscles.models import muscle_forces
from facemodel.project import Project
from facemodel.tissue import tissue_springs
from tests.facemodel.skin import sizes

COMPONENT = st.floats(-1.0, 1.0)
VECTOR = st.tuples(COMPONENT, COMPONENT, COMPONENT).map(np.array).filter(lambda v: np.linalg.norm(v) > 1e-3)


@given(VECTOR, VECTOR)
def test_no_force_presses_into_the_bone_and_none_grows(force: np.ndarray, normal: np.ndarray) -> None:
    normal = normal / np.linalg.norm(normal)
    turned = along_bone(force[None], normal[None])[0]
    size = np.linalg.norm(force)
    assert turned @ normal >= -1e-9 * size
    inward = -(force @ normal) / size
    if inward <= 0:
        assert turned == pytest.approx(force), "what pulls away from the bone stays as it is"
    elif np.sqrt(1 - min(inward, 1.0) ** 2) > STEEP + 1e-6:
        assert np.linalg.norm(turned) == pytest.approx(size), "turned with its size kept"
    else:
        assert np.linalg.norm(turned) <= size * (1 + 1e-9), "straight into the bone there is no side to turn to"
    tangential = force - (force @ normal) * normal
    assert np.linalg.norm(np.cross(turned - (turned @ normal) * normal, tangential)) < 1e-9


def test_left_and_right_forces_add_up_to_both_sides(project: Project) -> None:
    """A muscle across the midline gives each side of a paired unit half its strength."""
    skin = project.face.skin
    names, forces = field_forces(project.units, project.muscles, project.face)
    by_key = {muscle.key: bone_forces(muscle, project.face) for muscle in project.muscles}
    for unit in skin_units(project.units):
        whole = np.zeros_like(skin.positions)
        for name, weight in unit.muscles.items():
            for key in (name,) if name in by_key else (f"{name}_L", f"{name}_R"):
                whole += weight * by_key[key]
        total = sum(forces[names.index(name)] for name in unit.fields)
        assert total == pytest.approx(whole, abs=1e-12)


def test_forces_of_the_shipped_muscles_have_no_inward_part(project: Project) -> None:
    skin = project.face.skin
    for muscle in project.muscles:
        turned = along_bone(muscle_forces(muscle, project.face), skin.normals)
        inward = np.einsum("ij,ij->i", turned, skin.normals)
        assert inward.min() >= -1e-12 * max(sizes(turned).max(), 1.0)
        assert sizes(turned).max() > 0.0, muscle.key


def test_an_opening_jaw_pulls_the_chin_along_and_the_forehead_not_at_all(project: Project) -> None:
    face = project.face
    vertices = np.arange(len(face.skin.positions))
    springs, anchors, jawbone = tissue_springs(face, vertices)
    modes = enumerate(mode_shares(face.skull.jaw, jaw_motion(face.skull.jaw, 15.0)))
    forces = sum(share * jaw_forces(face, JawMode(mode), springs, anchors, jawbone) for mode, share in modes)
    # A spring pulls along itself: under the chin that is down, at its front inwards.
    assert forces[face.landmarks["menton"], 1] < 0
    assert forces[face.landmarks["pogonion"], 2] < 0
    high = face.skin.positions[:, 1] > face.skin.positions[face.landmarks["nasion"], 1]
    assert np.abs(forces[high]).max() < 1e-3 * np.abs(forces).max()

"""Landmarks are vertices of the base mesh wherever it was cut, and lie where anatomy puts them on every person."""

from collections.abc import Callable

import numpy as np
import pytest
from numpy.typing import NDArray

from facemodel.errors import FaceError
from facemodel.face import Face
from facemodel.faces import face_keys
from facemodel.making.landmarks import MIDLINE, PAIRED, find_landmarks

EVERY_FACE = pytest.mark.parametrize("key", face_keys())
Shipped = Callable[[str], Face]

FROM_TOP = (
    "supraglabella",
    "glabella",
    "nasion",
    "rhinion",
    "nose_tip",
    "subnasale",
    "mid_philtrum",
    "upper_vermilion",
    "upper_lip_incisor",
    "lower_lip_incisor",
    "lower_vermilion",
    "chin_lip_fold",
    "pogonion",
    "chin",
    "menton",
)
"""The midline's landmarks in the order in which a finger meets them on its way down the profile."""


def cloud(seed: int) -> tuple[NDArray[np.float64], NDArray[np.int64], dict[str, int]]:
    """Return all landmarks of the base shape among other points in random order, their mirror map, and who is where."""
    generator = np.random.default_rng(seed)
    names = [*MIDLINE, *(f"{name}_{side}" for name in PAIRED for side in "LR")]
    places = [*MIDLINE.values(), *(np.multiply(place, (sign, 1, 1)) for place in PAIRED.values() for sign in (1, -1))]
    noise = generator.uniform((-70, 540, -40), (70, 590, 60), (200, 3))
    order = generator.permutation(len(places) + len(noise))
    positions = np.concatenate([places, noise])[order]
    where = np.argsort(order)
    mirror = np.arange(len(order))
    for k, name in enumerate(names):
        if name.endswith(("_L", "_R")):
            mirror[where[k]] = where[k + 1 if name.endswith("_L") else k - 1]
    return positions, mirror, {name: int(where[k]) for k, name in enumerate(names)}


@pytest.mark.parametrize("seed", [1, 2])
def test_landmarks_are_found_however_the_vertices_are_numbered(seed: int) -> None:
    positions, mirror, expected = cloud(seed)
    assert find_landmarks(positions, mirror) == expected


def test_another_base_mesh_is_refused() -> None:
    positions, mirror, _ = cloud(3)
    with pytest.raises(FaceError, match=r"supraglabella has no vertex near .* hm08"):
        find_landmarks(positions / 100, mirror)


def test_a_mirror_map_that_moves_the_midline_is_refused() -> None:
    positions, mirror, where = cloud(4)
    mirror[where["nasion"]] = where["menton"]
    with pytest.raises(FaceError, match="nasion is off the midline"):
        find_landmarks(positions, mirror)


@EVERY_FACE
def test_the_midline_runs_down_the_profile_in_order(shipped: Shipped, key: str) -> None:
    face = shipped(key)
    profile = face.skin.positions[[face.landmarks[name] for name in FROM_TOP]]
    assert (np.diff(profile[:, 1]) < 0).all()
    assert np.abs(profile[:, 0]).max() < 1e-3
    front = face.skin.positions[np.abs(face.skin.positions[:, 0]) < 5]
    tip = face.skin.positions[face.landmarks["nose_tip"]]
    assert tip[2] > front[:, 2].max() - 1.5, "hardly anything stands out farther than the tip of the nose"


@EVERY_FACE
def test_the_openings_are_marked_on_their_rims(shipped: Shipped, key: str) -> None:
    face = shipped(key)
    at = {name: face.skin.positions[vertex] for name, vertex in face.landmarks.items()}
    mouth = next(loop for loop in face.skin.boundary_loops if face.landmarks["upper_lip_mid"] in loop)
    assert {face.landmarks[name] for name in ("lower_lip_mid", "mouth_corner_L", "mouth_corner_R")} <= set(mouth)
    lips = face.skin.positions[mouth]
    assert at["mouth_corner_L"][0] > lips[:, 0].max() - 1.5
    for side in "LR":
        names = [f"{name}_{side}" for name in ("eye_inner", "eye_outer", "upper_lid_mid", "lower_lid_mid")]
        rim = next(loop for loop in face.skin.boundary_loops if face.landmarks[names[0]] in loop)
        assert {face.landmarks[name] for name in names} <= set(rim)
        assert at[f"upper_lid_mid_{side}"][1] > at[f"lower_lid_mid_{side}"][1] + 4
        assert abs(at[f"eye_outer_{side}"][0]) > abs(at[f"eye_inner_{side}"][0]) + 18


@EVERY_FACE
def test_pairs_mirror_each_other_and_follow_the_skull_outwards(shipped: Shipped, key: str) -> None:
    face = shipped(key)
    at = {name: face.skin.positions[vertex] for name, vertex in face.landmarks.items()}
    for name in PAIRED:
        assert face.mirror[face.landmarks[f"{name}_L"]] == face.landmarks[f"{name}_R"]
        assert at[f"{name}_L"][0] > 2
    out = ("brow_inner", "brow_mid", "brow_outer"), ("ala", "cheek", "zygion"), ("cupid_bow", "mouth_corner", "gonion")
    for row in out:
        assert (np.diff([at[f"{name}_L"][0] for name in row]) > 5).all()
    height = ("brow_mid", "upper_lid_mid", "lower_lid_mid", "suborbital", "inferior_malar", "mouth_corner", "gonion")
    assert (np.diff([at[f"{name}_L"][1] for name in height[:-1]]) < -2).all()
    assert at["gonion_L"][2] < at["lower_second_molar_L"][2] - 15
    assert at["tragus_L"][2] < at["zygion_L"][2] - 8

"""Places on a face: nearest points, what they lie on, inside and outside, and the other side."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from facemodel.face import Face
from facemodel.laying.places import (
    kind_of_place,
    middle_plane,
    mirrored_place,
    mirrored_vector,
    nearest,
    on_bone,
    on_skin,
    outside_head,
)
from facemodel.mesh import Mesh
from fem.types import FloatArray
from tests.facemodel.skin import by, domed_skin, flat_skin, sizes

seeds = st.integers(0, 10**6)


def near_head(seed: int, count: int = 1) -> FloatArray:
    return np.random.default_rng(seed).uniform([-80, -110, -40], [80, 110, 90], (count, 3))


def test_the_nearest_point_of_a_plane_is_the_foot_of_the_perpendicular() -> None:
    places, triangles, distances = nearest(flat_skin(), np.array([[3.3, -4.7, 6.0], [40.0, 0.0, 8.0]]))
    assert places == pytest.approx(np.array([[3.3, -4.7, 0], [30.0, 0, 0]]))
    assert distances == pytest.approx([6, np.hypot(10, 8)])
    assert triangles.shape == (2,)


def test_two_meshes_keep_their_own_trees() -> None:
    first, second = flat_skin(), domed_skin()
    point = np.array([20.0, 0, 0])
    assert nearest(first, point)[2][0] == pytest.approx(0.0)
    assert nearest(second, point)[2][0] > 1.0
    assert nearest(first, point)[2][0] == pytest.approx(0.0)


@settings(max_examples=30)
@given(seeds)
def test_snapping_goes_to_what_is_nearest_and_again_to_the_same(face: Face, seed: int) -> None:
    point = near_head(seed)[0]
    vertex, slid, free = (on_skin(face, point, snap) for snap in ("vertex", "surface", "free"))
    assert np.array_equal(free, point)
    assert np.linalg.norm(vertex - point) == pytest.approx(sizes(face.skin.positions - point).min())
    assert np.linalg.norm(slid - point) <= np.linalg.norm(vertex - point) + 1e-9
    assert np.array_equal(on_skin(face, vertex, "vertex"), vertex)
    assert on_skin(face, slid, "surface") == pytest.approx(slid, abs=1e-9)


@settings(max_examples=30)
@given(seeds)
def test_a_point_on_the_bone_lies_on_the_nearer_bone(face: Face, seed: int) -> None:
    point = near_head(seed)[0]
    found = on_bone(face, point)
    away = [nearest(mesh, point)[2][0] for mesh in (face.skull.cranium, face.skull.mandible)]
    assert np.linalg.norm(found - point) == pytest.approx(min(away))
    assert np.array_equal(on_bone(face, point, "free"), point)
    jaw = on_bone(face, point, "vertex", "mandible")
    assert sizes(face.skull.mandible.positions - jaw).min() == 0.0


def test_places_are_known_by_what_they_lie_on(face: Face) -> None:
    chin = face.landmarks["chin"]
    corners = face.skin.positions[face.skin.triangles[100]]
    assert kind_of_place(face, face.skin.positions[chin]) == ("vertex", chin)
    kind, foot = kind_of_place(face, face.skull.anchors[chin])
    assert kind == "foot"
    assert face.skull.anchors[foot] == pytest.approx(face.skull.anchors[chin], abs=1e-3)
    assert kind_of_place(face, corners.mean(axis=0)) == ("skin", -1)
    bone = face.skull.cranium
    assert kind_of_place(face, bone.positions[bone.triangles[7]].mean(axis=0))[0] == "bone"
    assert kind_of_place(face, face.skin.positions[chin] + by(0, 0, 30.0)) == ("free", -1)


def test_bone_and_brain_are_inside_the_head_and_the_air_is_not(face: Face) -> None:
    tip = face.skin.positions[face.landmarks["nose_tip"]]
    eyes = np.array([eye.centre for eye in face.eyes])
    assert not outside_head(face, np.concatenate([face.skull.cranium.positions[::50], eyes])).any()
    assert not outside_head(face, face.skin.positions[::25]).any(), "the skin itself belongs to the head"
    assert outside_head(face, np.array([tip + by(0, 0, 5.0), tip + by(0, 40.0, 40.0), [0, 0, 300.0]])).all()


@settings(max_examples=60)
@given(seeds, st.sampled_from(["vertex", "foot", "free"]))
def test_mirrored_twice_is_where_it_was(face: Face, seed: int, kind: str) -> None:
    vertex = seed % len(face.skin.positions)
    places = {
        "vertex": face.skin.positions[vertex],
        "foot": face.skull.anchors[vertex],
        "free": near_head(seed)[0],
    }
    there = mirrored_place(face, places[kind])
    assert mirrored_place(face, there) == pytest.approx(places[kind], abs=1e-3 if kind == "foot" else 1e-12)


def test_a_vertex_goes_to_its_mirrored_vertex_even_on_a_crooked_face(face: Face) -> None:
    rng = np.random.default_rng(7)
    crooked = face.skin.moved(face.skin.positions + rng.normal(0, 0.3, face.skin.positions.shape))
    bent = replace(face, skin=crooked)
    vertex = face.landmarks["mouth_corner_L"]
    assert np.array_equal(mirrored_place(bent, crooked.positions[vertex]), crooked.positions[face.mirror[vertex]])


def test_the_middle_plane_follows_the_head(face: Face) -> None:
    middle, across = middle_plane(face)
    assert np.array_equal(middle, np.zeros(3))
    assert np.array_equal(across, [1.0, 0.0, 0.0])
    turn = np.array([[0.8, 0, 0.6], [0, 1, 0], [-0.6, 0, 0.8]])
    moved = Mesh(face.skin.positions @ turn.T + [5.0, 1, 2], face.skin.triangles)
    middle, across = middle_plane(replace(face, skin=moved))
    assert across == pytest.approx(turn @ [1.0, 0, 0], abs=1e-9)
    assert middle @ across == pytest.approx(np.array([5.0, 1, 2]) @ across, abs=1e-9)
    assert mirrored_vector(face, np.array([1.0, 2, 3])) == pytest.approx([-1, 2, 3])

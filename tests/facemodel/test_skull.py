"""The template skull lies at the tables' depth, is fit to be cut and measured, and its jaw can open."""

from collections.abc import Callable, Sequence

import igl
import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from numpy.typing import NDArray

from facemodel.face import Face, Skull
from facemodel.faces import face_keys
from facemodel.making.skull import arches_of, fields, make_skull
from facemodel.making.skull.depth import BoneEnvelope
from facemodel.making.skull.envelope import closed
from facemodel.making.skull.share import jaw_share, lips
from facemodel.making.skull.surface import Grid
from facemodel.mesh import Mesh
from facemodel.skull.tissue_depths import table

EVERY_FACE = pytest.mark.parametrize("key", face_keys())
Shipped = Callable[[str], Face]
Floats = NDArray[np.float64]

WINDING = igl.SignedDistanceType.SIGNED_DISTANCE_TYPE_FAST_WINDING_NUMBER

MADE_UP_OF_TEETH = {"upper_lip_incisor", "lower_lip_incisor", "upper_second_molar", "lower_second_molar"}
"""Landmarks over the tooth rows, where the nearest bone is whatever crown or cheek bone stands out most."""

ABOUT_ROOTS = {"mid_philtrum", "chin_lip_fold"}
"""Landmarks over the roots of the incisors, whose bone follows the teeth of the face."""

RAISED = 0.7
"""Millimetres that it may lie higher: what is drawn to the teeth a little, as the chin is."""

FOLLOWED = 3.0
"""Millimetres that it may lie higher or deeper than the table for that."""

ROUNDED = 2.0
"""Millimetres that the modelled bone may lie deeper than the table: its thin edges (the tip of the nasal bones, the
angle of the jaw) are rounded off by the grid it is sampled on."""


def depth_in(mesh: Mesh, points: Floats) -> tuple[Floats, NDArray[np.int64]]:
    """Return the signed distance to a closed mesh, negative inside, and the nearest triangles."""
    distance, nearest, *_ = igl.signed_distance(points, mesh.positions, mesh.triangles, WINDING)
    return distance, nearest


def opened(skull: Skull, degrees: float) -> Floats:
    """Return the mandible turned about the hinge."""
    right, left = skull.jaw.axis
    axis = (left - right) / np.linalg.norm(left - right)
    arm, angle = skull.mandible.positions - right, np.radians(degrees)
    turned = arm * np.cos(angle) + np.cross(axis, arm) * np.sin(angle)
    return right + turned + np.outer(arm @ axis, axis) * (1 - np.cos(angle))


@pytest.fixture(scope="module")
def skull(shipped: Shipped) -> Skull:
    face = shipped("ada")
    return make_skull(face.skin, face.landmarks, face.eyes, arches_of(face.parts))


@EVERY_FACE
def test_springs_reach_bone_at_the_depth_of_the_tables(shipped: Shipped, key: str) -> None:
    face = shipped(key)
    bone = BoneEnvelope(face.skin, face.landmarks, face.eyes)
    down = bone.anchors - face.skin.positions
    for name, depth in table().items():
        assert np.linalg.norm(down[face.landmarks[name]]) == pytest.approx(depth, abs=0.5), name
        assert down[face.landmarks[name]] @ bone.outer.normals[face.landmarks[name]] < -0.6 * depth, name
    length = np.linalg.norm(down, axis=1)
    assert length.min() > 0.2
    assert length.max() < 27


@EVERY_FACE
def test_springs_of_neighbours_agree_and_both_sides_are_alike(shipped: Shipped, key: str) -> None:
    face = shipped(key)
    anchors = BoneEnvelope(face.skin, face.landmarks, face.eyes).anchors
    down = anchors - face.skin.positions
    down /= np.linalg.norm(down, axis=1, keepdims=True)
    i, j = face.skin.edges.T
    turn = np.degrees(np.arccos(np.clip((down[i] * down[j]).sum(axis=1), -1, 1)))
    assert np.quantile(turn, 0.99) < 25
    chin, ear = (face.skin.positions[face.landmarks[name]] for name in ("pogonion", "tragus_L"))
    before_the_ears = (face.skin.positions > [-np.inf, chin[1], ear[2]]).all(axis=1)
    assert np.abs(anchors[face.mirror] * [-1, 1, 1] - anchors)[before_the_ears].max() < 0.2


@EVERY_FACE
def test_the_mandible_carries_chin_and_lower_lip_and_nothing_of_the_midface(shipped: Shipped, key: str) -> None:
    face = shipped(key)
    share = jaw_share(face.skin, face.landmarks)
    assert share.min() >= 0
    assert share.max() <= 1
    for name in ("pogonion", "menton", "gonion_L", "lower_lip_mid", "chin"):
        assert share[face.landmarks[name]] == pytest.approx(1, abs=0.02), name
    for name in ("subnasale", "nose_tip", "upper_lip_mid", "cheek_L", "lateral_orbit_R", "glabella"):
        assert share[face.landmarks[name]] == pytest.approx(0, abs=0.02), name
    assert 0.2 < share[face.landmarks["mouth_corner_L"]] < 0.8
    assert share[face.skin.boundary_loops[-1]].max() == 0, "the neck's rim stays"


@EVERY_FACE
def test_the_share_of_the_mandible_jumps_only_at_the_slit_of_the_mouth(shipped: Shipped, key: str) -> None:
    face = shipped(key)
    share = jaw_share(face.skin, face.landmarks)
    i, j = face.skin.edges.T
    steep = np.abs(share[i] - share[j]) / np.linalg.norm(face.skin.positions[i] - face.skin.positions[j], axis=1)
    corners = face.skin.positions[[face.landmarks["mouth_corner_L"], face.landmarks["mouth_corner_R"]]]
    away = np.linalg.norm(face.skin.positions[i][:, None] - corners, axis=2).min(axis=1)
    assert steep[away > 15].max() < 0.15, "per millimetre"
    upper, lower = lips(face.skin, face.landmarks)
    middle = np.abs(face.skin.positions[:, 0]) < 10
    assert share[upper[middle[upper]]].max() == 0
    assert share[lower[middle[lower]]].min() == 1


def test_bone_lies_at_the_tables_depth_where_the_tables_speak_of_bone(shipped: Shipped, skull: Skull) -> None:
    face = shipped("ada")
    bones = Mesh(
        np.concatenate([skull.cranium.positions, skull.mandible.positions]),
        np.concatenate([skull.cranium.triangles, skull.mandible.triangles + len(skull.cranium.positions)]),
    )
    for name, depth in table().items():
        if name.removesuffix("_L").removesuffix("_R") in MADE_UP_OF_TEETH:
            continue
        distance = abs(depth_in(bones, face.skin.positions[[face.landmarks[name]]])[0][0])
        if name in ABOUT_ROOTS:
            assert abs(distance - depth) < FOLLOWED, name
        else:
            assert depth - RAISED < distance < depth + ROUNDED, name


@pytest.mark.parametrize("name", ["cranium", "mandible"])
def test_the_bones_are_closed_manifold_and_the_same_on_both_sides(skull: Skull, name: str) -> None:
    bone: Mesh = getattr(skull, name)
    directed = np.concatenate([bone.triangles[:, [k, (k + 1) % 3]] for k in range(3)])
    assert len(np.unique(directed, axis=0)) == len(directed), "an edge is used twice in one direction"
    assert {tuple(edge) for edge in directed} == {tuple(edge[::-1]) for edge in directed}, "an edge is open"
    assert igl.is_vertex_manifold(bone.triangles).all()
    assert (bone.positions[bone.triangles[:, 0]] * bone.triangle_normals).sum() > 0, "it is turned inside out"
    square, *_ = igl.point_mesh_squared_distance(bone.positions * [-1, 1, 1], bone.positions, bone.triangles)
    assert np.sqrt(square.max()) < 1.0, "it is not symmetric, though the face is"


def test_skin_covers_the_bones_but_for_the_slits_of_lips_and_lids(shipped: Shipped, skull: Skull) -> None:
    face = shipped("ada")
    for bone in (skull.cranium, skull.mandible):
        height, nearest = depth_in(closed(face.skin), bone.positions)
        assert (height[nearest < len(face.skin.triangles)] < -1).all()


def test_the_condyles_sit_in_their_sockets(shipped: Shipped, skull: Skull) -> None:
    face = shipped("ada")
    at = {name: face.skin.positions[vertex] for name, vertex in face.landmarks.items()}
    for condyle, side in zip(skull.jaw.axis, "RL", strict=True):
        assert 10 < condyle[2] - at[f"tragus_{side}"][2] < 16, "before the ear"
        assert depth_in(skull.mandible, condyle[None])[0] < -2
        assert 3 < depth_in(skull.cranium, condyle[None])[0] < 9
        up = condyle + np.array([[0.0, 15.0, 0.0]])
        assert depth_in(skull.cranium, up)[0] < 0, "bone roofs the joint"
    right, left = skull.jaw.axis
    assert left == pytest.approx(right * [-1, 1, 1], abs=0.1)
    assert 85 < np.linalg.norm(left - right) < 112


@pytest.mark.parametrize("degrees", [0, 12, 25])
def test_the_jaw_opens_without_passing_through_the_cranium(skull: Skull, degrees: float) -> None:
    within = depth_in(skull.cranium, opened(skull, degrees))[0]
    assert (within < -1).mean() < 0.01
    assert within.min() > -4


def test_an_open_jaw_parts_the_incisors_as_far_as_a_mouth_opens(skull: Skull) -> None:
    incisors = np.linalg.norm(skull.mandible.positions - skull.jaw.teeth, axis=1) < 9
    moved = np.linalg.norm(opened(skull, 28)[incisors] - skull.mandible.positions[incisors], axis=1)
    assert 32 < moved.mean() < 60
    drop = (opened(skull, 28) - skull.mandible.positions)[incisors]
    assert (drop[:, 1] < -20).all(), "a positive turn about the axis from the right condyle to the left opens"


def test_every_depth_is_that_of_a_landmark(shipped: Shipped) -> None:
    assert set(table()) <= set(shipped("ada").landmarks)


square = st.floats(-3, 3)


@given(a=square, b=square, width=st.floats(0.1, 4))
def test_blends_stay_next_to_the_sharp_ones(a: float, b: float, width: float) -> None:
    one, other = np.array([a]), np.array([b])
    both = fields.smooth_max(one, other, width)[0]
    assert max(a, b) <= both <= max(a, b) + width / 4 + 1e-12
    assert fields.smooth_min(one, other, width)[0] == pytest.approx(-fields.smooth_max(-one, -other, width)[0])
    assert fields.carved(one, other, width)[0] == pytest.approx(fields.smooth_max(one, -other, width)[0])


def test_shapes_measure_true_distances() -> None:
    generator = np.random.default_rng(0)
    p = generator.uniform(-6, 6, (500, 3))
    ball = np.linalg.norm(p - [1, 2, -1], axis=1) - 2.5
    assert fields.ellipsoid(p, (1, 2, -1), (2.5, 2.5, 2.5)) == pytest.approx(ball)
    assert fields.rod(p, [(1, 2, -1), (1, 2, -0.999999)], [2.5, 2.5]) == pytest.approx(ball, abs=1e-5)
    u, v = p[:, 0], p[:, 1]
    box = np.abs(np.stack([u, v])) - [[2.0], [1.0]]
    exact = np.linalg.norm(np.maximum(box, 0), axis=0) + np.minimum(box.max(axis=0), 0)
    corners: Sequence[Sequence[float]] = [(-2, -1), (2, -1), (2, 1), (-2, 1)]
    assert fields.outline(u, v, corners) == pytest.approx(exact)
    assert fields.outline(u, v, corners[::-1]) == pytest.approx(exact)


def test_knots_are_met_and_never_overshot() -> None:
    knots = [(0.0, 1.0), (1.0, 1.0), (2.0, 5.0), (4.0, 4.0)]
    x = np.linspace(-1, 5, 301)
    y = fields.along(x, knots)
    assert y.min() == pytest.approx(1)
    assert y.max() == pytest.approx(5)
    assert fields.along(np.array([0.0, 2.0, 9.0]), knots) == pytest.approx([1, 5, 4])


def test_a_refined_grid_carries_smooth_values_over() -> None:
    coarse = Grid.over((-15, -12, -10), (15, 12, 15), 1.5)
    p, q = coarse.points(), coarse.halved().points()
    assert p.min(axis=0) == pytest.approx(q.min(axis=0))
    assert p.max(axis=0) == pytest.approx(q.max(axis=0))
    assert sorted({round(x, 9) for x in p[:, 0]}) == sorted({-round(x, 9) for x in p[:, 0]}), "both sides alike"
    ball = np.linalg.norm(p - [40, 0, 0], axis=1)
    inner = ((q > q.min(axis=0) + 5) & (q < q.max(axis=0) - 5)).all(axis=1)
    assert coarse.refined(ball)[inner] == pytest.approx(np.linalg.norm(q - [40, 0, 0], axis=1)[inner], abs=0.01)

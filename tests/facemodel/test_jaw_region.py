"""The jaw is the vertices that a hand chose on the skull, and the skin over them follows it."""

from dataclasses import replace

import igl
import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from facemodel.errors import SkullError
from facemodel.face import Face
from facemodel.faces import load_face
from facemodel.mesh import Mesh
from facemodel.skull.jaw_region import mirrored, part_around, whole_skull, with_jaw
from fem.types import BoolArray, FloatArray

FACE = load_face("ada")
BONE = whole_skull(FACE.skull).mesh
LOW, HIGH = -60.0, -25.0


def height(limit: float) -> BoolArray:
    """Return the vertices of the mandible below a height."""
    whole = whole_skull(FACE.skull)
    return whole.jaw & (whole.mesh.positions[:, 1] < limit)


def triangle_centres(mesh: Mesh) -> FloatArray:
    """Return the middles (T, 3) of all triangles, sorted, which tells surfaces apart however they are numbered."""
    middles = mesh.positions[mesh.triangles].mean(axis=1).round(6)
    return np.asarray(middles[np.lexsort(middles.T)])


def on(face: Face, vertices: BoolArray) -> BoolArray:
    """Return vertices of the shipped skull as they are numbered on another cut of it."""
    other = whole_skull(face.skull).mesh
    away, found = BONE.tree.query(other.positions)
    assert away.max() == 0.0
    return np.asarray(vertices[found])


def test_the_jaw_of_a_shipped_face_is_its_mandible() -> None:
    whole = whole_skull(FACE.skull)
    assert len(whole.mesh.positions) == len(FACE.skull.cranium.positions) + len(FACE.skull.mandible.positions)
    assert whole.jaw.sum() == len(FACE.skull.mandible.positions)
    assert not whole.shared.any()
    assert with_jaw(FACE, whole.jaw) is FACE


@settings(max_examples=15)
@given(st.floats(LOW, HIGH))
def test_every_triangle_of_the_bone_is_in_one_of_both_and_none_is_lost(limit: float) -> None:
    cut = with_jaw(FACE, height(limit)).skull
    assert len(cut.cranium.triangles) + len(cut.mandible.triangles) == len(BONE.triangles)
    together = np.concatenate([triangle_centres(cut.cranium), triangle_centres(cut.mandible)])
    assert np.array_equal(together[np.lexsort(together.T)], triangle_centres(BONE))
    assert cut.mandible.positions[:, 1].max() < limit


@settings(max_examples=15)
@given(st.floats(LOW, HIGH), st.floats(LOW, HIGH))
def test_a_jaw_depends_on_what_was_chosen_last_alone(first: float, second: float) -> None:
    once = with_jaw(FACE, height(second))
    between = with_jaw(FACE, height(first))
    twice = with_jaw(between, on(between, height(second)))
    for bone in ("cranium", "mandible"):
        assert np.array_equal(triangle_centres(getattr(once.skull, bone)), triangle_centres(getattr(twice.skull, bone)))
    whole = whole_skull(twice.skull)
    assert len(whole.mesh.positions) == len(BONE.positions)
    assert with_jaw(twice, whole.jaw) is twice


@settings(max_examples=15)
@given(st.floats(LOW, HIGH), st.floats(LOW, HIGH))
def test_more_bone_in_the_jaw_never_lets_go_of_skin(one: float, other: float) -> None:
    small = with_jaw(FACE, height(min(one, other)))
    large = with_jaw(small, on(small, height(max(one, other))))
    assert np.all(large.skull.jawbone >= small.skull.jawbone)
    assert large.skull.jawbone.max() <= 1.0
    assert small.skull.jawbone.min() >= 0.0
    assert large.skull.anchors is FACE.skull.anchors


def test_skin_far_from_what_changed_hands_keeps_its_share_to_the_last_bit() -> None:
    chin_gone = with_jaw(FACE, whole_skull(FACE.skull).jaw & ~height(-55))
    moved = chin_gone.skull.jawbone != FACE.skull.jawbone
    assert moved[FACE.landmarks["menton"]]
    assert chin_gone.skull.jawbone[FACE.landmarks["menton"]] < 0.3
    assert not moved[FACE.landmarks["glabella"]]
    assert FACE.skin.positions[moved, 1].max() < 0.0


def test_a_jaw_of_nothing_and_one_of_everything_are_refused() -> None:
    with pytest.raises(SkullError, match="No bone would be jaw"):
        with_jaw(FACE, np.zeros(len(BONE.positions), dtype=np.bool_))
    alone = np.zeros(len(BONE.positions), dtype=np.bool_)
    alone[BONE.triangles[0, :2]] = True
    with pytest.raises(SkullError, match="at least one triangle"):
        with_jaw(FACE, alone)
    with pytest.raises(SkullError, match="nothing would hold the face"):
        with_jaw(FACE, np.ones(len(BONE.positions), dtype=np.bool_))


def test_a_bone_that_came_in_one_piece_gets_a_jaw() -> None:
    skull = FACE.skull
    empty = Mesh(np.zeros((0, 3)), np.zeros((0, 3), dtype=np.int64))
    single = replace(FACE, skull=replace(skull, cranium=BONE, mandible=empty, jawbone=0 * skull.jawbone))
    whole = whole_skull(single.skull)
    assert not whole.jaw.any()
    jawed = with_jaw(single, on(single, whole_skull(skull).jaw))
    assert np.array_equal(triangle_centres(jawed.skull.mandible), triangle_centres(skull.mandible))
    assert jawed.skull.jawbone[FACE.landmarks["menton"]] == 1.0
    assert jawed.skull.jawbone[FACE.landmarks["glabella"]] == 0.0


@settings(max_examples=10)
@given(st.integers(0, len(BONE.positions) - 1))
def test_the_part_around_a_vertex_is_a_component_and_its_lower_part_lies_below(seed: int) -> None:
    components = igl.vertex_components(BONE.triangles)
    whole = part_around(BONE, seed)
    assert np.array_equal(whole, components == components[seed])
    lower = part_around(BONE, seed, lower=True)
    assert lower[seed]
    assert not (lower & ~whole).any()
    assert BONE.positions[lower, 1].max() <= BONE.positions[seed, 1]


@settings(max_examples=15)
@given(st.lists(st.integers(0, len(BONE.positions) - 1), min_size=1, max_size=30))
def test_a_region_with_its_image_loses_nothing_and_reaches_the_other_side(chosen: list[int]) -> None:
    region = np.zeros(len(BONE.positions), dtype=np.bool_)
    region[chosen] = True
    both = mirrored(whole_skull(FACE.skull), FACE, region)
    assert both[region].all()
    away = np.abs(BONE.positions[both][:, None] * [-1, 1, 1] - BONE.positions[chosen]).max(axis=2).min(axis=1)
    own = np.abs(BONE.positions[both][:, None] - BONE.positions[chosen]).max(axis=2).min(axis=1)
    assert np.minimum(away, own).max() < 4.5

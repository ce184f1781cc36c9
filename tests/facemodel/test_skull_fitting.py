"""A skull from elsewhere, in any unit and with any names of its axes, is laid into a head and fitted by landmarks."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from facemodel.errors import SkullError
from facemodel.faces import load_face
from facemodel.mesh import Mesh
from facemodel.skull.depths import bone_depths, whole
from facemodel.skull.fitting import KINDS, SkullFit, bone_targets, fitted
from facemodel.skull.placement import carried
from facemodel.skull.registration import laid_on, proposed, quarter_turns
from facemodel.skull.tissue_depths import table
from fem.types import FloatArray

FACE = load_face("ada")
BONE = whole(FACE.skull)
TARGETS = bone_targets(FACE)
SOME = ("nasion", "pogonion", "zygion_L", "zygion_R", "gonion_L", "gonion_R")

EXACT = 1e-4
"""Millimetres; least squares end somewhere near to the best."""

angle = st.floats(-60, 60)
factor = st.floats(0.7, 1.4)


def places(names: tuple[str, ...] = SOME) -> dict[str, FloatArray]:
    return {name: TARGETS[name] for name in names}


def backwards(way: FloatArray, wanted: dict[str, FloatArray]) -> dict[str, FloatArray]:
    """Return where landmarks were on a skull that a map takes to where they should be."""
    back = np.linalg.inv(way)
    return {name: carried(place[None], back)[0] for name, place in wanted.items()}


def affine(turn: FloatArray, scale: tuple[float, ...], shift: tuple[float, ...] = (3.0, -5.0, 80.0)) -> FloatArray:
    way = np.eye(4)
    way[:3, :3] = turn * np.array(scale)
    way[:3, 3] = shift
    return way


def test_targets_lie_as_deep_as_the_tables_say_and_near_to_the_bone() -> None:
    for name, depth in table().items():
        skin = FACE.skin.positions[FACE.landmarks[name]]
        assert np.linalg.norm(TARGETS[name] - skin) == pytest.approx(depth)
    assert bone_depths(FACE).count == 0


@settings(max_examples=25)
@given(angle, angle, angle, factor)
def test_a_skull_of_another_unit_is_fitted_exactly(x: float, y: float, z: float, size: float) -> None:
    way = affine(Rotation.from_euler("xyz", (x, y, z), degrees=True).as_matrix(), (10 * size,) * 3)
    fit = fitted(backwards(way, places()), places(), "alike")
    assert max(fit.residuals.values()) < EXACT
    assert np.allclose(fit.way, way, atol=EXACT)


@settings(max_examples=25)
@given(angle, angle, angle, factor, factor, factor)
def test_one_of_other_proportions_too_if_its_axes_are_scaled_apart(x, y, z, a, b, c) -> None:
    way = affine(Rotation.from_euler("xyz", (x, y, z), degrees=True).as_matrix(), (a, b, c))
    picked = backwards(way, places())
    fit = fitted(picked, places(), "axes")
    # Evenness of the scales is wanted a little, too.
    assert fit.rms < 0.25
    assert np.allclose(fit.scale, [a, b, c], rtol=0.03)
    alike = fitted(picked, places(), "alike")
    assert fit.rms <= alike.rms + EXACT
    assert fitted(picked, places(), "bent").rms < EXACT


@given(st.lists(st.sampled_from(sorted(TARGETS)), min_size=6, max_size=20, unique=True), st.integers(0, 2**31))
@settings(max_examples=15)
def test_residuals_are_how_far_the_landmarks_are_from_where_they_should_be(names: list[str], seed: int) -> None:
    wanted = places(tuple(names))
    noise = np.random.default_rng(seed).normal(0, 3, (len(names), 3))
    picked = {name: place + off for (name, place), off in zip(wanted.items(), noise, strict=True)}
    fits: dict[str, SkullFit] = {kind: fitted(picked, wanted, kind) for kind in KINDS}
    for fit in fits.values():
        for name, left in fit.residuals.items():
            assert np.linalg.norm(fit(picked[name][None])[0] - wanted[name]) == pytest.approx(left, abs=1e-6)
    assert fits["axes"].rms <= fits["alike"].rms + EXACT
    assert fits["bent"].rms < EXACT


def test_too_few_places_and_places_on_a_line_are_refused_in_a_sentence() -> None:
    with pytest.raises(SkullError, match="2 landmarks are picked on the skull and at least 4 are needed"):
        fitted(places(SOME[:2]), places())
    line = {name: np.array([0.0, k, 0.0]) for k, name in enumerate(SOME)}
    with pytest.raises(SkullError, match="The landmarks on the skull lie on a line"):
        fitted(line, places())


@pytest.mark.parametrize("number", [0, 5, 11, 18, 23])
def test_a_skull_is_laid_into_the_head_however_its_axes_are_named(number: int) -> None:
    turn = quarter_turns()[number]
    other = Mesh(BONE.positions @ turn.T * 0.07 + [4.0, 900.0, -3.0], BONE.triangles)
    back = carried(other.positions, laid_on(other, FACE.skull))
    assert np.linalg.norm(back - BONE.positions, axis=1).max() < 1.0


def test_quarter_turns_are_all_the_ways_to_name_three_axes() -> None:
    turns = quarter_turns()
    assert len({turn.tobytes() for turn in turns + 0.0}) == 24
    assert np.array_equal(turns[0], np.eye(3))
    assert np.allclose([np.linalg.det(turn) for turn in turns], 1)


def test_proposed_landmarks_of_the_own_skull_are_where_they_should_be() -> None:
    found = proposed(BONE, np.eye(4), TARGETS)
    away = {name: np.linalg.norm(found[name] - TARGETS[name]) for name in found}
    assert np.median(list(away.values())) < 2.0
    assert fitted(found, TARGETS).rms < 3.0

"""The table of layers: everything of a face's tissue is in it, with units, ranges and exact ways in and out."""

import dataclasses
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from facemodel.anatomy.files import shipped_anatomy
from facemodel.face import Face, Layers
from facemodel.faces import face_keys
from facemodel.painting.frames import tangent_frames
from facemodel.painting.geodesic import SurfacePoint
from facemodel.painting.layers import LAYER, PAINT_LAYERS, SUPPORT_TITLES, PaintLayer
from fem import Support
from fem.types import FloatArray
from tests.facemodel.skin import domed_skin, face_on

DOME = domed_skin(segments=10)
COUNT = len(DOME.positions)
ANGLE = st.floats(-90.0, 90.0, exclude_max=True)


def layers_of(count: int) -> Layers:
    rng = np.random.default_rng(8)
    return Layers(
        direction=rng.normal(size=(count, 3)),
        stretching=rng.uniform(0.05, 1.0, (count, 2)),
        bending=rng.uniform(0.1, 2.0, (count, 3)),
        stiffness=rng.uniform(0.001, 0.02, count),
        thickness=rng.uniform(2.0, 20.0, count),
        sliding=rng.uniform(5.0, 50.0, count),
        volume=rng.uniform(0.0, 0.3, count),
        supports=rng.integers(0, len(Support), count),
    )


LAYERS = layers_of(COUNT)
FACE = face_on(DOME, LAYERS)


def test_every_painted_number_of_a_face_is_a_layer() -> None:
    columns = {"direction": 1, "stretching": 2, "bending": 3, "stiffness": 1, "thickness": 1}
    columns |= {"sliding": 1, "volume": 1, "supports": 1}
    assert set(columns) == {field.name for field in dataclasses.fields(Layers)}
    for member, count in columns.items():
        of_member = [layer for layer in PAINT_LAYERS if layer.member == member]
        assert len(of_member) == count
        assert len({layer.column for layer in of_member}) == count
    assert set(SUPPORT_TITLES) == set(Support)


@pytest.mark.parametrize("key", face_keys())
def test_the_shipped_faces_are_within_the_ranges(key: str, shipped: object) -> None:
    face: Face = shipped(key)  # type: ignore[operator]
    for layer in PAINT_LAYERS:
        values = layer.values(face)
        assert layer.low <= values.min()
        assert values.max() <= layer.high
        assert layer.low <= layer.default <= layer.high
        assert layer.reason


def test_the_defaults_are_those_that_faces_are_made_with() -> None:
    made = shipped_anatomy().tissue
    assert LAYER["stiffness"].default == made.stiffness
    assert LAYER["sliding"].default == made.sliding
    assert {LAYER[f"stretching-{way}"].default for way in ("along", "across")} == {made.stretching}
    assert {LAYER[f"bending-{way}"].default for way in ("along", "across", "twist")} == {made.bending}


@pytest.mark.parametrize("layer", PAINT_LAYERS, ids=lambda layer: layer.key)
def test_what_is_put_in_comes_out(layer: PaintLayer) -> None:
    rng = np.random.default_rng(1)
    vertices = rng.permutation(COUNT)[:40]
    wanted = rng.uniform(layer.low, layer.high, 40)
    wanted = np.rint(wanted) if layer.kind == "choice" else wanted
    done = layer.delta(FACE, vertices, wanted).done(LAYERS)
    found = layer.values(replace(FACE, layers=done))
    assert found[vertices] == pytest.approx(wanted, abs=1e-9)
    others = np.setdiff1d(np.arange(COUNT), vertices)
    assert np.array_equal(found[others], layer.values(FACE)[others])
    for other in PAINT_LAYERS:
        if other is not layer:
            assert np.array_equal(other.values(replace(FACE, layers=done)), other.values(FACE))


@settings(max_examples=30)
@given(ANGLE)
def test_the_grain_lies_in_the_skin_at_its_angle_to_the_horizontal(angle: float) -> None:
    vertices = np.arange(COUNT)
    done = LAYER["grain"].delta(FACE, vertices, np.full(COUNT, angle)).done(LAYERS)
    frames = tangent_frames(DOME.normals)
    assert np.einsum("ij,ij->i", done.direction, DOME.normals) == pytest.approx(0.0, abs=1e-12)
    assert np.linalg.norm(done.direction, axis=1) == pytest.approx(1.0)
    assert np.einsum("ij,ij->i", done.direction, frames.level) == pytest.approx(np.cos(np.radians(angle)))
    assert frames.level[:, 1] == pytest.approx(0.0, abs=1e-12), "the horizontal is horizontal"
    assert np.all(frames.level[:, 0] > 0), "to the subject's left on the front"
    assert np.all(frames.rising[:, 1] > 0)


@given(ANGLE)
def test_a_line_turned_by_half_a_turn_is_the_same(angle: float) -> None:
    grain = LAYER["grain"]
    turned = grain.fitting(np.array([angle + 180.0, angle - 180.0, angle + 540.0]))
    assert ((turned - angle + 90.0) % 180.0 - 90.0) == pytest.approx(0.0, abs=1e-9)
    assert np.all((turned >= -90.0) & (turned < 90.0))


def test_a_grain_that_is_set_to_what_it_is_keeps_its_vectors() -> None:
    grain = LAYER["grain"]
    assert len(grain.delta(FACE, np.arange(COUNT), grain.values(FACE))) == 0


def test_on_the_crown_the_subjects_left_stands_in_for_the_horizontal() -> None:
    frames = tangent_frames(np.array([[0.0, 1.0, 0.0], [0.0, -1.0, 0.0]]))
    assert frames.level == pytest.approx(np.array([[1.0, 0, 0], [1.0, 0, 0]]))


SHARES = st.tuples(*[st.floats(0.01, 1.0)] * 3).map(np.array).map(lambda b: b / b.sum())


@given(st.integers(0, len(DOME.triangles) - 1), SHARES)
def test_what_is_picked_lies_between_the_corners(triangle: int, share: FloatArray) -> None:
    point = SurfacePoint(triangle, share)
    corners = DOME.triangles[triangle]
    for layer in PAINT_LAYERS:
        values = layer.values(FACE)[corners]
        picked = layer.picked(FACE, point)
        if layer.kind == "choice":
            assert picked == values[share.argmax()]
        elif layer.kind == "amount":
            assert picked == pytest.approx(values @ share)
        else:
            assert -90.0 <= picked < 90.0
    assert LAYER["stiffness"].picked(FACE, SurfacePoint(triangle, np.array([0.0, 1.0, 0.0]))) == pytest.approx(
        LAYERS.stiffness[corners[1]]
    )


def test_lines_at_89_and_minus_89_degrees_pick_as_90() -> None:
    grain = LAYER["grain"]
    values = np.full(COUNT, 89.0)
    values[DOME.triangles[0, 1]] = -89.0
    layers = grain.delta(FACE, np.arange(COUNT), values).done(LAYERS)
    picked = grain.picked(replace(FACE, layers=layers), SurfacePoint(0, np.array([0.5, 0.5, 0.0])))
    assert picked == pytest.approx(-90.0, abs=1e-6) or picked == pytest.approx(90.0, abs=1e-6)

"""Regions: lasso, flood, ball, grown, shrunk and filled."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from facemodel.errors import PaintError
from facemodel.face import Face
from facemodel.painting.brush import Brush
from facemodel.painting.layers import LAYER
from facemodel.painting.regions import ball, connected_part, filled, flood, grown, lasso, shrunk, unhidden
from facemodel.painting.surface import PaintSurface
from fem import Support
from fem.types import FloatArray
from tests.facemodel.skin import flat_skin

SHEET = flat_skin(segments=20)
COUNT = len(SHEET.positions)
EVERYWHERE = np.ones(COUNT, dtype=bool)


@given(st.lists(st.floats(0.1, 0.9), min_size=3, max_size=9), st.floats(0.0, 6.0), st.integers(0, 5))
def test_a_lasso_takes_the_vertices_that_it_goes_round(gaps: list[float], start: float, seed: int) -> None:
    """The winding number, summed from angles, is another way to the same answer."""
    angle = start + 2 * np.pi * np.cumsum(gaps) / np.sum(gaps)
    radius = np.random.default_rng(seed).uniform(5.0, 28.0, len(gaps))
    polygon = np.column_stack([radius * np.cos(angle), radius * np.sin(angle)])
    screen = SHEET.positions[:, :2] + [0.013, 0.017]
    found = lasso(polygon, screen, EVERYWHERE)
    assert np.array_equal(found, np.abs(winding(polygon, screen)) > 0.5)
    assert np.array_equal(lasso(polygon[::-1], screen, EVERYWHERE), found)


def winding(polygon: FloatArray, screen: FloatArray) -> FloatArray:
    to = polygon[None] - screen[:, None]
    angle = np.arctan2(to[..., 1], to[..., 0])
    turn = (np.roll(angle, -1, axis=1) - angle + np.pi) % (2 * np.pi) - np.pi
    return np.asarray(turn.sum(axis=1) / (2 * np.pi))


def test_a_lasso_takes_only_what_is_seen() -> None:
    polygon = np.array([[-50.0, -50.0], [50.0, -50.0], [50.0, 50.0], [-50.0, 50.0]])
    visible = np.arange(COUNT) % 3 == 0
    assert np.array_equal(lasso(polygon, SHEET.positions[:, :2], visible), visible)
    assert not lasso(polygon[:2], SHEET.positions[:, :2], visible).any()


def test_what_lies_behind_something_or_off_the_screen_is_hidden() -> None:
    drawn = np.full((10, 20), 100.0)
    drawn[:, 10:] = 50.0
    screen = np.array([[5.0, 5.0], [15.0, 5.0], [15.0, 5.0], [25.0, 5.0], [5.0, -1.0], [15.0, 5.0]])
    depth = np.array([99.0, 99.0, 49.0, 10.0, 10.0, 50.4])
    assert unhidden(screen, depth, drawn, slack=0.5).tolist() == [True, False, True, False, False, True]


def test_a_flood_stays_where_the_values_are_alike_and_connected() -> None:
    x = SHEET.positions[:, 0]
    values = np.where(np.abs(x) > 20, 1.0, 2.0) + 0.001 * SHEET.positions[:, 1]
    seed = int(np.flatnonzero(x < -20)[0])
    assert np.array_equal(flood(SHEET, values, seed, 0.5), x < -20), "the same value on the other side is not reached"
    assert np.array_equal(flood(SHEET, values, seed, 5.0), EVERYWHERE)
    assert flood(SHEET, values, seed, 0.0).sum() < (x < -20).sum()


def test_a_flood_of_angles_goes_round() -> None:
    angles = np.where(SHEET.positions[:, 0] < 0, 89.0, -89.0)
    assert flood(SHEET, angles, 0, 3.0, period=180.0).all()
    assert not flood(SHEET, angles, 0, 3.0).all()


def test_a_part_is_what_hangs_together(face: Face) -> None:
    assert connected_part(face.skin, 0).all()
    teeth = next(part.mesh for part in face.parts if part.name == "teeth-upper")
    one = connected_part(teeth, 0)
    assert 0 < one.sum() <= len(one)
    corners = one[teeth.triangles]
    assert np.array_equal(corners.all(axis=1), corners.any(axis=1))


@settings(max_examples=20)
@given(st.integers(0, COUNT - 1), st.integers(1, 4))
def test_growing_and_shrinking_undo_each_other_inside(seed: int, rings: int) -> None:
    region = np.zeros(COUNT, dtype=bool)
    region[seed] = True
    larger = grown(SHEET, region, rings)
    assert larger.sum() > region.sum()
    assert np.array_equal(grown(SHEET, grown(SHEET, region, rings - 1), 1), larger)
    assert not (region & ~shrunk(SHEET, larger, rings)).any(), "what has grown from it still holds it"
    assert np.array_equal(~shrunk(SHEET, ~region, rings), larger)


def test_a_ball_is_round_on_the_skin(face: Face) -> None:
    surface = PaintSurface(face.skin)
    cheek = face.skin.positions[face.landmarks["cheek_L"]]
    point = surface.path.nearest(cheek)[0]
    inside = ball(surface.geodesics, point, 15.0)
    straight = np.linalg.norm(face.skin.positions - cheek, axis=1)
    assert not inside[straight > 15.0].any()
    assert inside[straight < 8.0].all()


@pytest.mark.parametrize(
    ("mode", "value", "expected"),
    [("set", 0.01, 0.01), ("add", 0.001, 0.005), ("scale", 2.0, 0.008), ("add", 1.0, 0.1), ("smooth", 0.0, 0.004)],
)
def test_a_region_is_filled_and_nothing_else(face: Face, mode: str, value: float, expected: float) -> None:
    surface, layer = PaintSurface(face.skin), LAYER["stiffness"]
    even = layer.delta(face, np.arange(len(face.mirror)), np.full(len(face.mirror), 0.004))
    layers = even.done(face.layers)
    region = face.skin.positions[:, 1] > 60
    delta = filled(surface, replace(face, layers=layers), layer, Brush(5.0, 1.0, 0.0, mode, value), region)  # type: ignore[arg-type]
    done = delta.done(layers)
    assert done.stiffness[region] == pytest.approx(expected)
    assert np.array_equal(done.stiffness[~region], layers.stiffness[~region])
    assert delta.undone(done).stiffness.tobytes() == layers.stiffness.tobytes()


def test_supports_of_a_region_are_chosen_at_once(face: Face) -> None:
    region = face.skin.positions[:, 1] > 60
    brush = Brush(5.0, 0.3, 0.0, "set", Support.VALUE)
    done = filled(PaintSurface(face.skin), face, LAYER["supports"], brush, region).done(face.layers)
    assert np.all(done.supports[region] == Support.VALUE)


def test_a_region_cannot_be_combed(face: Face) -> None:
    with pytest.raises(PaintError, match="cannot be combed as a whole"):
        filled(PaintSurface(face.skin), face, LAYER["grain"], Brush(5.0, mode="comb"), face.mirror >= 0)

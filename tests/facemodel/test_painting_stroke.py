"""Strokes: continuous, never piled up, mirrored, locked, clamped, and undone to the last bit."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from facemodel.errors import PaintError
from facemodel.face import Face, Layers
from facemodel.painting.brush import MODES, Brush, Mode, falloff
from facemodel.painting.geodesic import SurfacePoint
from facemodel.painting.layers import LAYER, PAINT_LAYERS, PaintLayer
from facemodel.painting.mirror import mirror_partners
from facemodel.painting.stroke import Stroke, Touch
from facemodel.painting.surface import PaintSurface
from fem import Support
from fem.types import BoolArray, FloatArray, IntArray
from tests.facemodel.skin import face_on, flat_skin

SHEET = PaintSurface(flat_skin())
COUNT = len(SHEET.mesh.positions)
PLACE = st.tuples(st.floats(-22, 22), st.floats(-22, 22))


def layers_of(count: int, seed: int = 4) -> Layers:
    rng = np.random.default_rng(seed)
    return Layers(
        direction=rng.normal(size=(count, 3)),
        stretching=rng.uniform(0.05, 1.0, (count, 2)),
        bending=rng.uniform(0.1, 2.0, (count, 3)),
        stiffness=rng.uniform(0.001, 0.02, count),
        thickness=rng.uniform(2.0, 20.0, count),
        sliding=rng.uniform(5.0, 50.0, count),
        volume=rng.uniform(0.0, 0.3, count),
        supports=rng.integers(0, 2, count),
    )


LAYERS = layers_of(COUNT)
FACE = face_on(SHEET.mesh, LAYERS)


def point(*place: float) -> SurfacePoint:
    return SHEET.path.nearest(np.array([*place, 0.0]))[0]


def stroked(
    places: list[tuple[float, float]],
    brush: Brush,
    layer: str = "stiffness",
    partners: IntArray | None = None,
    locked: BoolArray | None = None,
) -> Stroke:
    stroke = Stroke(SHEET, FACE, LAYER[layer], brush, partners, locked)
    for place in places:
        stroke.extend(point(*place))
    return stroke


def after(stroke: Stroke) -> FloatArray:
    """Return the values of the whole layer after a stroke."""
    return stroke.layer.values(replace(FACE, layers=stroke.delta().done(LAYERS)))


def from_segment(start: tuple[float, float], end: tuple[float, float]) -> FloatArray:
    """Return the distance of every vertex of the sheet from a straight piece, by plane geometry."""
    a, b = np.array([*start, 0.0]), np.array([*end, 0.0])
    way = b - a
    share = np.clip((SHEET.mesh.positions - a) @ way / max(way @ way, 1e-30), 0, 1)
    return np.asarray(np.linalg.norm(SHEET.mesh.positions - a - share[:, None] * way, axis=1))


@settings(max_examples=30)
@given(PLACE, PLACE, st.floats(3.0, 9.0), st.floats(0.0, 0.8), st.floats(0.1, 1.0))
def test_a_stroke_is_the_capsule_about_its_way(
    start: tuple[float, float], end: tuple[float, float], radius: float, hardness: float, strength: float
) -> None:
    """However far apart the two places of the mouse are."""
    brush = Brush(radius, strength, hardness, "set", 0.05)
    expected = strength * falloff(from_segment(start, end), radius, hardness)
    before = LAYERS.stiffness
    found = (after(stroked([start, end], brush)) - before) / (0.05 - before)
    assert np.abs(found - expected).max() < 0.01 / (1 - hardness)


@settings(max_examples=15)
@given(PLACE, PLACE, st.integers(2, 60))
def test_a_slow_stroke_paints_what_a_quick_one_does(
    start: tuple[float, float], end: tuple[float, float], stops: int
) -> None:
    brush = Brush(6.0, 0.7, 0.3, "add", 0.01)
    way = [(start[0] + t * (end[0] - start[0]), start[1] + t * (end[1] - start[1])) for t in np.linspace(0, 1, stops)]
    quick, slow = after(stroked([start, end], brush)), after(stroked(way, brush))
    assert np.abs(quick - slow).max() < 0.01 * 0.01


def test_staying_or_going_back_paints_nothing_more() -> None:
    stroke = stroked([(-10.0, 0.0), (10.0, 0.0)], Brush(6.0, 0.5, 0.0, "scale", 2.0))
    once = after(stroke)
    assert len(stroke.extend(point(10.0, 0.0)).vertices) == 0
    stroke.extend(point(-10.0, 0.0))
    assert after(stroke) == pytest.approx(once, rel=1e-2)


@settings(max_examples=15)
@given(st.lists(PLACE, min_size=1, max_size=5), st.sampled_from(PAINT_LAYERS), st.data())
def test_what_is_told_along_the_way_is_what_is_there_at_the_end(
    places: list[tuple[float, float]], paint: PaintLayer, data: st.DataObject
) -> None:
    mode: Mode = data.draw(st.sampled_from(MODES[paint.kind]))
    stroke = Stroke(SHEET, FACE, paint, Brush(7.0, 0.8, 0.2, mode, 1.0))
    told = paint.values(FACE)
    for place in places:
        touch: Touch = stroke.extend(point(*place))
        told[touch.vertices] = touch.values
    delta = stroke.delta()
    done = delta.done(LAYERS)
    assert paint.values(replace(FACE, layers=done)) == pytest.approx(told, abs=1e-9)
    assert_undone(delta.undone(done))


def assert_undone(layers: Layers) -> None:
    for name in ("direction", "stretching", "bending", "stiffness", "supports"):
        found, expected = getattr(layers, name), getattr(LAYERS, name)
        assert found.dtype == expected.dtype
        assert found.tobytes() == expected.tobytes()


def test_only_what_is_touched_changes_and_is_kept() -> None:
    stroke = stroked([(0.0, 0.0), (5.0, 5.0)], Brush(5.0, 1.0, 0.5, "set", 0.03), "bending-across")
    delta = stroke.delta()
    done = delta.done(LAYERS)
    near = from_segment((0.0, 0.0), (5.0, 5.0)) < 5.0
    assert np.array_equal((done.bending != LAYERS.bending).any(axis=1), near)
    assert np.array_equal(done.bending[:, [0, 2]], LAYERS.bending[:, [0, 2]])
    assert done.stiffness is LAYERS.stiffness
    assert delta.nbytes < 100 * near.sum()


def test_a_brush_that_reaches_no_vertex_changes_nothing() -> None:
    stroke = stroked([(1.0, 0.5)], Brush(0.1, 1.0, 1.0, "set", 0.05), "bending-along")
    assert len(stroke.delta()) == 0
    assert stroke.delta().done(LAYERS).bending.tobytes() == LAYERS.bending.tobytes()


def test_a_hard_brush_of_full_strength_leaves_exactly_its_value() -> None:
    found = after(stroked([(0.0, 0.0)], Brush(6.0, 1.0, 1.0, "set", 0.0123)))
    inside = from_segment((0.0, 0.0), (0.0, 0.0)) < 6.0 - 1e-3
    assert np.all(found[inside] == 0.0123)
    assert np.array_equal(found[~inside & (found != 0.0123)], LAYERS.stiffness[~inside & (found != 0.0123)])


@pytest.mark.parametrize("paint", [each for each in PAINT_LAYERS if each.kind == "amount"], ids=lambda e: e.key)
def test_values_stay_in_their_range(paint: PaintLayer) -> None:
    for amount in (1e6, -1e6):
        stroke = Stroke(SHEET, FACE, paint, Brush(8.0, 1.0, 0.0, "add", amount))
        values = stroke.extend(point(0.0, 0.0)).values
        assert values.min() >= paint.low
        assert values.max() <= paint.high
        assert (paint.high if amount > 0 else paint.low) in values


def test_pressure_changes_evenly_along_the_way() -> None:
    stroke = Stroke(SHEET, FACE, LAYER["stiffness"], Brush(4.0, 1.0, 1.0, "set", 0.05))
    stroke.extend(point(-16.0, 0.0), 0.0)
    stroke.extend(point(16.0, 0.0), 1.0)
    share = (after(stroke) - LAYERS.stiffness) / (0.05 - LAYERS.stiffness)
    on_way = np.abs(SHEET.mesh.positions[:, 1]) < 0.1
    x = SHEET.mesh.positions[:, 0]
    middle = on_way & (np.abs(x) < 12)
    assert share[middle] == pytest.approx((x[middle] + 16 + 4) / 32, abs=0.07), "its rim is 4 mm ahead of its middle"
    assert np.all(np.diff(share[middle][np.argsort(x[middle])]) >= -1e-9)


def test_locked_vertices_keep_their_value() -> None:
    locked = SHEET.mesh.positions[:, 0] > 1.0
    stroke = stroked([(-5.0, 0.0), (5.0, 0.0)], Brush(6.0, 1.0, 0.0, "set", 0.09), locked=locked)
    found = after(stroke)
    assert np.array_equal(found[locked], LAYERS.stiffness[locked])
    assert (found != LAYERS.stiffness)[~locked].any()


def test_supports_are_chosen_wholly_or_not_at_all() -> None:
    stroke = stroked([(0.0, 0.0)], Brush(6.0, 0.2, 0.0, "set", float(Support.SLIDING)), "supports")
    done = stroke.delta().done(LAYERS)
    inside = from_segment((0.0, 0.0), (0.0, 0.0)) < 6.0 - 1e-3
    assert done.supports.dtype == LAYERS.supports.dtype
    assert np.all(done.supports[inside] == Support.SLIDING)
    far = from_segment((0.0, 0.0), (0.0, 0.0)) > 6.0 + 1e-3
    assert np.array_equal(done.supports[far], LAYERS.supports[far])


def test_smoothing_evens_out_and_never_exceeds_what_is_around() -> None:
    values = after(stroked([(-25.0, 0.0), (25.0, 0.0)], Brush(12.0, 1.0, 1.0, "smooth")))
    inside = from_segment((-25.0, 0.0), (25.0, 0.0)) < 11.9
    assert values[inside].std() < 0.35 * LAYERS.stiffness[inside].std()
    assert values.min() >= LAYERS.stiffness.min()
    assert values.max() <= LAYERS.stiffness.max()
    assert values[inside].mean() == pytest.approx(LAYERS.stiffness[inside].mean(), rel=0.05)


def test_smoothing_leaves_what_is_even() -> None:
    even = replace(LAYERS, stiffness=np.full(COUNT, 0.004))
    stroke = Stroke(SHEET, replace(FACE, layers=even), LAYER["stiffness"], Brush(10.0, 1.0, 0.0, "smooth"))
    assert stroke.extend(point(0.0, 0.0)).values == pytest.approx(0.004, rel=1e-12)


@pytest.mark.parametrize("angle", [0.0, 35.0, 90.0, -60.0])
def test_the_grain_is_combed_along_the_stroke(angle: float) -> None:
    way = 15 * np.array([np.cos(np.radians(angle)), np.sin(np.radians(angle))])
    found = after(stroked([tuple(-way), tuple(way)], Brush(6.0, 1.0, 1.0, "comb"), "grain"))
    on_way = from_segment(tuple(-way), tuple(way)) < 5.9
    assert np.abs(across(found[on_way], angle)).max() < 1e-6


def across(one: FloatArray, other: float) -> FloatArray:
    """Return by how much lines differ in direction, degrees from -90 to 90."""
    return np.asarray((one - other + 90.0) % 180.0 - 90.0)


def test_combing_to_and_fro_combs_along_the_line() -> None:
    found = after(stroked([(-10.0, 0.0), (10.0, 0.0), (-10.0, 0.0)], Brush(5.0, 1.0, 1.0, "comb"), "grain"))
    assert np.abs(across(found[from_segment((-8.0, 0.0), (8.0, 0.0)) < 4.9], 0.0)).max() < 1e-6


def test_a_press_without_a_way_combs_nothing() -> None:
    stroke = stroked([(0.0, 0.0)], Brush(6.0, 1.0, 0.0, "comb"), "grain")
    assert len(stroke.delta()) == 0


def test_half_strength_turns_the_grain_half_the_way() -> None:
    grain = np.full(COUNT, 80.0)
    layers = LAYER["grain"].delta(FACE, np.arange(COUNT), grain).done(LAYERS)
    stroke = Stroke(SHEET, replace(FACE, layers=layers), LAYER["grain"], Brush(6.0, 0.5, 1.0, "comb"))
    stroke.extend(point(-10.0, 0.0))
    touch = stroke.extend(point(10.0, -20.0 * np.tan(np.radians(20.0))))
    assert across(touch.values, 120.0) == pytest.approx(0.0, abs=1e-6), "80° towards 160°, the way of the stroke"


def test_modes_that_make_no_sense_are_refused() -> None:
    for layer in PAINT_LAYERS:
        for mode in ("set", "add", "scale", "smooth", "comb"):
            brush = Brush(5.0, mode=mode, value=1.0)
            if mode in MODES[layer.kind]:
                Stroke(SHEET, FACE, layer, brush)
            else:
                with pytest.raises(PaintError, match=f"“{layer.title}” knows no “{mode}”"):
                    Stroke(SHEET, FACE, layer, brush)


@pytest.mark.parametrize(
    "numbers",
    [{"radius": 0.0}, {"radius": 1e3}, {"radius": np.nan}, {"strength": 1.5}, {"hardness": -0.1}, {"value": np.inf}],
)
def test_an_impossible_brush_is_refused_in_a_sentence(numbers: dict[str, float]) -> None:
    with pytest.raises(PaintError, match=r"possible|cannot be painted"):
        Brush(**({"radius": 5.0} | numbers))


ALIKE = 1e-3
"""Degrees and units of layers: the two sides of a skin whose lips were closed are mirror images but for rounding."""


@pytest.fixture(scope="module")
def surface(face: Face) -> PaintSurface:
    return PaintSurface(face.skin)


@pytest.mark.parametrize(
    ("layer", "mode"), [("stiffness", "add"), ("grain", "comb"), ("grain", "set"), ("supports", "set")]
)
def test_a_mirrored_stroke_paints_both_sides_alike(face: Face, surface: PaintSurface, layer: str, mode: Mode) -> None:
    places = [face.skin.positions[face.landmarks[name]] for name in ("cheek_L", "mouth_corner_L", "chin")]
    paint, brush = LAYER[layer], Brush(9.0, 0.8, 0.2, mode, {"stiffness": 0.01, "grain": 30.0, "supports": 1.0}[layer])
    mirrored = Stroke(surface, face, paint, brush, mirror_partners(face))
    alone = Stroke(surface, face, paint, brush)
    for way in places:
        for stroke in (mirrored, alone):
            stroke.extend(surface.path.nearest(way)[0])
    before = paint.values(face)
    both = paint.values(replace(face, layers=mirrored.delta().done(face.layers)))
    one = paint.values(replace(face, layers=alone.delta().done(face.layers)))
    sign = -1.0 if layer == "grain" else 1.0
    touched = both != before
    assert np.array_equal(touched[face.mirror], touched)
    assert np.abs(across((sign * both)[face.mirror] - both, 0.0))[touched].max() < ALIKE
    outer = face.skin.positions[:, 0] > 12.0
    assert both[outer] == pytest.approx(one[outer], abs=1e-9)
    assert np.array_equal(before[outer], one[outer]) is False
    far = face.skin.positions[:, 0] < -12.0
    assert np.array_equal(one[far], before[far])


def test_without_a_map_partners_are_found_by_position(face: Face) -> None:
    count = len(face.mirror)
    unknown = replace(face, mirror=np.arange(count))
    assert np.array_equal(mirror_partners(unknown), face.mirror)


def test_a_face_without_symmetry_is_refused_in_a_sentence(face: Face) -> None:
    crooked = face.skin.positions + np.array([8.0, 0.0, 0.0])
    without = replace(face, mirror=np.arange(len(face.mirror)), skin=face.skin.moved(crooked))
    with pytest.raises(PaintError, match=r"is not symmetric: .* Paint without mirroring"):
        mirror_partners(without)

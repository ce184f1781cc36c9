"""Fibres bent over the bone: lengths, frames and nearest points of curves, and forces along the local tangent."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from facemodel.mesh import Mesh
from facemodel.muscles import Fibre
from facemodel.muscles.curve import STEPS, curves, feet, path, paths
from facemodel.muscles.fibre import fan, fibre_forces, lateral, longitudinal
from fem.types import FloatArray
from tests.facemodel.skin import at, bent_muscle, domed_skin, fibre_muscle, flat_skin, sizes

RADIUS = 20.0


def arc(turn: float) -> FloatArray:
    """A point on a quarter circle in the plane of the skin; 0 on the x axis, 1 on the y axis."""
    return RADIUS * np.array([np.cos(np.pi / 2 * turn), np.sin(np.pi / 2 * turn), 0.0])


def quarter(knots: int = 9) -> Fibre:
    """A fibre along the quarter circle, from its origin on the x axis to its attachment on the y axis."""
    via = tuple(arc(turn) for turn in np.linspace(0, 1, knots)[1:-1])
    return Fibre(arc(0), arc(1), via)


def test_a_fibre_without_intermediate_points_is_its_chord() -> None:
    line = path(Fibre(np.array([0.0, 0, 0]), np.array([8.0, 0, 4])))
    assert line == pytest.approx(np.linspace([0, 0, 0], [8, 0, 4], STEPS + 1))


def test_a_bent_fibre_passes_through_its_points_with_its_ends_untouched() -> None:
    fibre = quarter(5)
    line = path(fibre, 400)
    assert np.array_equal(line[[0, -1]], [fibre.origin, fibre.attachment])
    for point in fibre.via:
        assert np.linalg.norm(line - point, axis=1).min() < 0.06


def test_a_bent_fibre_is_as_long_as_its_arc_and_cut_into_equal_parts() -> None:
    fibre = quarter()
    bent = curves(paths((fibre,), 1), np.array([[0.0, 0, 1]]))
    # The natural ends and the chords of the cut shorten a quarter of a circle by less than a thousandth.
    assert bent.length[0] == pytest.approx(np.pi / 2 * RADIUS, rel=1e-3)
    parts = np.linalg.norm(np.diff(bent.points[0], axis=0), axis=1)
    assert parts == pytest.approx(parts.mean(), rel=1e-3)
    assert np.linalg.norm(bent.points[0], axis=1) == pytest.approx(RADIUS, rel=2e-3)


def test_tangents_point_towards_the_origin_and_normals_stay_square_to_them() -> None:
    bent = curves(paths((quarter(),), 1), np.array([[0.3, 0.0, 1.0]]))
    pull, across = bent.pull[0], bent.across[0]
    radial = bent.points[0] / RADIUS
    towards = np.column_stack([radial[:, 1], -radial[:, 0], radial[:, 2]])
    # The curve is straight at its free ends, so that its first and last tangents are two degrees short.
    assert pull[1:-1] == pytest.approx(towards[1:-1], abs=0.02)
    assert pull == pytest.approx(towards, abs=0.04)
    assert np.einsum("kc,kc->k", pull, across) == pytest.approx(0.0, abs=1e-12)
    assert np.linalg.norm(across, axis=1) == pytest.approx(1.0)
    # A plane curve carries the normal of its plane along; the part in the plane turns with the curve.
    assert across[:, 2] == pytest.approx(across[-1, 2], abs=0.02)


@settings(max_examples=40)
@given(st.integers(0, 10**6))
def test_the_foot_is_the_nearest_point_of_the_curve(seed: int) -> None:
    rng = np.random.default_rng(seed)
    points = np.cumsum(rng.uniform([4, -6, -6], [14, 6, 6], (5, 3)), axis=0)
    bent = curves(path(Fibre(points[0], points[-1], tuple(points[1:-1])))[None], np.array([[0.1, 0.2, 1.0]]))
    places = rng.uniform(points.min(axis=0), points.max(axis=0), (60, 3))
    found = feet(bent, places, 1e3)
    dense = np.concatenate(
        [np.linspace(a, b, 300, endpoint=False) for a, b in zip(bent.points[0, :-1], bent.points[0, 1:], strict=True)]
    )
    between = (found.rho > 0) & (found.rho < bent.length[0])
    nearest = np.linalg.norm(places[:, None] - dense, axis=2).min(axis=1)
    assert np.array_equal(found.place, np.arange(60))
    # Feet are sought in the two pieces beside the nearest knot; where a path bends sharply another piece may be nearer,
    # for few places and by little.
    error = np.abs(sizes(found.offset)[between] - nearest[between])
    assert error.max() < 0.2
    assert np.median(error) < 0.001


def test_places_past_the_ends_are_measured_along_the_last_tangent() -> None:
    bent = curves(paths((Fibre(np.zeros(3), np.array([16.0, 0, 0]), (np.array([8.0, 0, 0]),)),), 1), np.eye(3)[2:])
    found = feet(bent, np.array([[-3.0, 1, 2], [5.0, -1, 0], [21.0, 0, 4]]), 100.0)
    assert found.rho == pytest.approx([-3, 5, 21])
    assert found.offset == pytest.approx(np.array([[0, 1, 2], [0, -1, 0], [0, 0, 4]]), abs=1e-12)


@settings(max_examples=25)
@given(st.integers(0, 10**6))
def test_points_on_the_chord_do_not_bend_a_fibre(seed: int) -> None:
    rng = np.random.default_rng(seed)
    skin = domed_skin(segments=16)
    ends = rng.uniform(-25, 25, (3, 2, 3)) * [1, 1, 0.2]
    straight = fibre_muscle([(list(o), list(a)) for o, a in ends], width=11.0, kappa=2.0, count=7)
    middles = [tuple(o + share * (a - o) for share in (0.3, 0.6)) for o, a in ends]
    bent = bent_muscle([(o, a, via) for (o, a), via in zip(ends, middles, strict=True)], straight)
    assert fibre_forces(bent, skin) == pytest.approx(fibre_forces(straight, skin), abs=1e-9)


def test_a_bent_fibre_pulls_along_its_tangent_with_its_arclength() -> None:
    skin = flat_skin(segments=60)
    muscle = bent_muscle([(arc(0), arc(1), quarter().via)], fibre_muscle([], width=6.0, kappa=2.0, strength=0.5))
    forces = fibre_forces(muscle, skin)
    radius = sizes(skin.positions)
    turn = np.arctan2(skin.positions[:, 1], skin.positions[:, 0]) / (np.pi / 2)
    on_arc = (np.abs(radius - RADIUS) < 5) & (turn > 0.1) & (turn < 0.9)
    x, y, _ = (skin.positions[on_arc] / radius[on_arc, None]).T
    weight = longitudinal(turn[on_arc], 2.0) * lateral(np.abs(radius[on_arc] - RADIUS) / 6.0)
    expected = 0.5 * weight[:, None] * np.column_stack([y, -x, np.zeros_like(x)])
    assert forces[on_arc] == pytest.approx(expected, abs=0.01)
    chord = np.array([1.0, -1.0, 0.0]) / np.sqrt(2)
    start = at(skin, 19, 6, 0)
    assert forces[start] @ chord < 0.92 * sizes(forces)[start], "near the origin it does not pull along the chord"


def test_a_bent_fibre_leaves_what_lies_outside_its_width_alone() -> None:
    skin = flat_skin(segments=60)
    muscle = bent_muscle([(arc(0), arc(1), quarter().via)], fibre_muscle([], width=6.0))
    size = sizes(fibre_forces(muscle, skin))
    radius = sizes(skin.positions)
    behind = (skin.positions[:, 1] < -1) & (skin.positions[:, 0] > 5)
    aside = (np.abs(radius - RADIUS) > 6.2) & (skin.positions[:, 0] > 0) & (skin.positions[:, 1] > 0)
    past = skin.positions[:, 0] < -6.5
    assert size[behind | aside | past].max() == 0.0
    assert size[at(skin, 0, 20, 0)] == pytest.approx(1.0, abs=0.02), "the whole strength at the attachment"


@given(st.integers(0, 10**6))
def test_a_bent_force_turns_with_the_head(seed: int) -> None:
    rng = np.random.default_rng(seed)
    turn, shift = Rotation.random(random_state=rng.integers(2**31)).as_matrix(), rng.uniform(-50, 50, 3)
    skin = domed_skin(segments=10)
    origin, attachment, via = rng.uniform(-25, 25, (3, 3)) * [1, 1, 0.3]
    like = fibre_muscle([], width=12.0)
    muscle = bent_muscle([(origin, attachment, (via,))], like)
    moved = bent_muscle([(turn @ origin + shift, turn @ attachment + shift, (turn @ via + shift,))], like)
    expected = fibre_forces(muscle, skin) @ turn.T
    found = fibre_forces(moved, Mesh(skin.positions @ turn.T + shift, skin.triangles))
    assert found == pytest.approx(expected, abs=1e-7)


def test_the_fan_of_bent_fibres_has_the_ends_of_the_fan_of_straight_ones() -> None:
    ends = [(arc(0), arc(1)), (1.3 * arc(0), 1.4 * arc(1))]
    bent = tuple(Fibre(o, a, ((o + a) / 2 + [0, 0, 5.0],)) for o, a in ends)
    origins, attachments = fan(tuple(Fibre(o, a) for o, a in ends), 7)
    lines = paths(bent, 7)
    assert lines[:, 0] == pytest.approx(origins)
    assert lines[:, -1] == pytest.approx(attachments)
    assert lines[:, STEPS // 2, 2].min() > 4.5


def test_the_straight_formula_is_the_one_of_the_paper_vertex_by_vertex() -> None:
    skin = domed_skin(segments=12)
    origin, attachment = np.array([-18.0, 3, 2]), np.array([14.0, -5, -1])
    muscle = fibre_muscle([(list(origin), list(attachment))], width=9.0, kappa=3.0, strength=0.4)
    length = np.linalg.norm(origin - attachment)
    m = (origin - attachment) / length
    n = skin.normals[np.linalg.norm(skin.positions - attachment, axis=1).argmin()]
    n = n - (n @ m) * m
    n = n / np.linalg.norm(n)
    expected = np.zeros_like(skin.positions)
    for i, x in enumerate(skin.positions):
        rho = (origin - x) @ m
        p = x - origin + rho * m
        omega = np.linalg.norm(p - (p @ n) * n)
        if rho < 0 or omega >= 9.0:
            continue
        e = min(rho / length, 1.0) ** 3.0
        t1 = np.sin(np.pi / 2 * e) + (np.sin(2 * np.pi * e - np.pi / 2) + 1) / 8
        fade = [omega / 9.0, min(max(rho - length, 0) / 9.0, 1), min(abs(p @ n) / length, 1)]
        expected[i] = 0.4 * t1 * np.prod([(np.cos(np.pi * g**1.8) + 1) / 2 for g in fade]) * m
    assert fibre_forces(muscle, skin) == pytest.approx(expected, abs=1e-14)

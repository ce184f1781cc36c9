"""Posing in real time: the same arrays for ever, exact sums however they were reached, and rigid teeth."""

import numpy as np
import pytest
from hypothesis import HealthCheck, given, settings
from hypothesis import strategies as st
from scipy.spatial.distance import pdist

from facemodel.actions import Expression, expand
from facemodel.basis import Basis
from facemodel.face import Face, Jaw
from facemodel.facs import action_units
from facemodel.jaw.motion import jaw_motion
from facemodel.project import Project
from facemodel.superposition import REFRESH_AFTER, Superposition
from tests.facemodel.places import points_of_vertices

FIELDS = [name for unit in action_units() for name in unit.fields]
STEP = st.tuples(st.sampled_from(FIELDS), st.floats(0.0, 1.5, width=32))
SAME = 5e-3
"""Millimetres.  Rounding of one addition is 4e-6 on a head and adds up like a random walk; where lips and lids meet
steeply, what brings them apart takes it some times larger."""
MOST = 0.9995
"""Share of the normals that rounding hardly turns; where a mix crumples the skin to a line it may turn one."""
SAME_FACE = settings(max_examples=15, deadline=None, suppress_health_check=[HealthCheck.function_scoped_fixture])


@pytest.fixture
def posed(face: Face, basis: Basis) -> Superposition:
    return Superposition(face, basis)


def buffers(posed: Superposition) -> dict[str, np.ndarray]:
    return {"points": posed.points, "normals": posed.normals, **posed.parts}


def copies(posed: Superposition) -> dict[str, np.ndarray]:
    return {name: array.copy() for name, array in buffers(posed).items()}


def summed(basis: Basis, expression: Expression) -> np.ndarray:
    """Return the posed skin in double precision, formed afresh."""
    skin = basis.display.points.astype(np.float64)
    for name, weight in expression.items():
        skin += np.float32(weight) * basis.field(name).astype(np.float64)
    return skin


def test_at_rest_it_shows_the_face_as_it_is(posed: Superposition, face: Face, basis: Basis) -> None:
    assert np.array_equal(posed.points, basis.display.points)
    assert np.array_equal(posed.normals, basis.display.normals)
    assert set(posed.parts) == {part.name for part in face.parts}
    for part in face.parts:
        assert np.array_equal(posed.parts[part.name], part.mesh.positions.astype(np.float32))
    assert np.array_equal(posed.jaw, np.eye(4))


def test_an_expression_is_the_weighted_sum_of_its_fields(face: Face, project: Project, basis: Basis) -> None:
    posed = Superposition(face, basis, linear=True)
    for emotion in project.emotions:
        expression = expand(emotion.weights, project.units)
        posed.pose(expression)
        assert np.abs(posed.points - summed(basis, expression)).max() < 1e-4


def test_what_is_drawn_stays_where_it_is_in_memory(posed: Superposition) -> None:
    before = {name: (id(array), array.ctypes.data) for name, array in buffers(posed).items()}
    for expression in ({"12L": 1.0}, {"12L": 0.5}, dict.fromkeys(FIELDS, 0.3), {}):
        posed.pose(expression)
        assert {name: (id(array), array.ctypes.data) for name, array in buffers(posed).items()} == before
        assert all(array.dtype == np.float32 and array.flags.c_contiguous for array in buffers(posed).values())


@SAME_FACE
@given(st.lists(STEP, min_size=1, max_size=60))
def test_slider_after_slider_comes_to_the_same_face_as_all_at_once(
    face: Face, basis: Basis, steps: list[tuple[str, float]]
) -> None:
    dragged, fresh = Superposition(face, basis), Superposition(face, basis)
    weights: dict[str, float] = {}
    for name, weight in steps:
        weights[name] = weight
        dragged.pose(weights)
    fresh.pose(weights)
    assert np.abs(dragged.points - fresh.points).max() < SAME
    assert np.quantile(np.abs(dragged.normals - fresh.normals), MOST) < 2e-3
    for name, points in dragged.parts.items():
        assert np.abs(points - fresh.parts[name]).max() < SAME
    assert dragged.jaw == pytest.approx(fresh.jaw, abs=1e-6)


def test_rounding_does_not_pile_up_over_a_long_drag(face: Face, basis: Basis) -> None:
    posed = Superposition(face, basis, linear=True)
    rng = np.random.default_rng(2)
    weights = {"12L": 0.7, "27": 0.4}
    worst = 0.0
    for step in range(3 * REFRESH_AFTER):
        weights["12L"] = float(np.float32(rng.uniform(0, 1)))
        posed.pose(weights)
        if step % 97 == 0:
            worst = max(worst, np.abs(posed.points - summed(basis, weights)).max())
    assert worst < 1e-3


def test_returning_to_rest_restores_every_bit(posed: Superposition) -> None:
    rest = copies(posed)
    rng = np.random.default_rng(4)
    for _ in range(20):
        posed.pose({name: float(w) for name, w in zip(FIELDS, rng.uniform(0, 1, len(FIELDS)), strict=True)})
    posed.pose({})
    assert all(np.array_equal(array, rest[name]) for name, array in copies(posed).items())


def test_letting_go_of_a_single_slider_restores_every_bit(posed: Superposition) -> None:
    rest = copies(posed)
    for weight in (0.1, 0.7, 0.35, 0.0):
        posed.pose({"26": weight})
    assert all(np.array_equal(array, rest[name]) for name, array in copies(posed).items())


def test_normals_are_units_and_stand_on_the_posed_surface(posed: Superposition, basis: Basis) -> None:
    posed.pose({"12L": 1.0, "12R": 1.0, "26": 0.6})
    assert np.linalg.norm(posed.normals, axis=1) == pytest.approx(1.0, abs=1e-5)
    corners = posed.points[basis.display.triangles].astype(np.float64)
    flat = np.cross(corners[:, 1] - corners[:, 0], corners[:, 2] - corners[:, 0])
    length = np.linalg.norm(flat, axis=1, keepdims=True)
    cosine = np.einsum("ij,ij->i", flat / length, posed.normals[basis.display.triangles].mean(axis=1))
    assert np.median(cosine) > 0.99
    assert np.percentile(cosine, 2) > 0.7


def test_a_weight_of_zero_is_no_weight(posed: Superposition) -> None:
    posed.pose({"12L": 0.5, "1L": 0.0})
    with_zero = copies(posed)
    posed.pose({"12L": 0.5})
    assert all(np.array_equal(array, with_zero[name]) for name, array in copies(posed).items())


def test_names_without_a_field_are_ignored(posed: Superposition) -> None:
    posed.pose({"12L": 0.5})
    known = copies(posed)
    posed.pose({"12L": 0.5, "99": 1.0})
    assert all(np.array_equal(array, known[name]) for name, array in copies(posed).items())


def test_the_jaw_carries_teeth_and_tongue_rigidly_and_leaves_the_upper_teeth(posed: Superposition, face: Face) -> None:
    rest = copies(posed)
    posed.pose({"27": 1.0})
    for part in face.parts:
        if part.carrier == "skin":
            continue
        points, before = posed.parts[part.name].astype(np.float64), part.mesh.positions
        assert pdist(points) == pytest.approx(pdist(before), abs=1e-4)
        if part.carrier == "skull":
            assert np.array_equal(posed.parts[part.name], rest[part.name])
        else:
            assert (points - before)[:, 1].mean() < -5.0
            moved = np.column_stack([before, np.ones(len(before))]) @ posed.jaw.T
            assert points == pytest.approx(moved[:, :3], abs=1e-4)


def test_what_hangs_on_the_skin_follows_it(posed: Superposition, face: Face, basis: Basis) -> None:
    """The rim of mouth and sockets stays on the loops of the skin that it closes."""
    posed.pose({"12L": 1.0, "43L": 1.0, "43R": 0.5, "27": 0.7})
    skin = posed.points[points_of_vertices(face, basis.display)]
    for part in (p for p in face.parts if p.kind in {"lining", "socket"}):
        alone = np.flatnonzero(part.shares.max(axis=1) > 1 - 1e-6)
        vertices = part.anchors[alone, part.shares[alone].argmax(axis=1)]
        assert len(alone) > 20
        assert posed.parts[part.name][alone] == pytest.approx(skin[vertices], abs=1e-3)


@given(st.floats(0.0, 35.0), st.floats(0.0, 12.0))
def test_the_jaw_turns_about_the_condyles_and_slides_forward_and_down(degrees: float, slide: float) -> None:
    jaw = Jaw(np.array([[-50.0, 0, -20], [50.0, 2, -20]]), np.array([0.0, -40, 40]))
    motion = jaw_motion(jaw, degrees, slide)
    turn = motion[:3, :3]
    assert turn @ turn.T == pytest.approx(np.eye(3), abs=1e-12)
    assert np.linalg.det(turn) == pytest.approx(1.0)
    condyles = jaw.axis @ turn.T + motion[:3, 3] - jaw.axis
    assert condyles[0] == pytest.approx(condyles[1], abs=1e-9), "the axis keeps its direction"
    assert 0.95 * slide - 1e-9 <= np.linalg.norm(condyles[0]) <= slide + 1e-9, "along the eminence, which is bent"
    if slide > 1e-6:
        assert condyles[0][2] > 0 > condyles[0][1]
    teeth = turn @ jaw.teeth + motion[:3, 3]
    if degrees > 1.0:
        assert teeth[1] < jaw.teeth[1], "it opens"

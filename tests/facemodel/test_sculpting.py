"""What a hand sculpts goes where the hand goes, smoothly, on top of what is solved and never into it."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from hypothesis.extra.numpy import arrays

from facemodel.actions import ActionUnit
from facemodel.errors import PaintError
from facemodel.mesh import Mesh
from facemodel.painting.geodesic import SurfacePoint
from facemodel.painting.surface import PaintSurface
from facemodel.project import Project, Settings
from facemodel.sculpting.brush import RAISED, SculptBrush
from facemodel.sculpting.corrected import Corrector
from facemodel.sculpting.correction import (
    NOTHING,
    correction_of,
    halved,
    joined,
    mirrored,
    movable,
    side_shares,
    summed,
)
from facemodel.sculpting.sampler import CorrectionSampler, correction_sampler
from facemodel.sculpting.slopes import vertex_slopes
from facemodel.sculpting.stroke import Layer, Sculpted, SculptStroke, on_both_sides
from facemodel.solution import Solution
from facemodel.solve import solve_project
from facemodel.superposition import Superposition
from fem.types import FloatArray
from tests.app.conftest import SIDE, small_project

MIDDLE = SIDE * SIDE // 2
UP = np.array([0.0, 1.0, 0.0])
ROUNDED = 1e-5
"""Millimetres that adding fields one by one and summing them may differ by in single precision."""


@pytest.fixture(scope="module")
def project() -> Project:
    return replace(small_project(), settings=Settings(density=3))


@pytest.fixture(scope="module")
def solution(project: Project) -> Solution:
    return solve_project(project)


@pytest.fixture(scope="module")
def surface(project: Project) -> PaintSurface:
    return PaintSurface(project.face.skin)


def bumps(project: Project, size: float = 1.0) -> FloatArray:
    """Return a rough displacement (N, 3) of the vertices that can be moved."""
    rough = np.random.default_rng(5).uniform(-size, size, project.face.skin.positions.shape)
    return np.where(movable(project.face)[:, None], rough, 0.0)


def work(project: Project, surface: PaintSurface, **how: object) -> Sculpted:
    """Return the patch at rest with the chin raiser shown at 1, to be sculpted."""
    count = len(project.face.skin.positions)
    layer = Layer(NOTHING, np.zeros((count, 3)), 1.0, np.ones(count))
    given = {"layers": {"17": layer}, "movable": movable(project.face), **how}
    return Sculpted(surface, project.face.skin.positions, **given)  # type: ignore[arg-type]


def at_vertex(mesh: Mesh, vertex: int) -> SurfacePoint:
    triangle = int(np.flatnonzero((mesh.triangles == vertex).any(axis=1))[0])
    return SurfacePoint(triangle, (mesh.triangles[triangle] == vertex).astype(np.float64))


def roughness(project: Project, moved: FloatArray) -> float:
    """Return the mean square difference between neighbours."""
    i, j = project.face.skin.edges.T
    return float(((moved[i] - moved[j]) ** 2).sum(axis=1).mean())


@given(st.lists(st.floats(-2, 2), min_size=6, max_size=6))
def test_slopes_of_a_quadric_are_exact(terms: list[float]) -> None:
    face = small_project().face
    a, b, c, d, e, f = terms
    u, v = face.chart.T
    d_u, d_v = vertex_slopes(face.chart, face.skin.triangles)
    field = a + b * u + c * v + d * u * u + e * u * v + f * v * v
    np.testing.assert_allclose(d_u @ field, b + 2 * d * u + e * v, atol=1e-8)
    np.testing.assert_allclose(d_v @ field, c + e * u + 2 * f * v, atol=1e-8)


def test_what_is_drawn_of_a_displacement_is_exact_at_the_vertices_and_without_facets(
    project: Project, solution: Solution
) -> None:
    display = solution.basis.display
    x, y = project.face.skin.positions[:, :2].T
    hump = np.exp(-(x**2 + y**2) / 800)
    moved = np.stack([0 * hump, 0 * hump, hump], axis=1)
    everywhere = np.arange(len(moved))
    fields, slopes = CorrectionSampler(project.face, display).rows(everywhere, moved)
    drawn = fields.reshape(-1, 3)[-display.moving :, 2]
    places = display.points[: display.moving].astype(np.float64)
    inside = np.hypot(places[:, 0], places[:, 1]) < 25
    wanted = np.exp(-(places[:, 0] ** 2 + places[:, 1] ** 2) / 800)
    corners = project.face.skin.triangles[display.elements[: display.moving]]
    facets = np.einsum("pk,pk->p", display.barycentric[: display.moving], hump[corners])
    assert np.abs(drawn - wanted)[inside].max() < 0.5 * np.abs(facets - wanted)[inside].max()
    assert np.abs(drawn - wanted)[inside].mean() < 0.4 * np.abs(facets - wanted)[inside].mean()
    assert slopes.shape == (6 * display.moving,)
    on_vertex = np.flatnonzero(display.barycentric[: display.moving].max(axis=1) == 1)
    corner = display.barycentric[on_vertex].argmax(axis=1)
    vertex = project.face.skin.triangles[display.elements[on_vertex], corner]
    np.testing.assert_allclose(drawn[on_vertex], hump[vertex], atol=1e-6)


def test_what_changes_is_all_that_is_drawn_otherwise(project: Project, solution: Solution) -> None:
    sampler = correction_sampler(project.face, solution.basis.display)
    vertices = np.array([MIDDLE, MIDDLE + 1])
    moved = np.array([[1.0, 0, 2], [0, 3, 0]])
    change, (fields, slopes) = sampler.change(vertices, moved), sampler.rows(vertices, moved)
    full = np.zeros((len(fields) // 3, 3), dtype=np.float32)
    full[change.rows] = change.moved
    assert np.array_equal(full.ravel(), fields)
    whole = np.zeros((6, solution.basis.display.moving), dtype=np.float32)
    whole[:, change.points] = change.slopes
    np.testing.assert_allclose(whole.ravel(), slopes, atol=1e-7)
    assert len(change.rows) < len(full) / 2


def test_a_solve_of_other_muscles_keeps_the_same_correction(project: Project, solution: Solution) -> None:
    layer = correction_of(bumps(project))
    stronger = tuple(replace(muscle, strength=2 * muscle.strength) for muscle in project.muscles)
    corrector = Corrector()
    for each in (project, replace(project, muscles=stronger)):
        sculpted = replace(each, corrections={"12L": layer})
        raw = solution if each is project else solve_project(sculpted)
        shown = corrector(raw, sculpted)
        added = shown.basis.fields - raw.basis.fields
        row, _ = correction_sampler(each.face, raw.basis.display).rows(layer.vertices, layer.moved)
        np.testing.assert_allclose(added[raw.basis.index["12L"]], row, atol=1e-5)
        assert not np.delete(added, raw.basis.index["12L"], axis=0).any()
    assert not np.array_equal(raw.basis.fields, solution.basis.fields)


def test_half_of_a_correction_is_half_and_one_that_is_off_is_none(project: Project, solution: Solution) -> None:
    layer = correction_of(bumps(project))
    row = solution.basis.index["17"]

    def added(each: object) -> FloatArray:
        shown = Corrector()(solution, replace(project, corrections={"17": each}))  # type: ignore[dict-item]
        return shown.basis.fields[row].astype(np.float64) - solution.basis.fields[row]

    np.testing.assert_allclose(added(replace(layer, amount=0.5)), added(layer) / 2, atol=1e-5)
    off = replace(project, corrections={"17": replace(layer, on=False)})
    assert Corrector()(solution, off) is solution


def test_a_pulled_place_goes_exactly_with_the_hand(project: Project, solution: Solution, surface: PaintSurface) -> None:
    sampler = correction_sampler(project.face, solution.basis.display)
    point = SurfacePoint(int(np.flatnonzero((project.face.skin.triangles == MIDDLE).any(axis=1))[0]), np.ones(3) / 3)
    shares = sampler.shares_at(point)
    assert shares.sum() == pytest.approx(1)
    stroke = SculptStroke(work(project, surface), SculptBrush("pull", 18.0))
    stroke.take(point, shares)
    stroke.pull(9 * UP)
    stroke.pull(3 * UP)
    moved = stroke.corrections["17"].everywhere(len(shares))
    np.testing.assert_allclose(shares @ moved, 3 * UP, atol=1e-5)
    far = np.linalg.norm(project.face.skin.positions - point.position(project.face.skin), axis=1) > 18.0
    assert not moved[far].any()


def test_a_brush_smaller_than_a_triangle_still_pulls(
    project: Project, solution: Solution, surface: PaintSurface
) -> None:
    sampler = correction_sampler(project.face, solution.basis.display)
    point = SurfacePoint(40, np.ones(3) / 3)
    stroke = SculptStroke(work(project, surface), SculptBrush("pull", 0.5))
    stroke.take(point, sampler.shares_at(point))
    stroke.pull(UP)
    moved = stroke.corrections["17"].everywhere(SIDE * SIDE)
    assert 0.9 < (sampler.shares_at(point) @ moved)[1] <= 1.01
    assert np.abs(moved).max() < 4


def test_at_half_activation_and_half_amount_the_face_still_goes_with_the_hand(
    project: Project, surface: PaintSurface
) -> None:
    half = replace(NOTHING, amount=0.5)
    layer = Layer(half, np.zeros((SIDE * SIDE, 3)), 0.5, np.ones(SIDE * SIDE))
    stroke = SculptStroke(work(project, surface, layers={"17": layer}), SculptBrush("raise", 15.0))
    seen = stroke.extend(at_vertex(project.face.skin, MIDDLE))
    assert np.linalg.norm(seen.by, axis=1).max() == pytest.approx(RAISED)
    assert stroke.corrections["17"].largest == pytest.approx(4 * RAISED)


def test_raising_goes_along_the_posed_normal_and_reversed_into_the_face(
    project: Project, surface: PaintSurface
) -> None:
    skin = project.face.skin
    for reverse, sign in ((False, 1.0), (True, -1.0)):
        stroke = SculptStroke(work(project, surface), SculptBrush("raise", 15.0, reverse=reverse))
        stroke.extend(at_vertex(skin, MIDDLE))
        moved = stroke.corrections["17"].everywhere(SIDE * SIDE)
        np.testing.assert_allclose(moved[MIDDLE], sign * RAISED * skin.normals[MIDDLE], atol=1e-6)


def test_a_slow_stroke_does_no_more_than_a_quick_one(project: Project, surface: PaintSurface) -> None:
    skin = project.face.skin
    ends = [at_vertex(skin, MIDDLE - 2), at_vertex(skin, MIDDLE + 2)]
    slow = [ends[0], ends[0], *(at_vertex(skin, MIDDLE + step) for step in (-1, 0, 1)), ends[1]]
    found = []
    for way in (ends, slow):
        stroke = SculptStroke(work(project, surface), SculptBrush("raise", 15.0))
        for point in way:
            stroke.extend(point)
        found.append(stroke.corrections["17"].everywhere(SIDE * SIDE))
    np.testing.assert_allclose(found[0], found[1], atol=0.08)
    assert max(np.linalg.norm(each, axis=1).max() for each in found) <= RAISED + 1e-6


def test_pinching_draws_skin_to_the_middle_and_along_itself(project: Project, surface: PaintSurface) -> None:
    skin = project.face.skin
    for reverse in (False, True):
        stroke = SculptStroke(work(project, surface), SculptBrush("pinch", 25.0, hardness=0.5, reverse=reverse))
        stroke.extend(at_vertex(skin, MIDDLE))
        moved = stroke.corrections["17"].everywhere(SIDE * SIDE)
        assert not moved[MIDDLE].any()
        touched = np.flatnonzero(moved.any(axis=1))
        before = np.linalg.norm(skin.positions[touched] - skin.positions[MIDDLE], axis=1)
        after = np.linalg.norm((skin.positions + moved)[touched] - skin.positions[MIDDLE], axis=1)
        assert len(touched) > 8
        assert (after > before if reverse else after < before).all()
        assert np.abs(np.einsum("ij,ij->i", moved, skin.normals)).max() < 1e-5


def test_smoothing_evens_out_the_whole_field_and_erasing_leaves_nothing(
    project: Project, surface: PaintSurface
) -> None:
    count, rough = SIDE * SIDE, bumps(project)
    hill = np.zeros((count, 3))
    hill[:, 2] = project.face.skin.positions[:, 2] / 4
    layers = {"17": Layer(correction_of(rough), hill, 1.0, np.ones(count))}
    point = at_vertex(project.face.skin, MIDDLE)
    smooth = SculptStroke(work(project, surface, layers=layers), SculptBrush("smooth", 70.0, hardness=1.0))
    smooth.extend(point)
    after = smooth.corrections["17"].everywhere(count)
    assert roughness(project, hill + after) < 0.2 * roughness(project, hill + rough)
    erase = SculptStroke(work(project, surface, layers=layers), SculptBrush("erase", 70.0, hardness=1.0))
    erase.extend(point)
    assert not len(erase.corrections["17"].vertices)


def test_the_rim_stays_however_it_is_sculpted(project: Project, surface: PaintSurface) -> None:
    skin = project.face.skin
    face = replace(project.face, solved=skin.positions[skin.triangles][:, :, 1].max(axis=1) < 25)
    can = movable(face)
    stroke = SculptStroke(work(project, surface, movable=can), SculptBrush("raise", 70.0, hardness=1.0))
    stroke.extend(at_vertex(face.skin, MIDDLE))
    assert set(stroke.corrections["17"].vertices) == set(np.flatnonzero(can))
    held = np.unique(face.skin.triangles[~face.solved])
    assert not can[held].any()


def test_both_sides_are_mirror_images_and_the_midline_goes_straight(project: Project, surface: PaintSurface) -> None:
    skin, partners, unit = project.face.skin, project.face.mirror, project.units[0]
    count = len(partners)
    shares = side_shares(unit, skin)
    layers = {name: Layer(NOTHING, np.zeros((count, 3)), 1.0, share) for name, share in shares.items()}
    stroke = SculptStroke(work(project, surface, layers=layers, partners=partners), SculptBrush("pull", 22.0))
    place = at_vertex(skin, MIDDLE + 1)
    weights = np.zeros(count)
    weights[MIDDLE + 1] = 1.0
    stroke.take(place, weights)
    stroke.pull(np.array([2.0, 1.0, 0.0]))
    left, right = (stroke.corrections[name].everywhere(count) for name in unit.fields)
    np.testing.assert_allclose(right, left[partners] * [-1, 1, 1], atol=1e-6)
    middle = np.flatnonzero(partners == np.arange(count))
    assert np.abs((left + right)[middle, 0]).max() < 1e-6
    assert (left + right)[MIDDLE, 1] > 0.3
    assert np.linalg.norm((left + right)[MIDDLE + 1]) == pytest.approx(np.sqrt(5), rel=0.1)


@given(arrays(np.float64, 6, elements=st.floats(0, 1)), arrays(np.float64, (6, 3), elements=st.floats(-5, 5)))
def test_a_stroke_with_its_image_is_symmetric_and_never_more_than_either(weights: FloatArray, ways: FloatArray) -> None:
    partners = np.array([1, 0, 2, 4, 3, -1])
    both, way = on_both_sides(weights, ways, partners)
    paired = partners >= 0
    np.testing.assert_allclose(both[paired], both[partners[paired]], atol=1e-12)
    np.testing.assert_allclose(way[paired], way[partners[paired]] * [-1, 1, 1], atol=1e-9)
    assert (both <= np.maximum(weights, np.where(paired, weights[partners], 0)) + 1e-12).all()
    assert both[5] == pytest.approx(weights[5])


def test_corrections_mirror_join_and_split_without_loss(project: Project) -> None:
    count = SIDE * SIDE
    layer = correction_of(bumps(project))
    twice = mirrored(mirrored(layer, project.face.mirror), project.face.mirror)
    assert twice.vertices.tobytes() == layer.vertices.tobytes()
    assert np.array_equal(twice.moved, layer.moved)
    both = joined(layer, replace(layer, amount=0.5), count)
    np.testing.assert_allclose(both.moved, 1.5 * layer.moved, rtol=1e-5)
    chin = project.units[2]
    assert not chin.paired
    assert joined(replace(layer, moved=layer.moved * 90), replace(layer, moved=layer.moved * 90), count).largest < 180
    sides = halved({"17": layer}, replace(chin, paired=True), project.face.skin)
    np.testing.assert_allclose(summed(sides, ("17L", "17R"), count)[layer.vertices], layer.moved, atol=1e-6)


def test_a_shifted_pose_is_that_of_the_corrected_field_and_goes_back(project: Project, solution: Solution) -> None:
    layer = correction_of(bumps(project))
    weight = 0.7
    shown = Corrector()(solution, replace(project, corrections={"12L": layer}))
    wanted = Superposition(project.face, shown.basis)
    wanted.pose({"12L": weight})
    posed = Superposition(project.face, solution.basis)
    posed.pose({"12L": weight})
    before = posed.points.copy(), posed.normals.copy()
    sampler = correction_sampler(project.face, solution.basis.display)
    posed.shift(sampler.change(layer.vertices, weight * layer.moved))
    np.testing.assert_allclose(posed.points, wanted.points, atol=1e-4)
    np.testing.assert_allclose(posed.normals, wanted.normals, atol=1e-4)
    posed.settle()
    np.testing.assert_allclose(posed.points, before[0], atol=ROUNDED)
    np.testing.assert_allclose(posed.normals, before[1], atol=ROUNDED)


@pytest.mark.parametrize("wrong", [{"mode": "melt"}, {"radius": 0.0}, {"strength": 2.0}, {"hardness": -1.0}])
def test_an_impossible_brush_is_refused(wrong: dict[str, object]) -> None:
    with pytest.raises(PaintError):
        SculptBrush(**{"mode": "pull", "radius": 9.0, **wrong})  # type: ignore[arg-type]


def test_sides_share_out_all_of_it(project: Project) -> None:
    unit: ActionUnit = project.units[0]
    shares = side_shares(unit, project.face.skin)
    np.testing.assert_allclose(sum(shares.values()), 1.0)
    left = project.face.skin.positions[:, 0] >= 12
    assert (shares["12L"][left] == 1).all()

"""What is picked is what is seen: the nearest skin on the ray, from outside."""

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.muscle_pulls import MusclePulls
from tests.ui.sitter import OPEN, sitter, studio, weights
from ui.viewport.pick import first_hit, ray_through, skin_vertex

SQUARE = np.array([[0, 0, 0], [1, 0, 0], [1, 1, 0], [0, 1, 0]], dtype=np.float32)
HALVES = np.array([[0, 1, 2], [0, 2, 3]])
inside = st.floats(0.01, 0.99)


@given(inside, inside)
def test_a_ray_hits_where_it_points(x: float, y: float) -> None:
    hit = first_hit(SQUARE, HALVES, np.array([x, y, 5.0]), np.array([0.0, 0, -1]))
    assert hit is not None
    assert hit.place == pytest.approx([x, y, 0.0], abs=1e-6)
    assert hit.barycentric.sum() == pytest.approx(1.0)
    assert hit.barycentric.min() >= -1e-6
    nearest = np.linalg.norm(SQUARE[HALVES[hit.triangle]] - hit.place, axis=1).argmin()
    distances = np.linalg.norm(SQUARE - hit.place, axis=1)
    assert distances[hit.point] <= distances[HALVES[hit.triangle][nearest]] + 0.3


def test_a_ray_beside_or_behind_hits_nothing() -> None:
    assert first_hit(SQUARE, HALVES, np.array([2.0, 0.5, 5]), np.array([0.0, 0, -1])) is None
    assert first_hit(SQUARE, HALVES, np.array([0.5, 0.5, -5]), np.array([0.0, 0, 1])) is None
    assert first_hit(SQUARE, HALVES, np.array([0.5, 0.5, 5]), np.array([0.0, 0, 1])) is None


def test_the_nearer_of_two_sheets_is_hit() -> None:
    two = np.concatenate([SQUARE, SQUARE + np.float32([0, 0, 2])])
    hit = first_hit(two, np.concatenate([HALVES, HALVES + 4]), np.array([0.3, 0.2, 5.0]), np.array([0.0, 0, -1]))
    assert hit is not None
    assert hit.place[2] == pytest.approx(2.0)


@pytest.mark.parametrize("name", ["nose_tip", "pogonion", "cheek_L", "cheek_R", "glabella", "upper_vermilion"])
@pytest.mark.parametrize("pose", [{}, OPEN], ids=["neutral", "open"])
def test_a_landmark_is_picked_where_it_is_seen_in_any_pose(name: str, pose: dict[str, float]) -> None:
    project, _ = sitter()
    scene = studio().scene
    scene.look_from("front")
    scene.pose(weights(**pose))
    assert scene.figure is not None
    display = scene.figure.posed.basis.display
    corner = np.flatnonzero(display.barycentric.max(axis=1) > 1 - 1e-6)
    of = project.face.skin.triangles[display.elements[corner], display.barycentric[corner].argmax(axis=1)]
    place = scene.figure.posed.points[corner[of == project.face.landmarks[name]][0]].copy()
    scene.renderer.SetWorldPoint(*place, 1.0)
    scene.renderer.WorldToDisplay()
    x, y, _ = scene.renderer.GetDisplayPoint()
    hit = scene.pick(x, y)
    scene.pose({})
    assert hit is not None
    assert np.linalg.norm(hit.place - place) < 0.5
    assert skin_vertex(project.face, display, hit) in (
        project.face.landmarks[name],
        *project.face.skin.triangles[display.elements[hit.point]],
    )


def test_the_backdrop_is_nothing() -> None:
    scene = studio().scene
    scene.look_from("front")
    assert scene.pick(3, 3) is None
    assert scene.muscle_at(3, 3) is None


@pytest.mark.parametrize(
    ("brow", "above", "muscle"),
    [
        ("brow_inner_L", 12.0, "frontalis_medialis_L"),
        ("brow_inner_L", 30.0, "frontalis_medialis_L"),
        ("brow_mid_R", 12.0, "frontalis_lateralis_R"),
        ("brow_mid_R", 30.0, "frontalis_lateralis_R"),
    ],
)
def test_on_the_forehead_frontalis_lies_under_the_pointer(brow: str, above: float, muscle: str) -> None:
    """It moves the skin at the brow alone, and lies above that."""
    project, _ = sitter()
    place = project.face.skin.positions[project.face.landmarks[brow]] + np.array([0, above, 0])
    vertex = int(project.face.skin.tree.query(place)[1])
    found = MusclePulls().strongest(project, vertex)
    assert found is not None
    assert found.key == muscle


@pytest.mark.parametrize(("place", "group"), [("brow_inner", "brow"), ("pogonion", "chin")])
def test_the_muscle_under_the_pointer_is_one_that_pulls_there(place: str, group: str) -> None:
    project, _ = sitter()
    scene = studio().scene
    scene.look_from("front")
    landmarks = project.face.landmarks
    vertex = landmarks.get(place, landmarks.get(f"{place}_L"))
    scene.renderer.SetWorldPoint(*(project.face.skin.positions[vertex] + np.array([0, 4, 0])), 1.0)
    scene.renderer.WorldToDisplay()
    x, y, _ = scene.renderer.GetDisplayPoint()
    origin, along = ray_through(scene.renderer, x, y)
    assert np.linalg.norm(along) == pytest.approx(1.0)
    assert along[2] < -0.9
    assert origin[2] > 100
    muscle = scene.muscle_at(x, y)
    assert muscle is not None
    assert muscle.group == group

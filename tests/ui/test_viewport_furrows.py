"""Skin that is pushed together folds: in lines across the forehead, between the brows, beside the eyes, on the nose."""

import numpy as np
import pytest

from facemodel.actions import Expression
from facemodel.cache import solve_cached
from facemodel.face import Face
from facemodel.faces import face_keys, load_face
from facemodel.projects import new_project
from facemodel.superposition import Superposition
from ui.viewport.folding import Folding
from ui.viewport.furrows import FOREHEAD, Furrow, furrows
from ui.viewport.look import look_of

RAISED = {"1L": 1.0, "1R": 1.0, "2L": 1.0, "2R": 1.0}
FROWN = {"4L": 1.0, "4R": 1.0}

DEEP, FAINT = 0.4, 0.1
"""Depths of furrows that anybody sees, and that nobody does."""


class Furrowed:
    """A face whose furrows are read near its landmarks."""

    def __init__(self, key: str) -> None:
        project = new_project(key)
        self.face = project.face
        self.posed = Superposition(project.face, solve_cached(project).basis)
        self._folding = Folding(self.posed, furrows(project.face))

    def depth(self, expression: Expression, place: np.ndarray, near: float = 9.0) -> float:
        """How deep the deepest furrow is within some millimetres of a place (3,) at rest."""
        self.posed.pose(expression)
        self._folding.follow()
        rest = self.posed.basis.display.points
        return float(self._folding.depth[np.linalg.norm(rest - place, axis=1) < near].max())

    def at(self, *names: str) -> np.ndarray:
        """The middle (3,) of some landmarks."""
        return np.mean([self.face.skin.positions[self.face.landmarks[name]] for name in names], axis=0)

    @property
    def forehead(self) -> np.ndarray:
        return self.at("brow_mid_L", "brow_mid_R") + np.array([0.0, FOREHEAD[0] + FOREHEAD[1], 0.0])

    @property
    def between_brows(self) -> np.ndarray:
        return self.at("brow_inner_L", "brow_inner_R")

    def beside_eye(self, side: str) -> np.ndarray:
        return self.at(f"eye_outer_{side}") + np.array([10.0 if side == "L" else -10.0, 0.0, -4.0])


@pytest.fixture(scope="module", params=face_keys())
def furrowed(request: pytest.FixtureRequest) -> Furrowed:
    return Furrowed(request.param)


def test_a_face_at_rest_has_no_furrows(furrowed: Furrowed) -> None:
    assert furrowed.depth({}, furrowed.between_brows, near=200.0) == 0.0


def test_raised_brows_furrow_the_forehead_rather_than_what_is_between_them(furrowed: Furrowed) -> None:
    assert furrowed.depth(RAISED, furrowed.forehead, near=35.0) > DEEP
    between = furrowed.between_brows
    assert furrowed.depth(RAISED, between, near=4.0) < furrowed.depth(FROWN, between, near=4.0)


def test_drawn_brows_furrow_what_is_between_them_and_smooth_the_forehead(furrowed: Furrowed) -> None:
    assert furrowed.depth(FROWN, furrowed.between_brows) > DEEP
    assert furrowed.depth(FROWN, furrowed.forehead + np.array([0.0, 6.0, 0.0])) < FAINT


@pytest.mark.parametrize("side", "LR")
def test_a_raised_cheek_furrows_beside_its_own_eye(furrowed: Furrowed, side: str) -> None:
    other = "R" if side == "L" else "L"
    assert furrowed.depth({f"6{side}": 1.0}, furrowed.beside_eye(side)) > DEEP / 2
    assert furrowed.depth({f"6{side}": 1.0}, furrowed.beside_eye(other)) < FAINT


def test_a_furrow_deepens_with_the_slider_and_goes_with_it(furrowed: Furrowed) -> None:
    depths = [furrowed.depth(dict.fromkeys(FROWN, share), furrowed.between_brows) for share in (0.3, 0.6, 1.0, 0.0)]
    assert depths[0] < depths[1] < depths[2]
    assert depths[3] == 0.0


def test_furrows_are_drawn_where_the_picture_has_lines(furrowed: Furrowed) -> None:
    look = look_of(furrowed.face)
    assert look.detail is not None
    assert look.furrows is not None
    image = look.detail.image
    height, width = image.shape[:2]
    chart, coordinates = furrowed.face.chart, look.detail.coordinates
    # Texture coordinates are the chart, moved and scaled.
    scale = np.ptp(coordinates, axis=0) / np.ptp(chart, axis=0)
    deepest = max(look.furrows.lines, key=lambda line: float(line.depth.max()))
    middle = (deepest.points[len(deepest.points) // 2] - chart[0]) * scale + coordinates[0]
    x, y = (middle * [width, height]).astype(int)
    assert image[y, x, 3] > 150
    assert np.median(image[..., 3]) == 0, "most skin never folds"


def test_everybody_furrows_in_lines_of_their_own_which_are_always_the_same() -> None:
    own = {key: furrows(load_face(key)).lines for key in face_keys()}
    for key, lines in own.items():
        again = furrows(load_face(key)).lines
        assert len(again) == len(lines)
        for line, same in zip(lines, again, strict=True):
            np.testing.assert_array_equal(line.points, same.points)
            np.testing.assert_array_equal(line.depth, same.depth)
    deepest = {tuple(line.depth.max() for line in lines) for lines in own.values()}
    assert len(deepest) == len(own)


def test_lines_beside_the_eyes_bend_fade_at_both_ends_and_differ_from_side_to_side(furrowed: Furrowed) -> None:
    left, right = beside_eye(furrowed.face, "L"), beside_eye(furrowed.face, "R")
    for line in left + right:
        assert np.linalg.norm(np.diff(line.points, axis=0), axis=1).sum() > np.linalg.norm(np.ptp(line.points, axis=0))
        assert line.depth[[0, -1]].max() < 0.05 < 0.2 < line.depth.max()
    assert min(len(left), len(right)) >= 4
    assert {line.depth.max() for line in left}.isdisjoint({line.depth.max() for line in right})


def beside_eye(face: Face, side: str) -> list[Furrow]:
    """The lines that lie within some millimetres of the outer corner of an eye."""
    corner = face.chart[face.landmarks[f"eye_outer_{side}"]]
    return [each for each in furrows(face).lines if np.linalg.norm(each.points - corner, axis=1).max() < 30.0]

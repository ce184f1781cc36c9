"""A mouth that is opened all the way is an oval in a cheek that is drawn long, on every face."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.spatial import ConvexHull

from benchmarks.opening import folded, incisors_apart
from facemodel.face import Face
from facemodel.faces import face_keys
from facemodel.openings import mouth_of
from facemodel.projects import new_project
from facemodel.solve import solve_project
from facemodel.superposition import Superposition
from fem.types import FloatArray
from tests.facemodel.places import points_of_vertices

STRETCH = 27
"""The action unit that opens a mouth all the way."""

WIDE = 40.0
"""Millimetres between the incisors of a mouth that is opened all the way."""

ROUND, FULL = 0.835, 0.955
"""Four pi of the outline's area by the square of its length from the front: a circle has 1, a square 0.79;
and the share of its convex hull that it fills."""

HOLLOW = 10.0
"""Millimetres by which skin between the corner of the mouth and the angle of the jaw sinks in at most: 5.5 on a
sculpted face, 12 where the tissue of the cheek was held to its volume."""

CHEEK = np.linspace(0.2, 1.0, 9)
"""Shares of the way from a corner of the mouth to the angle of the jaw."""

Opened = tuple[Face, Superposition]


@pytest.fixture(scope="module", params=face_keys())
def opened(request: pytest.FixtureRequest) -> Opened:
    shipped = new_project(request.param)
    stretch = tuple(unit for unit in shipped.units if unit.number == STRETCH)
    posed = Superposition(shipped.face, solve_project(replace(shipped, units=stretch)).basis)
    posed.pose({str(STRETCH): 1.0})
    return shipped.face, posed


def skin_of(face: Face, posed: Superposition) -> FloatArray:
    return posed.points[points_of_vertices(face, posed.basis.display)].astype(np.float64)


def test_it_is_40_mm_wide_between_the_incisors(opened: Opened) -> None:
    assert incisors_apart(*opened) >= WIDE


def test_no_skin_folds_over(opened: Opened) -> None:
    _, posed = opened
    assert folded(posed) == 0


def test_from_the_front_it_is_an_oval(opened: Opened) -> None:
    face, posed = opened
    mouth = mouth_of(face)
    assert mouth is not None
    outline = skin_of(face, posed)[np.concatenate([mouth.upper, mouth.lower[-2:0:-1]])][:, :2]
    length = np.linalg.norm(outline - np.roll(outline, 1, axis=0), axis=1).sum()
    x, y = outline.T
    area = abs(x @ np.roll(y, -1) - y @ np.roll(x, -1)) / 2
    assert 4 * np.pi * area / length**2 > ROUND
    assert area > FULL * ConvexHull(outline).volume, "it has dents"


def test_the_cheek_beside_it_is_drawn_long_and_does_not_cave_in(opened: Opened) -> None:
    face, posed = opened
    rest = face.skin.positions
    outward = np.einsum("ij,ij->i", skin_of(face, posed) - rest, face.skin.normals)
    corner, angle = (rest[face.landmarks[f"{name}_L"]] for name in ("mouth_corner", "gonion"))
    places = corner + CHEEK[:, None] * (angle - corner)
    nearest = np.linalg.norm(rest[None] - places[:, None], axis=2).argmin(axis=1)
    assert outward[nearest].min() > -HOLLOW

"""The mouths of shipped faces are made so that their skin is smooth and their lips rest on each other."""

from collections.abc import Callable

import numpy as np
import pytest

from facemodel.contact.contact import live_at_rest
from facemodel.contact.mouth import lay_lips
from facemodel.face import Face
from facemodel.faces import face_keys
from facemodel.making.corners import crumpled, with_smooth_corners
from facemodel.making.fairing import Seam, with_fair_lips
from facemodel.mesh import Mesh
from facemodel.openings import Slit, mouth_of
from facemodel.sampling import ELEMENTS, display_surface, head_surface
from fem.types import FloatArray

EVERY_FACE = pytest.mark.parametrize("key", face_keys())
Shipped = Callable[[str], Face]

SEEN = 0.05
"""Millimetres by which lips may rest in each other: no more than the skin that contact keeps between them."""

GAPE = 0.2
"""Millimetres between lips at rest that are in each other's shade from the front."""

ABOUT = 7.0
"""Millimetres about a corner of the mouth."""


def slit_of(face: Face) -> Slit:
    slit = mouth_of(face)
    assert slit is not None
    return slit


def in_corners(face: Face, skin: Mesh) -> np.ndarray:
    """Which triangles (T,) lie about a corner of the mouth."""
    corners = skin.positions[list(slit_of(face).corners)]
    return np.linalg.norm(skin.positions[skin.triangles].mean(axis=1)[:, None] - corners, axis=2).min(axis=1) < ABOUT


def inner_vertex(face: Face) -> int:
    """A vertex of the skin next to the left corner of the mouth, on no edge."""
    rim = np.concatenate(face.skin.boundary_loops)
    away = np.linalg.norm(face.skin.positions - face.skin.positions[slit_of(face).corners[1]], axis=1)
    away[rim] = np.inf
    return int(away.argmin())


@EVERY_FACE
def test_no_skin_is_crumpled_in_the_corners(shipped: Shipped, key: str) -> None:
    face = shipped(key)
    assert not (crumpled(face.skin) & in_corners(face, face.skin)).any()


@EVERY_FACE
def test_lips_rest_on_each_other_and_neither_gape_nor_are_in_each_other(shipped: Shipped, key: str) -> None:
    face = shipped(key)
    display = display_surface(face, head_surface(face, ELEMENTS["hct12"]), 3)
    laid = lay_lips(face, display)
    assert laid is not None
    rows, pair = laid
    overlaps = pair.overlaps(live_at_rest(face, display)[rows])
    nearest = np.full(pair.upper.column.max() + 1, -np.inf)
    for lip, overlap in zip((pair.upper, pair.lower), overlaps, strict=True):
        np.maximum.at(nearest, lip.column, overlap)
    assert max(overlap.max() for overlap in overlaps) < SEEN
    middle = nearest[len(nearest) // 10 : -len(nearest) // 10]
    assert middle.min() > -GAPE


def test_a_fold_in_a_corner_is_smoothed_and_the_edges_of_the_lips_stay(face: Face) -> None:
    positions = face.skin.positions.copy()
    vertex = inner_vertex(face)
    ring = positions[np.unique(face.skin.triangles[(face.skin.triangles == vertex).any(axis=1)])]
    positions[vertex] += 2.5 * (ring.mean(axis=0) - positions[vertex]) + [0.0, 1.5, 0.0]
    folded = face.skin.moved(positions)
    assert (crumpled(folded) & in_corners(face, folded)).any()
    smooth = with_smooth_corners(folded, face.landmarks)
    assert not (crumpled(smooth) & in_corners(face, smooth)).any()
    rim = np.concatenate(face.skin.boundary_loops)
    assert np.array_equal(smooth.positions[rim], positions[rim])


def test_skin_that_is_not_crumpled_stays_as_it_is(face: Face) -> None:
    assert with_smooth_corners(face.skin, face.landmarks) is face.skin


def seam_of(face: Face) -> Seam:
    slit = slit_of(face)
    return Seam(face.skin.triangles, np.union1d(slit.upper, slit.lower), np.array(slit.corners))


def wavering(face: Face, seed: int) -> tuple[FloatArray, FloatArray]:
    """Lips that waver from vertex to vertex, and where they do: in the middle half of the mouth."""
    noise = np.random.default_rng(seed).normal(0.0, 0.2, face.skin.positions.shape)
    slit = slit_of(face)
    middle = np.concatenate([chain[len(chain) // 4 : -len(chain) // 4] for chain in (slit.upper, slit.lower)])
    return face.skin.positions + noise, middle


@pytest.mark.parametrize("seed", [1, 2])
def test_lips_that_waver_are_faired(face: Face, seed: int) -> None:
    shape, middle = wavering(face, seed)
    base = face.skin.positions
    before, after = (np.linalg.norm((s - base)[middle]) for s in (shape, with_fair_lips(base, shape, seam_of(face))))
    assert after < 0.85 * before


def test_another_place_of_a_head_and_what_is_far_from_its_lips_is_not_touched(face: Face) -> None:
    base = face.skin.positions
    moved = base + np.array([3.0, -2.0, 5.0])
    assert with_fair_lips(base, moved, seam_of(face)) == pytest.approx(moved, abs=1e-6)
    shape, _ = wavering(face, 3)
    faired = with_fair_lips(base, shape, seam_of(face))
    far = np.linalg.norm(base[:, None] - base[seam_of(face).rim], axis=2).min(axis=1) > ABOUT
    corners = list(slit_of(face).corners)
    assert np.array_equal(faired[far], shape[far])
    assert np.array_equal(faired[corners], shape[corners])

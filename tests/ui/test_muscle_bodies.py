"""Muscles as they are drawn: bodies under the skin that end where their fibres do, whole and smooth."""

import numpy as np
import pytest

from facemodel.laying.places import ahead, outside_head
from facemodel.mesh import Mesh
from facemodel.muscles.models import MODELS
from facemodel.projects import new_project
from ui.viewport.overlays.bands import Band, band

OUTSIDE = 0.04
"""Share of a body that may look out: the levator of a lid ends in a lid that is no thicker than it."""


@pytest.fixture(scope="module")
def bodies():
    project = new_project()
    skull = project.face.skull
    return project, {
        muscle.key: (muscle, band(muscle, project.face.skin, (skull.cranium, skull.mandible)))
        for muscle in project.muscles
        if muscle.fibres or muscle.ring is not None
    }


def test_bodies_lie_under_the_skin(bodies):
    project, laid = bodies
    for key, (_, body) in laid.items():
        points = body.points.reshape(-1, 3)
        assert np.isfinite(points).all(), key
        assert outside_head(project.face, points).mean() < OUTSIDE, key


def test_a_body_ends_at_the_ends_of_its_fibres(bodies):
    _, laid = bodies
    for key, (muscle, body) in laid.items():
        if MODELS[muscle.model].geometry != "fibres":
            continue
        for column, end in ((0, "origin"), (-1, "attachment")):
            ends = np.array([getattr(fibre, end) for fibre in muscle.fibres])
            middle = body.points[:, column].mean(axis=0)
            assert np.linalg.norm(ends - middle, axis=1).min() < 9.0, key


def edges_open(body: Band) -> int:
    """How many edges of a body belong to one triangle alone."""
    sides = np.sort(body.triangles[:, [0, 1, 1, 2, 2, 0]].reshape(-1, 2), axis=1)
    _, count = np.unique(sides, axis=0, return_counts=True)
    return int((count == 1).sum())


def test_bodies_are_tubes_open_at_their_ends_alone(bodies):
    _, laid = bodies
    for key, (_, body) in laid.items():
        rows = body.points.shape[0]
        assert edges_open(body) == (0 if body.closed else 2 * rows), key


def test_a_muscle_is_thickest_in_its_belly_and_has_fibres_along_it(bodies):
    _, laid = bodies
    for key in ("zygomaticus_major_L", "frontalis_medialis_R"):
        _, body = laid[key]
        outer, inner = body.points[4], body.points[-4]
        thick = np.linalg.norm(outer - inner, axis=1)
        assert thick[len(thick) // 2] > 2 * max(thick[0], thick[-1]), key
        length = body.grain[..., 0]
        assert (np.diff(length, axis=1) > 0).all(), key


def test_a_body_is_lifted_over_the_bone_that_its_straight_fibres_go_through(bodies):
    project, laid = bodies
    skull = project.face.skull
    _, body = laid["frontalis_lateralis_L"]
    middle = body.points[:9, 6:-6].reshape(-1, 3)
    normal = (
        Mesh(body.points.reshape(-1, 3), body.triangles).normals.reshape(body.points.shape)[:9, 6:-6].reshape(-1, 3)
    )
    sign = np.sign((normal @ np.array([0.3, 0.2, 1.0])).mean())
    above = ahead(skull.cranium, middle + 20 * sign * normal, -sign * normal)
    assert (above[np.isfinite(above)] > 20 - 1.0).mean() > 0.9

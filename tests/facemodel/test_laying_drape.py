"""Rings on the skin: near it, and as smooth as muscles are where it has holes and folds."""

import numpy as np
import pytest

from facemodel.laying.drape import draped, of_sector, ring_line, ring_turns
from facemodel.laying.places import ahead, nearest
from facemodel.muscles.models import MODELS
from facemodel.project import Project

TURN = 45.0
"""Degrees by which a smooth line of 64 places never turns from one to the next."""


def rings(project: Project):
    return [muscle for muscle in project.muscles if MODELS[muscle.model].geometry == "ring" and muscle.model != "lid"]


def test_every_shipped_ring_lies_on_the_skin_without_a_kink(project: Project) -> None:
    skin = project.face.skin
    for muscle in rings(project):
        line = ring_line(muscle.ring, skin)
        own = line[of_sector(muscle.ring, ring_turns())]
        assert np.median(nearest(skin, own)[2]) < 1.5, muscle.key
        step = np.diff(np.concatenate([line, line[:2]]), axis=0)
        step /= np.linalg.norm(step, axis=1, keepdims=True)
        turn = np.degrees(np.arccos(np.clip(np.einsum("ij,ij->i", step[1:], step[:-1]), -1, 1)))
        assert turn.max() < TURN, muscle.key


def test_a_ring_across_an_open_mouth_bridges_it(project: Project) -> None:
    mouth = next(muscle for muscle in project.muscles if muscle.key == "orbicularis_oris_marginal")
    ring = mouth.ring
    inner = np.full((64, 2), 0.3)
    line = draped(ring, ring_turns(), inner, project.face.skin)
    out = np.cross(ring.long_axis, ring.short_axis)
    height = (line - ring.centre) @ out / np.linalg.norm(out)
    assert np.ptp(height) < 12.0, "no place falls into the mouth"


def test_distances_ahead_are_those_to_the_first_surface(project: Project) -> None:
    skin = project.face.skin
    tip = skin.positions[project.face.landmarks["nose_tip"]]
    before = np.tile(tip + np.array([0, 0, 25.0]), (2, 1))
    found = ahead(skin, before, np.array([[0.0, 0, -1], [0, 0, 1]]))
    assert found[0] == pytest.approx(25.0, abs=0.3)
    assert np.isinf(found[1])

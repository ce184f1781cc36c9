"""The area and the arrows that follow a muscle in the viewport."""

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest

from facemodel.laying.influence import arrows, coarse, influence, side_by_side
from facemodel.loads import bone_forces
from facemodel.muscles import Muscle
from facemodel.muscles.models import MODELS
from facemodel.project import Project
from tests.facemodel.skin import sizes


def named(project: Project, key: str) -> Muscle:
    return next(muscle for muscle in project.muscles if muscle.key == key)


def test_influence_is_a_share_of_the_largest_and_does_not_depend_on_strength(project: Project) -> None:
    muscle, face = named(project, "zygomaticus_major_L"), project.face
    area = influence(muscle, face)
    assert area.shape == (len(face.skin.positions),)
    assert area.min() == 0.0
    assert area.max() == 1.0
    assert influence(replace(muscle, strength=0.0), face) == pytest.approx(area)
    assert area[face.landmarks["mouth_corner_L"]] > 0.6
    assert area[face.landmarks["glabella"]] == 0.0


def test_a_coarse_muscle_shows_the_same_area(project: Project) -> None:
    muscle = named(project, "frontalis_lateralis_R")
    assert coarse(muscle).count < muscle.count
    assert influence(coarse(muscle), project.face) == pytest.approx(influence(muscle, project.face), abs=0.15)


def test_arrows_are_the_forces_that_are_solved(project: Project) -> None:
    muscle, face = named(project, "risorius_L"), project.face
    shown = arrows(muscle, face)
    forces = bone_forces(muscle, face)
    assert shown.action == "force"
    assert np.array_equal(shown.vectors, forces[shown.vertices])
    assert np.array_equal(shown.places, face.skin.positions[shown.vertices])
    hidden = np.delete(sizes(forces), shown.vertices)
    assert hidden.max() <= 1e-3 * sizes(forces).max()
    assert arrows(replace(muscle, model="cosine"), face).action == "displacement"
    assert len(arrows(replace(muscle, strength=0.0), face).vertices) == 0


def test_models_side_by_side_work_on_the_same_muscle(project: Project) -> None:
    compared = side_by_side(named(project, "zygomaticus_major_L"))
    assert list(compared) == ["fibre", "quadrilateral", "cosine"]
    areas = [influence(muscle, project.face) for muscle in compared.values()]
    for first, second in pairwise(areas):
        assert first @ second / np.linalg.norm(first) / np.linalg.norm(second) > 0.6, "they act on the same skin"
    assert {MODELS[model].action for model in compared} == {"force", "displacement"}

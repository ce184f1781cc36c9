"""Muscles carried to other heads: by landmarks, and as text from one project to another."""

import json
from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from facemodel.atlas import read_atlas
from facemodel.errors import MuscleError
from facemodel.face import Face
from facemodel.laying.checks import complaints
from facemodel.laying.clipboard import muscles_from, muscles_text
from facemodel.laying.collection import added
from facemodel.laying.fitting import fitted_atlas
from facemodel.laying.places import kind_of_place, nearest
from facemodel.laying.sides import mirrored, partner
from facemodel.laying.warp import control_points, landmark_warp
from facemodel.muscles import Muscle
from facemodel.project import Project
from fem.types import FloatArray
from resources import resource
from tests.io.small_project import identical

MEAN_ERROR = 2.0
"""Millimetres between attachments that are carried and those that words place on the head itself: words tell offsets
from the nearest landmark alone, and warps bend between all of them."""

AT_BONE = 3.0
"""Millimetres from the bone to which a warp by landmarks of the skin carries half of what lay at the bone."""


def attachments(muscles: tuple[Muscle, ...]) -> FloatArray:
    return np.array([fibre.attachment for muscle in muscles for fibre in muscle.fibres])


def origins(muscles: tuple[Muscle, ...]) -> FloatArray:
    return np.array([fibre.origin for muscle in muscles for fibre in muscle.fibres])


def mean_error(found: FloatArray, expected: FloatArray) -> float:
    return float(np.linalg.norm(found - expected, axis=1).mean())


@given(st.integers(0, 10**6))
def test_a_warp_of_an_affine_change_is_that_change(seed: int) -> None:
    rng = np.random.default_rng(seed)
    matrix = Rotation.random(random_state=seed).as_matrix() @ np.diag(rng.uniform(0.5, 2.0, 3))
    shift = rng.uniform(-30, 30, 3)
    source = {f"place {k}": rng.uniform(-80, 80, (2, 3)) for k in range(12)}
    warp = landmark_warp(source, {name: pair @ matrix.T + shift for name, pair in source.items()})
    points = rng.uniform(-100, 100, (20, 3))
    assert warp(points) == pytest.approx(points @ matrix.T + shift, abs=1e-6)
    assert warp.scale(points[0]) == pytest.approx(np.cbrt(np.linalg.det(matrix)), rel=1e-6)


def test_a_warp_takes_landmarks_to_landmarks(shipped: Callable[[str], Face]) -> None:
    source, target = control_points(shipped("ada")), control_points(shipped("dayo"))
    warp = landmark_warp(source, target)
    for name in ("nose_tip", "mouth_corner_L", "gonion_R", "eyeball L"):
        assert warp(source[name]) == pytest.approx(target[name], abs=1e-6)


def test_too_few_landmarks_or_flat_ones_are_refused(face: Face) -> None:
    places = control_points(face)
    few = dict(list(places.items())[:3])
    with pytest.raises(MuscleError, match="share 3 landmarks and at least 4 are needed"):
        landmark_warp(places, few)
    flat = {name: pair * [1, 1, 0] for name, pair in places.items()}
    with pytest.raises(MuscleError, match="landmarks of the new head lie in a plane"):
        landmark_warp(places, flat)


def test_an_atlas_fitted_to_its_own_head_is_itself(project: Project) -> None:
    again = fitted_atlas(project.muscles, project.face, project.face)
    assert attachments(again) == pytest.approx(attachments(project.muscles), abs=1e-3)
    assert origins(again) == pytest.approx(origins(project.muscles), abs=0.5)
    assert [muscle.width for muscle in again] == pytest.approx([muscle.width for muscle in project.muscles])


@pytest.mark.parametrize("key", ["ben", "chen", "dayo"])
def test_an_atlas_carried_to_another_head_lands_where_that_heads_own_lies(
    project: Project, key: str, shipped: Callable[[str], Face]
) -> None:
    target = shipped(key)
    own = read_atlas(resource("atlas", f"{key}.json")).muscles
    carried = fitted_atlas(project.muscles, project.face, target)
    assert [muscle.key for muscle in carried] == [muscle.key for muscle in own]
    error = mean_error(attachments(carried), attachments(own))
    assert error < MEAN_ERROR
    assert error < 0.4 * mean_error(attachments(project.muscles), attachments(own)), "far better than as they were"
    assert mean_error(origins(carried), origins(own)) < 2 * MEAN_ERROR
    rings = [(a.ring, b.ring) for a, b in zip(carried, own, strict=True) if a.ring is not None and b.ring is not None]
    assert max(float(np.linalg.norm(a.centre - b.centre)) for a, b in rings) < 5.0
    widths = [a.width / b.width for a, b in zip(carried, own, strict=True)]
    assert 0.7 < min(widths) < max(widths) < 1.3


def test_carried_muscles_lie_on_what_they_lay_on_and_can_be_used(
    project: Project, shipped: Callable[[str], Face]
) -> None:
    target = shipped("dayo")
    carried, away = fitted_atlas(project.muscles, project.face, target), []
    for muscle in carried:
        assert complaints(muscle, target) == ()
        for fibre in muscle.fibres:
            assert kind_of_place(target, fibre.attachment)[0] in ("vertex", "skin")
            bones = (target.skull.cranium, target.skull.mandible)
            away.append(min(nearest(bone, fibre.origin)[2][0] for bone in bones))
        other = partner(carried, muscle)
        if muscle.side == "L":
            assert other is not None
            assert identical(mirrored(muscle, target), other), "partners stay in step"
    assert np.median(away) < AT_BONE


def test_muscles_copied_within_a_project_come_back_bit_by_bit(project: Project) -> None:
    text = muscles_text(project.muscles, project.face)
    assert identical(muscles_from(text, project.face), project.muscles)
    more, keys = added(project, muscles_from(text, project.face)[:2])
    assert keys == ("frontalis_medialis_2_L", "frontalis_medialis_2_R")
    assert len(more.muscles) == len(project.muscles) + 2


def test_muscles_pasted_on_another_head_are_fitted_to_it(project: Project, shipped: Callable[[str], Face]) -> None:
    target = shipped("ben")
    pasted = muscles_from(muscles_text(project.muscles, project.face), target)
    own = read_atlas(resource("atlas", "ben.json")).muscles
    assert mean_error(attachments(pasted), attachments(own)) < MEAN_ERROR
    for muscle in pasted:
        assert complaints(muscle, target) == ()


def tampered(project: Project, change: Callable[[dict[str, object]], object]) -> str:
    document = json.loads(muscles_text(project.muscles[:2], project.face))
    change(document)
    return json.dumps(document)


@pytest.mark.parametrize("text", ["", "hello", "[1, 2]", "{}", "[" * 100_000, '{"format": "risorius"}'])
def test_any_other_text_is_no_copy_of_muscles(face: Face, text: str) -> None:
    with pytest.raises(MuscleError, match="no copy of muscles; copy some muscles first"):
        muscles_from(text, face)


@pytest.mark.parametrize(
    ("change", "says"),
    [
        (lambda d: d["muscles"][0].update(width=0), r"muscles\[0\].width is not valid.*copy them again"),
        (lambda d: d["muscles"][1].update(model="rope"), r"muscles\[1\].model"),
        (lambda d: d.update(muscles=[]), "muscles"),
        (lambda d: d["muscles"][0].update(fibres=[]), "has no fibre"),
        (lambda d: d.update(schema=99), "newer version.*update Risorius"),
        (lambda d: d.update(places={}), "share 0 landmarks"),
    ],
)
def test_damaged_text_is_refused_with_its_place(
    project: Project, change: Callable[[dict[str, object]], object], says: str
) -> None:
    with pytest.raises(MuscleError, match=says):
        muscles_from(tampered(project, change), project.face)

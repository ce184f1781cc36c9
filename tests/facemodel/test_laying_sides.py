"""Left and right: mirror images, partners in step, muscles that act alike on both sides."""

from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from facemodel.face import Face
from facemodel.laying.fibres import bent, with_end
from facemodel.laying.places import kind_of_place, nearest
from facemodel.laying.sides import linked, mirrored, partner, put, side_of, unlinked
from facemodel.muscles import Muscle
from facemodel.muscles.models import muscle_action
from facemodel.project import Project
from tests.facemodel.skin import by, sizes
from tests.io.small_project import identical


def named(project: Project, key: str) -> Muscle:
    return next(muscle for muscle in project.muscles if muscle.key == key)


def close(first: Muscle, second: Muscle, within: float) -> bool:
    """Whether two muscles are the same but for some millimetres."""
    plain = {"fibres": (), "ring": None}
    ends = [np.array([p for fibre in each.fibres for p in fibre.points]) for each in (first, second)]
    same = identical(replace(first, **plain), replace(second, **plain)) and ends[0].shape == ends[1].shape
    if first.ring is not None and second.ring is not None:
        rings = [np.array([r.centre, r.long_axis, r.short_axis, r.sector]) for r in (first.ring, second.ring)]
        same = same and bool(np.abs(rings[0] - rings[1]).max() < within)
    return same and (not ends[0].size or bool(np.abs(ends[0] - ends[1]).max() < within))


def test_every_shipped_muscle_mirrored_is_its_shipped_partner(project: Project) -> None:
    for muscle in project.muscles:
        other = partner(project.muscles, muscle)
        assert (other is None) == (muscle.side == "M")
        if other is not None:
            # Between two feet of springs on one place of the bone either may be the one that is found.
            assert close(mirrored(muscle, project.face), other, 0.5), muscle.key


@settings(max_examples=30)
@given(st.integers(0, 10**6))
def test_mirrored_twice_is_the_muscle_itself(project: Project, seed: int) -> None:
    rng = np.random.default_rng(seed)
    muscle = project.muscles[rng.integers(len(project.muscles))]
    if muscle.fibres:
        muscle = with_end(muscle, 0, "attachment", project.face.skin.positions[rng.integers(3000)])
        muscle = with_end(muscle, 0, "origin", rng.uniform(-60, 60, 3))
        muscle, _ = bent(muscle, 0, rng.uniform(-60, 60, 3))
    twice = mirrored(mirrored(muscle, project.face), project.face)
    assert close(twice, muscle, 2e-3)
    if muscle.fibres:
        assert np.array_equal(twice.fibres[0].attachment, muscle.fibres[0].attachment), "vertices come back exactly"


@pytest.mark.parametrize(
    "key",
    ["zygomaticus_major_L", "orbicularis_oculi_orbitalis_L", "levator_palpebrae_R", "orbicularis_oris_peripheral_L"],
)
def test_a_mirror_image_acts_as_the_mirror_image(project: Project, key: str) -> None:
    face = project.face
    muscle = named(project, key)
    action, image = muscle_action(muscle, face), muscle_action(mirrored(muscle, face), face)
    assert image[face.mirror] == pytest.approx(action * [-1, 1, 1], abs=1e-3 * sizes(action).max())


def test_a_muscle_across_the_midline_stays_on_it(project: Project) -> None:
    image = mirrored(named(project, "procerus"), project.face)
    assert image.side == "M"
    assert image.key == "procerus"


def test_a_partner_follows_until_it_is_unlinked(project: Project) -> None:
    face, left = project.face, named(project, "risorius_L")
    moved = with_end(left, 0, "origin", left.fibres[0].origin + by(1.0, 2.0, 3.0))
    both = put(project.muscles, moved, face)
    assert len(both) == len(project.muscles)
    right = next(muscle for muscle in both if muscle.key == "risorius_R")
    assert right.fibres[0].origin == pytest.approx(moved.fibres[0].origin * [-1, 1, 1])
    apart = unlinked(both, right)
    again = put(apart, replace(next(m for m in apart if m.key == "risorius_L"), width=20.0), face)
    widths = {muscle.key: muscle.width for muscle in again if muscle.name == "risorius"}
    assert widths == {"risorius_L": 20.0, "risorius_R": right.width}
    together = linked(again, next(m for m in again if m.key == "risorius_L"), face)
    assert all(muscle.linked and muscle.width == 20.0 for muscle in together if muscle.name == "risorius")


@given(st.sampled_from(["width", "kappa", "strength"]), st.floats(0.5, 5.0))
def test_only_the_two_partners_change(project: Project, name: str, value: float) -> None:
    after = put(project.muscles, replace(named(project, "corrugator_R"), **{name: value}), project.face)
    changed = [m.key for m, before in zip(after, project.muscles, strict=True) if m is not before]
    assert changed == ["corrugator_L", "corrugator_R"]
    assert all(getattr(muscle, name) == value for muscle in after if muscle.name == "corrugator")


def test_a_muscle_lies_on_the_side_of_its_ends(face: Face) -> None:
    nose, cheek = (face.skin.positions[face.landmarks[name]] for name in ("nose_tip", "cheek_R"))
    assert side_of(face, cheek, nose) == "R"
    assert side_of(face, cheek * [-1, 1, 1]) == "L"
    assert side_of(face, nose, nose - by(0.0, 10.0, 10.0)) == "M"


def test_on_a_face_without_symmetry_a_mirrored_muscle_still_lies_on_its_skin_and_bone(project: Project) -> None:
    skin = project.face.skin
    # One half is stretched, so that no vertex lies across from another, and the mirror map is gone.
    positions = skin.positions * np.where(skin.positions[:, :1] > 0, [1.15, 1.0, 1.0], [1.0, 1.0, 1.0])
    face = replace(
        project.face, skin=replace(skin, positions=positions), mirror=np.arange(len(positions), dtype=np.int64)
    )
    muscle = named(project, "zygomaticus_major_R")
    image = mirrored(muscle, face)
    assert image.side == "L"
    for fibre in image.fibres:
        assert fibre.attachment[0] > 10
        assert kind_of_place(face, fibre.attachment)[0] in ("vertex", "skin")
        assert min(nearest(mesh, fibre.origin)[2][0] for mesh in (face.skull.cranium, face.skull.mandible)) < 1.5, (
            "on the bone"
        )

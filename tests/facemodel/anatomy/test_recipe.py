"""Anatomy in words: what is written is read, what it says is laid on every head, and its numbers keep their bounds."""

import json
from collections.abc import Callable
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from facemodel.anatomy.files import read_anatomy, shipped_anatomy, write_anatomy
from facemodel.anatomy.muscles import make_muscles
from facemodel.anatomy.paint import Canvas, head_margins, paint
from facemodel.anatomy.recipe import Anatomy
from facemodel.atlas import read_atlas
from facemodel.calibration.knobs import KAPPAS, MOST_TURNS, WIDTHS, knobs, turned
from facemodel.errors import ProjectError
from facemodel.face import Face
from facemodel.faces import face_keys
from facemodel.laying.places import nearest
from facemodel.muscles import Muscle
from facemodel.muscles.models import MODELS
from resources import resource

RECIPE = shipped_anatomy()
KNOBS = knobs(RECIPE)
ROUNDED = 2e-3
"""Millimetres to which the shipped heads and atlases are kept."""
AT_BONE = 1.0
"""Millimetres from the bone within which half of the origins lie: each is a mean of the feet of three springs, and in a
cheek one of these may stand on the other jaw."""

FARTHEST_OFF = 6.0
"""Millimetres from the bone within which all of them lie: where skin is steep its springs do not stand upright."""

ARISE_IN_SKIN = ("platysma",)
"""Muscles that arise in the fascia of the neck, and at no bone."""

ACROSS = 0.5
"""Millimetres by which bone under a place beside the midline lies across it."""

NEAREST = 0.2
"""Millimetres by which two places of skin differ that are equally near, on both sides of the midline."""


def laid(face: Face, anatomy: Anatomy = RECIPE) -> tuple[Muscle, ...]:
    return make_muscles(anatomy, face.skin, face.skull, face.landmarks, face.eyes)


def test_what_is_written_is_read(tmp_path: Path) -> None:
    write_anatomy(RECIPE, tmp_path / "anatomy.json")
    assert read_anatomy(tmp_path / "anatomy.json") == RECIPE


@pytest.mark.parametrize(
    ("change", "says"),
    [
        (lambda d: d["bands"][0].pop("width"), r"bands\.0\.width"),
        (lambda d: d["rings"][1].update(sector="middle"), r"rings\.1\.sector"),
        (lambda d: d["tissue"].update(stretching=1e300), r"tissue\.stretching is 1e\+300"),
        (lambda d: d["bands"][2]["courses"][0]["origin"].update(offset=[0, 0]), "offset"),
    ],
)
def test_a_damaged_recipe_is_refused_with_its_place(
    change: Callable[[dict[str, object]], object], says: str, tmp_path: Path
) -> None:
    path = tmp_path / "anatomy.json"
    write_anatomy(RECIPE, path)
    document = json.loads(path.read_text(encoding="utf-8"))
    change(document)
    path.write_text(json.dumps(document), encoding="utf-8")
    with pytest.raises(ProjectError, match=says):
        read_anatomy(path)


@pytest.mark.parametrize("key", face_keys())
def test_the_atlas_that_ships_is_what_the_recipe_lays(key: str, shipped: Callable[[str], Face]) -> None:
    own = read_atlas(resource("atlas", f"{key}.json")).muscles
    made = laid(shipped(key))
    assert [muscle.key for muscle in made] == [muscle.key for muscle in own]
    for one, other in zip(made, own, strict=True):
        assert (one.width, one.kappa, one.strength) == pytest.approx(
            (other.width, other.kappa, other.strength), rel=1e-3
        )
        for fibre, kept in zip(one.fibres, other.fibres, strict=True):
            assert fibre.points == pytest.approx(kept.points, abs=0.1)


@pytest.mark.parametrize("key", face_keys())
def test_the_tissue_that_ships_is_what_the_recipe_paints(key: str, shipped: Callable[[str], Face]) -> None:
    face = shipped(key)
    made = paint(
        RECIPE.tissue,
        Canvas(face.skin, face.landmarks, head_margins(face.skin)),
        face.skin,
        face.solved,
        face.landmarks,
    )
    for name in ("stiffness", "sliding", "volume", "stretching", "bending"):
        assert getattr(made, name) == pytest.approx(getattr(face.layers, name), rel=1e-2, abs=1e-6), name


def test_muscles_grow_with_the_head(face: Face) -> None:
    grown = replace(
        face,
        skin=face.skin.moved(1.2 * face.skin.positions),
        skull=replace(
            face.skull,
            anchors=1.2 * face.skull.anchors,
            cranium=face.skull.cranium.moved(1.2 * face.skull.cranium.positions),
            mandible=face.skull.mandible.moved(1.2 * face.skull.mandible.positions),
        ),
        eyes=tuple(replace(eye, centre=1.2 * eye.centre, radius=1.2 * eye.radius) for eye in face.eyes),
    )
    for one, other in zip(laid(face), laid(grown), strict=True):
        assert other.width == pytest.approx(1.2 * one.width)
        for fibre, larger in zip(one.fibres, other.fibres, strict=True):
            assert larger.points == pytest.approx(1.2 * fibre.points, abs=NEAREST)
        if one.ring is not None and other.ring is not None:
            assert other.ring.short_axis == pytest.approx(1.2 * one.ring.short_axis, abs=1e-6)


def test_origins_lie_at_the_bone_and_attachments_in_the_skin(face: Face) -> None:
    away = []
    for muscle in laid(face):
        for fibre in muscle.fibres:
            bones = (face.skull.cranium, face.skull.mandible)
            away.append(min(nearest(bone, fibre.origin)[2][0] for bone in bones))
            assert nearest(face.skin, fibre.attachment)[2][0] < ROUNDED
    assert np.median(away) < AT_BONE


@pytest.mark.parametrize("key", face_keys())
def test_every_muscle_arises_at_the_bone_of_its_own_side_and_a_fold_in_its_skin(
    key: str, shipped: Callable[[str], Face]
) -> None:
    face = shipped(key)
    for muscle in laid(face):
        out = {"L": 1.0, "R": -1.0}.get(muscle.side, 0.0)
        for fibre in muscle.fibres:
            under = (face.skull.cranium, face.skull.mandible)
            ground = (face.skin,) if MODELS[muscle.model].along_skin else under
            away = min(nearest(mesh, fibre.origin)[2][0] for mesh in ground)
            assert away < FARTHEST_OFF or muscle.name in ARISE_IN_SKIN, muscle.key
            for end in (fibre.origin, fibre.attachment):
                assert out * end[0] >= -ACROSS, muscle.key


@given(st.integers(0, len(KNOBS) - 1), st.floats(-MOST_TURNS, MOST_TURNS).filter(lambda x: abs(x) > 0.1))
def test_every_knob_turns_one_thing_within_its_bounds(number: int, steps: float) -> None:
    amounts = np.zeros(len(KNOBS))
    amounts[number] = steps
    other = turned(RECIPE, KNOBS, amounts)
    knob = KNOBS[number]
    changed = [new.name for old, new in zip(RECIPE.bands, other.bands, strict=True) if old != new]
    changed += [new.name for old, new in zip(RECIPE.rings, other.rings, strict=True) if old != new]
    assert set(changed) <= {knob.muscle}
    assert (other.tissue != RECIPE.tissue) == (not knob.muscle)
    for band in other.bands:
        assert WIDTHS[0] <= band.width <= WIDTHS[1]
        assert KAPPAS[0] <= band.kappa <= KAPPAS[1]
    assert turned(other, KNOBS, np.zeros(len(KNOBS))) == other

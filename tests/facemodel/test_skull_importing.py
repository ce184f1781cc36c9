"""Bone from elsewhere becomes the skull of a head: its springs end on it, and its jaw is found and cut out."""

from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest

from facemodel.errors import SkullError
from facemodel.face import Face, Skull
from facemodel.faces import load_face
from facemodel.io.bone_file import read_bone
from facemodel.mesh import Mesh
from facemodel.skull.depths import bone_depths, whole
from facemodel.skull.findings import findings
from facemodel.skull.fitting import bone_targets, fitted
from facemodel.skull.importing import skull_of
from facemodel.skull.jaw_proposal import proposed_jaw
from facemodel.skull.placement import carried
from facemodel.skull.registration import laid_on, proposed
from facemodel.system import solved_vertices

FACE = load_face("ada")
BONE = whole(FACE.skull)


def length(face: Face) -> np.ndarray:
    """Return the length of every main spring."""
    return np.linalg.norm(face.skull.anchors - face.skin.positions, axis=1)


def under(skull: Skull) -> Face:
    return replace(FACE, skull=skull)


def test_the_own_bone_is_the_own_skull_to_the_last_bit() -> None:
    made = skull_of(FACE, BONE, FACE.skull)
    assert np.array_equal(made.anchors, FACE.skull.anchors)
    assert np.array_equal(np.sort(made.mandible.positions, axis=0), np.sort(FACE.skull.mandible.positions, axis=0))
    assert len(made.cranium.triangles) == len(FACE.skull.cranium.triangles)


def test_springs_become_shorter_where_bone_lies_nearer_to_the_skin() -> None:
    swollen = Mesh(BONE.positions + 1.5 * BONE.normals, BONE.triangles)
    after = under(skull_of(FACE, swollen, FACE.skull))
    front = solved_vertices(FACE)
    shorter = (length(FACE) - length(after))[front]
    assert np.median(shorter) == pytest.approx(1.5, abs=0.3)
    assert (shorter > 0).mean() > 0.98


def test_a_jaw_is_proposed_where_the_other_skull_has_one() -> None:
    jaw = proposed_jaw(BONE, FACE.skull)
    own = np.arange(len(BONE.positions)) >= len(FACE.skull.cranium.positions)
    assert np.array_equal(jaw, own)
    cranium = proposed_jaw(FACE.skull.cranium, FACE.skull)
    assert cranium.mean() < 0.02


def test_bone_beside_the_head_and_bone_that_is_nowhere_are_refused() -> None:
    for places in (BONE.positions + 900.0, BONE.positions * np.nan):
        with pytest.raises(SkullError, match="would not lie in the head"):
            skull_of(FACE, Mesh(places, BONE.triangles), FACE.skull)


def test_a_real_skull_is_fitted_with_its_jaw_and_reported_where_it_comes_through(repository: Path) -> None:
    path = repository / "../shared/data/skull/skull.obj"
    if not path.exists():
        pytest.skip("There is no ../shared/data/skull/skull.obj here.")
    bone, wanted = read_bone(path).mesh, bone_targets(FACE)
    way = laid_on(bone, FACE.skull)
    fit = fitted(proposed(bone, way, wanted), wanted)
    assert fit.rms < 4.5
    assert fit.scale == pytest.approx([15.0, 15.0, 15.0], rel=0.06)
    after = under(skull_of(FACE, bone.moved(fit(bone.positions)), FACE.skull))
    chin = FACE.skin.positions[FACE.landmarks["pogonion"]]
    assert np.linalg.norm(after.skull.mandible.positions - chin, axis=1).min() < 15
    assert 0.05 < len(after.skull.mandible.triangles) / len(bone.triangles) < 0.25
    depths = bone_depths(after).depth[solved_vertices(FACE)]
    assert 4 < np.median(depths) < 12
    found = findings(after)
    assert bool(found.complaint) == bool(len(found.pierced))
    assert carried(bone.positions, way).shape == bone.positions.shape

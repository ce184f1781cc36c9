"""What every shipped individual must be to be solved, drawn and retargeted."""

from collections.abc import Callable

import numpy as np
import pytest
from scipy.sparse.csgraph import connected_components

from facemodel.chart import chart_figures
from facemodel.errors import UnknownNameError
from facemodel.face import Face
from facemodel.faces import DEFAULT_FACE, face_keys, load_face
from facemodel.making.lips import with_closed_lips
from facemodel.mesh import Mesh, submesh

EVERY_FACE = pytest.mark.parametrize("key", face_keys())
Shipped = Callable[[str], Face]

FOLDED = ("eye_", "upper_li", "lower_li", "mouth_corner", "ala", "tragus", "cupid")

CLOSED = 0.5
"""Millimetres that lips which rest on each other may move when they are closed once more."""

CARUNCLE = 6.0
"""Millimetres about the inner corner of the eye where the lids leave the eyeball."""


def solved_mesh(face: Face) -> Mesh:
    return submesh(face.skin, face.solved)[0]


def loops_of_eyes(face: Face) -> dict[str, np.ndarray]:
    """Return the boundary loops of the lids by side."""
    lids = [loop for loop in face.skin.boundary_loops if abs(face.skin.positions[loop, 0].mean()) > 10]
    return {"L" if face.skin.positions[loop, 0].mean() > 0 else "R": loop for loop in lids}


def test_four_individuals_ship_and_the_default_leads() -> None:
    assert len(face_keys()) == 4
    assert face_keys()[0] == DEFAULT_FACE


def test_an_unknown_face_is_answered_with_those_there_are() -> None:
    with pytest.raises(UnknownNameError, match=r"no face “nobody”.*ada"):
        load_face("nobody")


@EVERY_FACE
@pytest.mark.parametrize("part", ["whole", "solved"])
def test_the_skin_is_one_manifold_piece_with_a_mouth_two_eyes_and_a_rim(shipped: Shipped, key: str, part: str) -> None:
    face = shipped(key)
    mesh = face.skin if part == "whole" else solved_mesh(face)
    directed = np.concatenate([mesh.triangles[:, [k, (k + 1) % 3]] for k in range(3)])
    assert len(np.unique(directed, axis=0)) == len(directed), "an edge is used twice in one direction"
    assert connected_components(mesh.adjacency, directed=False)[0] == 1
    assert len(mesh.boundary_loops) == 4
    on_loops = np.concatenate(mesh.boundary_loops)
    assert len(np.unique(on_loops)) == len(on_loops), "two loops touch"
    euler = len(mesh.positions) - len(mesh.edges) + len(mesh.triangles)
    assert euler == 2 - 4, "a sphere with four holes"
    mouth = min(mesh.boundary_loops, key=lambda loop: np.abs(mesh.positions[loop] - _mouth(face)).max())
    assert np.abs(mesh.positions[mouth, 0].mean()) < 0.5
    assert set(loops_of_eyes(face)) == {"L", "R"}


def _mouth(face: Face) -> np.ndarray:
    return face.skin.positions[[face.landmarks["mouth_corner_L"], face.landmarks["mouth_corner_R"]]].mean(axis=0)


@EVERY_FACE
def test_a_head_has_the_size_of_a_head(shipped: Shipped, key: str) -> None:
    face = shipped(key)
    at = {name: face.skin.positions[vertex] for name, vertex in face.landmarks.items()}
    # Adult norms, generous: breadth of the head 140..170 with ears more, outer canthi 80..100, mouth 43..60,
    # nasion to menton 100..135, eyeball 11..16 in radius where lids rest on it.
    width = np.ptp(face.skin.positions[:, 0])
    assert 140 < width < 200
    assert 75 < np.linalg.norm(at["eye_outer_L"] - at["eye_outer_R"]) < 105
    assert 35 < np.linalg.norm(at["mouth_corner_L"] - at["mouth_corner_R"]) < 65
    assert 90 < np.linalg.norm(at["nasion"] - at["menton"]) < 140
    assert all(11 < eye.radius < 16.5 for eye in face.eyes)
    assert at["nose_tip"][2] > at["tragus_L"][2]
    assert at["mouth_corner_L"][0] > 0 > at["mouth_corner_R"][0]
    assert at["supraglabella"][1] > at["nose_tip"][1] > at["chin"][1]


@EVERY_FACE
def test_individuals_share_their_topology(shipped: Shipped, key: str) -> None:
    first, face = shipped(DEFAULT_FACE), shipped(key)
    assert np.array_equal(face.skin.triangles, first.skin.triangles)
    assert np.array_equal(face.solved, first.solved)
    assert np.array_equal(face.mirror, first.mirror)
    assert np.array_equal(face.uv, first.uv)
    assert face.landmarks == first.landmarks
    assert [(p.name, p.kind, p.carrier) for p in face.parts] == [(p.name, p.kind, p.carrier) for p in first.parts]
    assert all(
        np.array_equal(own.mesh.triangles, other.mesh.triangles)
        for own, other in zip(face.parts, first.parts, strict=True)
    )


def test_individuals_are_different_people(shipped: Shipped) -> None:
    shapes = [shipped(key).skin.positions for key in face_keys()]
    for k, one in enumerate(shapes):
        for other in shapes[:k]:
            assert np.linalg.norm(one - other, axis=1).mean() > 2.0


@EVERY_FACE
def test_the_mirror_is_an_involution_across_the_midline(shipped: Shipped, key: str) -> None:
    face = shipped(key)
    count = len(face.mirror)
    assert np.array_equal(face.mirror[face.mirror], np.arange(count))
    reflected = face.skin.positions[face.mirror] * [-1, 1, 1]
    assert np.abs(reflected - face.skin.positions).max() < 0.01
    solved = face.skin.triangles[face.solved]
    assert {tuple(sorted(t)) for t in solved.tolist()} == {tuple(sorted(t)) for t in face.mirror[solved].tolist()}
    for name, vertex in face.landmarks.items():
        other = name[:-1] + {"L": "R", "R": "L"}[name[-1]] if name.endswith(("_L", "_R")) else name
        assert face.mirror[vertex] == face.landmarks[other]


@EVERY_FACE
def test_the_chart_has_no_flip_and_little_stretch(shipped: Shipped, key: str) -> None:
    face = shipped(key)
    whole = chart_figures(face.skin, face.chart)
    solved = chart_figures(Mesh(face.skin.positions, face.skin.triangles[face.solved]), face.chart)
    assert whole.flips == solved.flips == 0
    # A scanned face with holes came to 5.5 by the same method; ears make these a little worse.
    assert solved.worst < 8.0
    assert solved.p95 < 4.0
    assert 1.0 < whole.p95 < whole.worst < 10.0


@EVERY_FACE
def test_what_the_skin_carries_hangs_on_it(shipped: Shipped, key: str) -> None:
    face = shipped(key)
    carried = [part for part in face.parts if part.carrier == "skin"]
    assert {part.kind for part in carried} == {"lining", "socket", "lashes"}
    for part in carried:
        assert part.shares.sum(axis=1) == pytest.approx(1.0, abs=1e-6)
        assert part.shares.min() >= 0.0
        assert part.anchors.shape == part.shares.shape
        solved = np.unique(face.skin.triangles[face.solved])
        assert np.isin(part.anchors, solved).all(), "a part must not hang on the held rest"


@EVERY_FACE
def test_pockets_close_the_openings_of_the_skin(shipped: Shipped, key: str) -> None:
    face = shipped(key)
    openings = [set(loop.tolist()) for loop in face.skin.boundary_loops]
    for part in (p for p in face.parts if p.kind in {"lining", "socket"}):
        rim = np.concatenate(part.mesh.boundary_loops)
        alone = part.shares[rim].argmax(axis=1)
        assert part.shares[rim, alone] == pytest.approx(1.0)
        vertices = part.anchors[rim, alone]
        assert part.mesh.positions[rim] == pytest.approx(face.skin.positions[vertices], abs=1e-4)
        assert set(vertices.tolist()) in openings


@EVERY_FACE
def test_rigid_parts_lie_in_the_mouth(shipped: Shipped, key: str) -> None:
    face = shipped(key)
    parts = {part.name: part for part in face.parts}
    assert parts["teeth-upper"].carrier == "skull"
    assert parts["teeth-lower"].carrier == parts["tongue"].carrier == "jaw"
    upper, lower = (parts[name].mesh.positions for name in ("teeth-upper", "teeth-lower"))
    assert upper[:, 1].mean() > lower[:, 1].mean()
    mouth = face.skin.positions[face.landmarks["mouth_corner_L"]]
    lips = face.skin.positions[face.landmarks["upper_lip_incisor"]]
    for name in ("teeth-upper", "teeth-lower", "tongue"):
        points = parts[name].mesh.positions
        assert points[:, 2].max() < lips[2], "behind the lips"
        assert np.abs(points[:, 1].mean() - mouth[1]) < 15.0
        assert np.abs(points[:, 0]).max() < 40.0


@EVERY_FACE
def test_lids_rest_on_the_eyeballs(shipped: Shipped, key: str) -> None:
    face = shipped(key)
    assert [eye.side for eye in face.eyes] == ["L", "R"]
    for eye in face.eyes:
        margin = face.skin.positions[loops_of_eyes(face)[eye.side]]
        inner = margin[np.abs(margin[:, 0]).argmin()]
        resting = margin[np.linalg.norm(margin - inner, axis=1) > CARUNCLE]
        gap = np.linalg.norm(resting - eye.centre, axis=1) - eye.radius
        assert np.abs(gap).max() < 1.5, "a lid floats before the eye or sinks into it"
        assert np.abs(gap.mean()) < 0.6
        front = eye.centre + np.array([0, 0, eye.radius])
        brow = face.skin.positions[face.landmarks[f"brow_mid_{eye.side}"]]
        assert front[2] < brow[2] + 2.0, "the eye bulges"


@EVERY_FACE
def test_the_skull_lies_under_the_skin_with_a_jaw_that_hinges_before_the_ear(shipped: Shipped, key: str) -> None:
    face = shipped(key)
    skull = face.skull
    reach = skull.anchors - face.skin.positions
    depth = -np.einsum("ij,ij->i", reach, face.skin.normals)
    # Edges of lids, lips and nostrils are folded back and look away from the bone; named places do not.
    named = [vertex for name, vertex in face.landmarks.items() if not name.startswith(FOLDED)]
    assert depth[named].min() > 0.5
    assert depth[named].max() < 30.0
    assert np.linalg.norm(reach, axis=1).max() < 40.0
    assert skull.jawbone.min() >= 0.0
    assert skull.jawbone.max() <= 1.0
    assert skull.jawbone[face.landmarks["menton"]] > 0.9
    assert skull.jawbone[face.landmarks["glabella"]] < 0.01
    right, left = skull.jaw.axis
    assert left == pytest.approx(right * [-1, 1, 1], abs=0.5)
    tragus = face.skin.positions[face.landmarks["tragus_L"]]
    assert np.linalg.norm(left - tragus) < 35.0


@EVERY_FACE
def test_painted_tissue_is_stiffness_and_symmetric(shipped: Shipped, key: str) -> None:
    face = shipped(key)
    layers = face.layers
    for painted in (layers.stretching, layers.bending, layers.stiffness):
        assert np.isfinite(painted).all()
        assert painted.min() >= 0.0
        assert painted[face.mirror] == pytest.approx(painted, rel=5e-3, abs=1e-9)
    solved = np.unique(face.skin.triangles[face.solved])
    assert layers.stretching[solved].min() > 0.0
    assert layers.bending[solved].min() > 0.0


@EVERY_FACE
def test_it_says_where_it_comes_from(shipped: Shipped, key: str) -> None:
    face = shipped(key)
    assert face.title
    assert "MakeHuman" in face.provenance
    assert "CC0" in face.provenance


@pytest.mark.parametrize("key", ["ada", "chen"])
def test_lips_that_rest_on_each_other_are_left_so_when_a_face_is_made(key: str, shipped: Shipped) -> None:
    face = shipped(key)
    moved = np.linalg.norm(with_closed_lips(face).skin.positions - face.skin.positions, axis=1)
    assert 0 < moved.max() < CLOSED

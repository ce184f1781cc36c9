"""The teeth of a skull are those that its face is drawn with, rooted in bone that follows them and nothing else."""

from collections.abc import Callable

import igl
import numpy as np
import pytest
from numpy.typing import NDArray

from facemodel.dental_arch import HEIGHTS, DentalArch
from facemodel.face import Face
from facemodel.faces import face_keys
from facemodel.making.skull import arches_of
from facemodel.making.skull.envelope import closed
from facemodel.making.skull.seated import before_row
from facemodel.making.skull.teeth import LOWER, RING, UPPER, tooth_row
from facemodel.mesh import Mesh, submesh
from facemodel.skull.spring_checks import spring_faults

EVERY_FACE = pytest.mark.parametrize("key", face_keys())
EVERY_ROW = pytest.mark.parametrize("row", ["upper", "lower"])
Shipped = Callable[[str], Face]
Floats = NDArray[np.float64]

WINDING = igl.SignedDistanceType.SIGNED_DISTANCE_TYPE_FAST_WINDING_NUMBER
CROWNS = len(tooth_row(UPPER).positions)


def parted(face: Face, row: str) -> tuple[Mesh, Mesh]:
    """Return the bone of a row without its crowns, and its crowns."""
    whole = face.skull.cranium if row == "upper" else face.skull.mandible
    of_crowns = (whole.triangles >= len(whole.positions) - CROWNS).all(axis=1)
    return submesh(whole, ~of_crowns)[0], submesh(whole, of_crowns)[0]


def depth_in(mesh: Mesh, points: Floats) -> Floats:
    return np.asarray(igl.signed_distance(points, mesh.positions, mesh.triangles, WINDING)[0])


def front_of(arch: DentalArch, height: float, inset: float = -0.3) -> Floats:
    """Return the fronts (14, 3) of the teeth in their middles at a share of their heights, from edge to gum."""
    middles = (arch.bounds[1:] + arch.bounds[:-1]) / 2
    edge, root, outward = arch.at(np.concatenate([-middles[::-1], middles]))
    up = (root - edge) / np.linalg.norm(root - edge, axis=1, keepdims=True)
    tall = np.array([*HEIGHTS[arch.jaw][::-1], *HEIGHTS[arch.jaw]])[:, None]
    return np.asarray(edge + height * tall * up + inset * outward)


@EVERY_FACE
@EVERY_ROW
def test_crowns_stand_where_the_teeth_of_the_face_are_drawn(shipped: Shipped, key: str, row: str) -> None:
    face = shipped(key)
    arch, crowns = arches_of(face.parts)[row], parted(face, row)[1]
    for height in (0.2, 0.4, 0.6):
        away = np.abs(depth_in(crowns, front_of(arch, height)))
        assert away.max() < 0.5, height
    drawn, own = arch.edge_at(0.0), crowns.positions[np.abs(crowns.positions[:, 0]) < 4]
    front = own[own[:, 2] > drawn[2] - 4]
    tip = front[:, 1].min() if row == "upper" else front[:, 1].max()
    assert tip == pytest.approx(drawn[1], abs=0.5), "the edges of the incisors"


@EVERY_FACE
@EVERY_ROW
def test_every_crown_is_rooted_and_no_bone_stands_before_it(shipped: Shipped, key: str, row: str) -> None:
    face = shipped(key)
    bone, crowns = parted(face, row)
    necks = crowns.positions.reshape(14, -1, 3)[:, :RING].mean(axis=1)
    assert (depth_in(bone, necks) < -1.0).all()
    arch = arches_of(face.parts)[row]
    before = front_of(arch, 0.5, inset=0.8)
    assert (depth_in(bone, before) > 0).all()
    assert np.quantile(before_row(arch, bone.positions), 0.995) < 1.0


@EVERY_FACE
def test_no_spring_starts_in_the_teeth_or_goes_through_them(shipped: Shipped, key: str) -> None:
    face = shipped(key)
    assert not spring_faults(face, np.arange(len(face.skin.positions))).left_out.any()


@EVERY_FACE
def test_a_closed_jaw_is_nowhere_in_the_cranium(shipped: Shipped, key: str) -> None:
    face = shipped(key)
    assert depth_in(face.skull.cranium, face.skull.mandible.positions).min() > -1.0


@EVERY_FACE
@EVERY_ROW
def test_skin_covers_the_bone_about_the_teeth(shipped: Shipped, key: str, row: str) -> None:
    face = shipped(key)
    skin = closed(face.skin)
    bone = parted(face, row)[0]
    height, nearest, *_ = igl.signed_distance(bone.positions, skin.positions, skin.triangles, WINDING)
    assert height[nearest < len(face.skin.triangles)].max() < -0.2


@EVERY_FACE
def test_chin_cheek_bones_and_joints_do_not_follow_the_teeth(shipped: Shipped, key: str) -> None:
    face = shipped(key)
    both = Mesh(
        np.concatenate([face.skull.cranium.positions, face.skull.mandible.positions]),
        np.concatenate(
            [face.skull.cranium.triangles, face.skull.mandible.triangles + len(face.skull.cranium.positions)]
        ),
    )
    for name in ("menton", "pogonion", "gonion_L", "zygion_R", "inferior_malar_L", "suborbital_R"):
        vertex = face.landmarks[name]
        wanted = np.linalg.norm(face.skull.anchors[vertex] - face.skin.positions[vertex])
        assert abs(depth_in(both, face.skin.positions[[vertex]])[0]) == pytest.approx(wanted, abs=2.0), name


def test_rows_of_the_measured_head_have_as_many_crowns_as_are_drawn() -> None:
    assert len(tooth_row(LOWER).positions) == CROWNS
    assert all(len(row.teeth) == len(HEIGHTS["upper"]) for row in (UPPER, LOWER))

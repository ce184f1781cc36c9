"""Skulls are read from the files of many programs; what cannot be one is refused in one sentence."""

from pathlib import Path

import numpy as np
import pytest
import trimesh

from facemodel.errors import ProjectError
from facemodel.faces import load_face
from facemodel.io.bone_file import LARGEST_FILE, SUFFIXES, read_bone
from facemodel.laying.places import nearest
from facemodel.mesh import Mesh
from facemodel.skull.depths import whole
from facemodel.skull.mending import USEFUL

BONE = whole(load_face("ada").skull)
HEADER = "ply\nformat ascii 1.0\nelement vertex {0}\nproperty float x\nproperty float y\nproperty float z\n"
HEADER += "element face {1}\nproperty list uchar int vertex_indices\nend_header\n"


def written(mesh: Mesh | trimesh.Trimesh, path: Path) -> Path:
    made = trimesh.Trimesh(mesh.positions, mesh.triangles, process=False) if isinstance(mesh, Mesh) else mesh
    made.export(path)
    return path


def solid(mesh: Mesh) -> trimesh.Trimesh:
    return trimesh.Trimesh(mesh.positions, mesh.triangles, process=False)


@pytest.mark.parametrize("suffix", SUFFIXES)
def test_a_skull_is_the_same_surface_from_every_kind_of_file(tmp_path: Path, suffix: str) -> None:
    bone = read_bone(written(BONE, tmp_path / f"skull{suffix}"))
    assert len(bone.mesh.triangles) == len(BONE.triangles)
    assert len(bone.mesh.positions) == len(BONE.positions)
    assert solid(bone.mesh).is_watertight
    assert solid(bone.mesh).volume == pytest.approx(solid(BONE).volume, rel=1e-4)
    assert bone.account == "14 960 triangles"


def test_a_skull_inside_out_or_turned_at_random_is_turned_outside_out(tmp_path: Path) -> None:
    for share in (1.0, 0.3):
        turned = np.random.default_rng(0).random(len(BONE.triangles)) < share
        triangles = np.where(turned[:, None], BONE.triangles[:, ::-1], BONE.triangles)
        bone = read_bone(written(Mesh(BONE.positions, triangles), tmp_path / "turned.ply"))
        assert solid(bone.mesh).volume == pytest.approx(solid(BONE).volume, rel=1e-4)


def test_holes_are_closed_and_specks_left_out_and_both_are_told(tmp_path: Path) -> None:
    open_ = BONE.positions[BONE.triangles].mean(axis=1)[:, 1] > BONE.positions[:, 1].min() + 4
    speck = trimesh.creation.icosphere(1, 0.4).apply_translation([0, 300, 0])
    made = trimesh.util.concatenate([trimesh.Trimesh(BONE.positions, BONE.triangles[open_], process=False), speck])
    bone = read_bone(written(made, tmp_path / "open.stl"))
    assert solid(bone.mesh).is_watertight
    assert bone.mesh.positions[:, 1].max() < 200
    assert bone.holes >= 1
    assert bone.specks == 1
    assert "1 speck left out" in bone.account
    assert "closed" in bone.account


def test_a_fine_skull_is_reduced_and_keeps_its_shape(tmp_path: Path) -> None:
    fine = solid(BONE).subdivide()
    bone = read_bone(written(fine, tmp_path / "fine.ply"))
    assert USEFUL * 0.9 < len(bone.mesh.triangles) <= USEFUL
    assert "59 840 triangles, reduced to 30 000" in bone.account
    assert solid(bone.mesh).is_watertight
    assert solid(bone.mesh).volume == pytest.approx(fine.volume, rel=0.01)
    assert np.quantile(nearest(BONE, bone.mesh.positions)[2], 0.99) < 0.5


def sheet() -> bytes:
    side = np.arange(20)
    x, y = (axis.ravel() for axis in np.meshgrid(side, side))
    corner = np.arange(400).reshape(20, 20)
    a, b, c, d = (part.ravel() for part in (corner[:-1, :-1], corner[:-1, 1:], corner[1:, 1:], corner[1:, :-1]))
    triangles = np.concatenate([np.column_stack([a, b, c]), np.column_stack([a, c, d])])
    mesh = trimesh.Trimesh(np.column_stack([x, y, 0.1 * np.sin(x)]), triangles, process=False)
    return bytes(mesh.export(file_type="stl"))


def short(kind: str) -> bytes:
    data = solid(BONE).export(file_type=kind)
    return (data.encode() if isinstance(data, str) else bytes(data))[:100_000]


BAD = {
    "empty.obj": (b"", "the file is empty"),
    "blank.stl": (b"\n \n", "the file is empty"),
    "text.obj": (b"Dear reader\n", "has no triangles"),
    "text.ply": (b"Dear reader\n", "damaged or cut short"),
    "points.obj": (b"v 0 0 0\nv 1 0 0\nv 0 1 0\n", "has no triangles"),
    "one.obj": (b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "has 1 triangle and a skull has at least 200"),
    "corner.obj": (b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 9\n", "damaged or cut short"),
    "nowhere.obj": (b"v nan 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n", "has a corner that is nowhere"),
    "word.ply": ((HEADER.format(3, 1) + "0 0 0\n1 0 0\nx 1 0\n3 0 1 2\n").encode(), "damaged or cut short"),
    "promise.ply": (HEADER.format(10**12, 4).encode(), "should have 1000000000000 vertices and is shorter than that"),
    "short.ply": (short("ply"), "damaged or cut short"),
    "short.stl": (short("stl"), "should have 14960 triangles and is shorter than that"),
    "sheet.stl": (sheet(), "is an open sheet that encloses nothing"),
    "skull.blend": (b"BLENDER", "a skull is read from .obj, .ply, .stl files"),
}


@pytest.mark.parametrize("name", BAD)
def test_what_is_no_skull_is_refused_in_one_sentence(tmp_path: Path, name: str) -> None:
    data, says = BAD[name]
    path = tmp_path / name
    path.write_bytes(data)
    with pytest.raises(ProjectError) as caught:
        read_bone(path)
    sentence = str(caught.value)
    assert says in sentence
    assert str(path) in sentence
    assert sentence.endswith(".")
    assert "\n" not in sentence


def test_a_huge_file_is_refused_before_it_is_read(tmp_path: Path) -> None:
    path = tmp_path / "huge.stl"
    with path.open("wb") as stream:
        stream.truncate(LARGEST_FILE + 1)
    with pytest.raises(ProjectError, match="at most 256 MiB are read; reduce the mesh"):
        read_bone(path)


def test_a_skull_of_quadrangles_is_cut_into_triangles(tmp_path: Path) -> None:
    side = np.arange(24)
    turn, height = (axis.ravel() for axis in np.meshgrid(side, np.linspace(0, 20, 24)))
    ring = np.column_stack([np.cos(turn * np.pi / 12), height / 10, np.sin(turn * np.pi / 12)])
    corner = np.arange(24 * 24).reshape(24, 24)
    quads = np.stack([corner[:-1], np.roll(corner, -1, 1)[:-1], np.roll(corner, -1, 1)[1:], corner[1:]], axis=-1)
    lines = [f"v {x:.5f} {y:.5f} {z:.5f}" for x, y, z in ring]
    lines += ["f " + " ".join(str(k + 1) for k in quad) for quad in quads.reshape(-1, 4)]
    path = tmp_path / "tube.obj"
    path.write_text("\n".join(lines))
    bone = read_bone(path)
    assert bone.triangles == 2 * 23 * 24
    assert bone.holes == 2
    assert solid(bone.mesh).is_watertight
    assert solid(bone.mesh).volume == pytest.approx(2 * np.pi, rel=0.03)


def test_a_missing_file_and_a_folder_are_refused(tmp_path: Path) -> None:
    with pytest.raises(ProjectError, match="no such file"):
        read_bone(tmp_path / "none.obj")
    (tmp_path / "folder.obj").mkdir()
    with pytest.raises(ProjectError, match="it is a folder"):
        read_bone(tmp_path / "folder.obj")

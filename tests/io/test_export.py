"""What leaves the program is what it shows, read back by readers that know nothing of it."""

import io
import os
import subprocess
import sys
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import trimesh
from hypothesis import given
from hypothesis import strategies as st
from scipy.spatial.transform import Rotation

from facemodel.actions import ActionUnit, Expression
from facemodel.errors import ProjectError
from facemodel.eyeball import eyeball
from facemodel.io.export import EXPORTS, export_project
from facemodel.io.export.targets import target_weights, targets
from facemodel.kinematics import rig_of
from facemodel.motions import EyeMotion, HeadMotion
from facemodel.solve import solve_project
from facemodel.superposition import Superposition
from tests.io.glb_reader import Glb
from tests.io.small_project import small_project

LOOK = ActionUnit(61, "eyes turn left", "eyes", False, {}, 0.0, eyes=EyeMotion(turn=30.0, spread=5.0))
NOD = ActionUnit(54, "head down", "head", False, {}, 0.0, head=HeadMotion(lift=-20.0, forward=10.0))
SMALL = small_project()
PROJECT = replace(SMALL, units=(*SMALL.units, LOOK, NOD))
SOLUTION = solve_project(PROJECT)
NAMES = ["12", "12L", "12R", "18", "26"]
TARGETS = [*NAMES, "61"]


def exported(suffix: str, expression: Expression | None = None) -> bytes:
    project = PROJECT if expression is None else PROJECT.posed(expression)
    stream = io.BytesIO()
    EXPORTS[suffix].write(project, SOLUTION, stream)
    return stream.getvalue()


def posed(expression: Expression) -> Superposition:
    pose = Superposition(PROJECT.face, SOLUTION.basis, rig_of(PROJECT.units))
    pose.pose(expression)
    return pose


def test_npz_holds_the_neutral_skin_and_every_field() -> None:
    with np.load(io.BytesIO(exported(".npz")), allow_pickle=False) as arrays:
        assert sorted(arrays.files) == ["fields", "names", "neutral", "posed", "triangles"]
        neutral, triangles, names, fields = (arrays[k] for k in ("neutral", "triangles", "names", "fields"))
    assert (neutral.dtype, triangles.dtype, fields.dtype) == (np.float32, np.int32, np.float32)
    assert names.tolist() == NAMES
    assert neutral.shape == (81, 3)
    assert fields.shape == (5, 81, 3)
    assert triangles.max() == 80
    assert np.array_equal(fields[0], fields[1] + fields[2])
    assert np.abs(neutral + 0.7 * fields[3] - posed({"18": 0.7}).points).max() < 1e-5


def test_npz_holds_the_skin_as_it_is_seen() -> None:
    expression = {"12L": 0.8, "26": 0.5, "54": 0.7}
    with np.load(io.BytesIO(exported(".npz", expression)), allow_pickle=False) as arrays:
        seen = arrays["posed"]
    now = posed(expression)
    assert np.abs(seen - carried(now.stance.head, now.points)).max() < 1e-4
    assert np.abs(seen - now.points).max() > 5.0, "the head is held as the expression says"


def carried(motion: np.ndarray, points: np.ndarray) -> np.ndarray:
    return points @ motion[:3, :3].T + motion[:3, 3]


@pytest.mark.parametrize("expression", [{}, {"12L": 0.8, "26": 0.5}, {"61": 1.0, "54": 0.5, "26": 0.3}])
def test_obj_is_the_posed_face(expression: Expression) -> None:
    scene = trimesh.load_scene(
        io.BytesIO(exported(".obj", expression)), file_type="obj", process=False, split_objects=True
    )
    now = posed(expression)
    wanted = {"skin": now.points, **now.parts} | {
        f"eye-{side}": carried(motion, eyeball(eye).opaque[0].positions)
        for side, eye, motion in zip(("left", "right"), PROJECT.face.eyes, now.stance.eyes, strict=True)
    }
    assert set(scene.geometry) == set(wanted)
    for name, points in wanted.items():
        corners = carried(now.stance.head, np.asarray(points, dtype=float))[_triangles(name)]
        assert np.abs(scene.geometry[name].triangles - corners).max() < 2e-5


def _triangles(name: str) -> np.ndarray:
    if name == "skin":
        return SOLUTION.basis.display.triangles
    if name.startswith("eye"):
        return eyeball(PROJECT.face.eyes[0 if name.endswith("left") else 1]).opaque[0].triangles
    return next(part.mesh.triangles for part in PROJECT.face.parts if part.name == name)


def test_obj_has_normals_and_texture_coordinates_of_its_points() -> None:
    lines = exported(".obj").decode().splitlines()
    count = {kind: sum(line.startswith(f"{kind} ") for line in lines) for kind in ("v", "vn", "vt", "o")}
    assert count["v"] == count["vn"]
    assert count["vt"] == 81
    assert count["o"] == 6


def test_ply_is_the_posed_face_with_normals_and_colours() -> None:
    expression = {"12L": 0.8, "26": 0.5}
    mesh = trimesh.load_mesh(io.BytesIO(exported(".ply", expression)), file_type="ply", process=False)
    now = posed(expression)
    assert np.array_equal(mesh.vertices[:81].astype(np.float32), now.points)
    raw = mesh.metadata["_ply_raw"]["vertex"]["data"]
    normals = np.stack([raw[axis] for axis in ("nx", "ny", "nz")], axis=1).reshape(-1, 3)
    assert np.array_equal(normals[:81], now.normals)
    assert np.array_equal(mesh.faces[: len(SOLUTION.basis.display.triangles)], SOLUTION.basis.display.triangles)
    tail = np.concatenate([now.parts[part.name] for part in PROJECT.face.parts])
    assert np.array_equal(mesh.vertices[-len(tail) :].astype(np.float32), tail)
    assert len(np.unique(mesh.visual.vertex_colors[:81], axis=0)) == 1


def glb(expression: Expression | None = None) -> Glb:
    return Glb(exported(".glb", expression))


def test_glb_targets_are_named_alike_on_everything_that_moves() -> None:
    file = glb({})
    moving = {mesh["name"]: mesh for mesh in file.meshes.values() if "extras" in mesh}
    eyes = {f"{layer}-{side}" for layer in ("eye", "cornea") for side in ("left", "right")}
    assert moving.keys() == {"skin", "teeth-lower", "lashes"} | eyes
    for mesh in moving.values():
        assert mesh["extras"]["targetNames"] == [f"AU{name}" for name in TARGETS]
        assert [len(primitive["targets"]) for primitive in mesh["primitives"]] == [6]
        assert len(mesh["weights"]) == 6


@pytest.mark.parametrize(
    "expression", [{"26": 0.5}, {"12L": 0.7, "18": 0.9, "26": 0.6}, {"61": 0.5, "26": 0.2}, {"61": 1.0, "54": 1.0}]
)
def test_glb_is_what_is_seen_though_jaws_and_eyes_turn(expression: Expression) -> None:
    file, now = glb(expression), posed(expression)
    weights = file.meshes["skin"]["weights"]
    bent = "26" in expression or expression.get("61", 1.0) != 1.0
    assert ("posed" in file.meshes["skin"]["extras"]["targetNames"]) == bent
    assert np.abs(file.posed("skin", weights) - 0.001 * now.points).max() < 1e-5
    for name, points in now.parts.items():
        assert np.abs(file.posed(name, weights) - 0.001 * points).max() < 1e-5
    places = carried(now.stance.eyes[0], eyeball(PROJECT.face.eyes[0]).opaque[0].positions)
    assert np.abs(file.posed("eye-left", weights) - 0.001 * places).max() < 1e-5
    head, upright = (next(node for node in file.json["nodes"] if node["name"] == name) for name in ("head", "face"))
    turn = Rotation.from_quat(head.get("rotation", [0, 0, 0, 1])).as_matrix()
    assert turn == pytest.approx(now.stance.head[:3, :3], abs=1e-6)
    place = np.array(head["translation"]) + turn @ upright["translation"]
    assert place == pytest.approx(0.001 * now.stance.head[:3, 3], abs=1e-9)


@pytest.mark.parametrize(
    "expression", [{}, {"12L": 1.0}, {"12L": 0.6, "12R": 0.6, "18": 0.3}, {"12L": 0.2, "12R": 0.9}, {"26": 1.0}]
)
def test_glb_with_its_default_weights_is_the_posed_face_in_metres(expression: Expression) -> None:
    file, now = glb(expression), posed(expression)
    weights = file.meshes["skin"]["weights"]
    within = 1e-6 * (1 + len(expression)) + 1e-7
    assert np.abs(file.posed("skin", weights) - 0.001 * now.points).max() < within
    for name, points in now.parts.items():
        assert np.abs(file.posed(name, weights) - 0.001 * points).max() < within


def test_glb_jaw_runs_along_the_chord_of_its_turn() -> None:
    half = glb().posed("teeth-lower", [0, 0, 0, 0, 0.5])
    ends = [0.001 * posed({"26": weight}).parts["teeth-lower"] for weight in (0.0, 1.0)]
    assert np.abs(half - (ends[0] + ends[1]) / 2).max() < 1e-6


def test_glb_normals_turn_with_the_skin() -> None:
    file, now = glb(), posed({"18": 1.0})
    assert np.abs(file.posed("skin", [0, 0, 0, 1, 0, 0], "NORMAL") - now.normals).max() < 4e-3
    for mesh in file.meshes.values():
        normals = file.array(mesh["primitives"][0]["attributes"]["NORMAL"])
        assert np.abs(np.linalg.norm(normals, axis=1) - 1).max() < 1e-6


def test_glb_read_by_another_library_is_the_head_at_rest() -> None:
    scene = trimesh.load_scene(io.BytesIO(exported(".glb")), file_type="glb", process=False)
    assert {"skin", "eye-left", "cornea-right", "teeth-upper", "lashes"} <= set(scene.geometry)
    assert {"Sheet (made up)", "eyeball-left", "eyeball-right"} <= set(scene.graph.nodes)
    skin = scene.geometry["skin"]
    assert np.abs(skin.vertices - 0.001 * SOLUTION.basis.display.points).max() < 1e-7
    assert np.array_equal(skin.faces, SOLUTION.basis.display.triangles)
    uv = PROJECT.face.uv
    assert np.abs(np.ptp(skin.visual.uv, axis=0) - np.ptp(uv, axis=0)).max() < 1e-6
    assert scene.geometry["cornea-left"].visual.material.alphaMode == "BLEND"


@given(st.dictionaries(st.sampled_from(["12L", "12R", "18", "26"]), st.floats(0, 2)))
def test_the_weights_of_the_targets_add_up_to_the_expression(expression: Expression) -> None:
    shapes = targets(PROJECT.units, SOLUTION.basis)
    total: dict[str, float] = {}
    for shape, weight in zip(shapes, target_weights(expression, shapes), strict=True):
        for name in shape.fields:
            total[name] = total.get(name, 0.0) + weight
    assert total == {name: expression.get(name, 0.0) for name in ("12L", "12R", "18", "26")}


@pytest.mark.parametrize("suffix", EXPORTS)
def test_exporting_twice_gives_the_same_bytes(suffix: str) -> None:
    assert exported(suffix) == exported(suffix)


def test_a_suffix_without_a_format_is_named_with_those_there_are(tmp_path: Path) -> None:
    with pytest.raises(ProjectError, match=r"smile\.fbx.*\.glb, \.usdc, \.usda, \.npz, \.obj or \.ply"):
        export_project(PROJECT, SOLUTION, tmp_path / "smile.fbx")


LIMITED = """
import resource, sys
from pathlib import Path
from facemodel.errors import ProjectError
from facemodel.io.export import export_project
from tests.io.test_export import PROJECT, SOLUTION
resource.setrlimit(resource.RLIMIT_FSIZE, (4000, 4000))
for name in sys.argv[1:]:
    try:
        export_project(PROJECT, SOLUTION, Path(name))
    except ProjectError as error:
        print(error)
"""


@pytest.mark.skipif(os.name == "nt", reason="limits of POSIX systems")
def test_an_export_that_does_not_fit_leaves_the_previous_file(tmp_path: Path) -> None:
    paths = [tmp_path / f"smile{suffix}" for suffix in EXPORTS]
    for path in paths:
        path.write_text("precious")
    run = subprocess.run(
        [sys.executable, "-W", "error", "-c", LIMITED, *map(str, paths)],
        capture_output=True,
        text=True,
        check=True,
        cwd=Path.cwd(),
    )
    assert run.stderr == ""
    assert run.stdout.count("choose another disk") == len(EXPORTS)
    assert all(path.read_text() == "precious" for path in paths)
    assert len(os.listdir(tmp_path)) == len(EXPORTS)

"""A clip leaves as it is played: read back by readers of their own, every frame is where the editor has it."""

import io
import os
from dataclasses import replace
from pathlib import Path

import numpy as np
import pytest
import trimesh
from hypothesis import given
from hypothesis import strategies as st

from facemodel.animation.clip import STILL
from facemodel.errors import ProjectError
from facemodel.io.export import EXPORTS, Asked, export_project, export_sequence
from facemodel.io.export.fewest import farthest, fewest_shapes, fitted, from_nothing_to_one
from facemodel.io.export.performance import WITHIN, performance
from facemodel.solution import Cancelled
from tests.io.animated import PEAKS, PROJECT, SOLUTION, played, shown
from tests.io.glb_reader import Glb

FLOAT = 1e-3
"""Millimetres that float32 metres and what is left out of sparse targets may differ by."""


def glb(asked: Asked = Asked()) -> Glb:  # noqa: B008 - a frozen value
    stream = io.BytesIO()
    EXPORTS[".glb"].write(PROJECT, SOLUTION, stream, asked)
    return Glb(stream.getvalue())


@pytest.mark.parametrize("asked", [Asked(), Asked(shaping="clip"), Asked(rate=30.0, span=(0.25, 0.75))])
def test_glb_plays_every_frame_as_the_editor_shows_it(asked: Asked) -> None:
    file = glb(asked)
    clip = asked.take(PROJECT)
    assert clip is not None
    assert file.times == pytest.approx(np.arange(len(clip)) / clip.rate, abs=1e-6)
    for key, wanted in enumerate(shown(clip)):
        seen = file.playing(key)
        assert set(seen) == set(wanted)
        for name, places in wanted.items():
            assert np.abs(1000 * seen[name] - places).max() < WITHIN + FLOAT, (key, name)


def test_glb_turns_head_jaw_and_eyes_as_nodes() -> None:
    file = glb()
    nodes = [node["name"] for node in file.json["nodes"]]
    animation = file.json["animations"][0]
    moved = {(nodes[each["target"]["node"]], each["target"]["path"]) for each in animation["channels"]}
    assert {("head", "rotation"), ("head", "translation"), ("jaw", "rotation"), ("jaw", "translation")} <= moved
    assert {("eyeball-left", "rotation"), ("eyeball-right", "rotation")} <= moved
    assert ("eyeball-left", "translation") not in moved
    assert "targets" not in file.meshes["teeth-lower"]["primitives"][0]
    for channel in animation["channels"]:
        if channel["target"]["path"] == "rotation":
            turns = file.array(animation["samplers"][channel["sampler"]]["output"])
            assert np.abs(np.linalg.norm(turns, axis=1) - 1).max() < 1e-6
            assert ((turns[1:] * turns[:-1]).sum(axis=1) > 0).all()


def test_glb_has_the_units_that_move_by_name_and_corrections_beside() -> None:
    mesh = glb().meshes["skin"]
    names = mesh["extras"]["targetNames"]
    assert names[:2] == ["AU12L", "AU26"]
    assert len(names) > 2
    assert all(name.startswith("correction") for name in names[2:])


@pytest.mark.parametrize("asked", [Asked(), Asked(shaping="clip")])
def test_weights_stay_between_nothing_and_one(asked: Asked) -> None:
    """Blender cuts off what lies outside, and this clip goes beyond full strength."""
    assert PEAKS["12L"] > 1
    weights = performance(played(), SOLUTION.basis, asked).weights
    assert weights.min() >= 0
    assert weights.max() <= 1 + 1e-12


def test_shapes_made_for_the_clip_are_no_more_than_allowed() -> None:
    file = glb(Asked(shaping="clip", most=2))
    for mesh in file.meshes.values():
        assert all(len(primitive.get("targets", [])) <= 2 for primitive in mesh["primitives"])


def test_more_shapes_are_never_worse() -> None:
    apart = [performance(played(), SOLUTION.basis, Asked(shaping="clip", most=most)).apart for most in (1, 2, 3, 4)]
    assert apart == sorted(apart, reverse=True)
    assert apart[0] > WITHIN >= apart[-1]


def test_action_units_that_are_not_allowed_are_counted() -> None:
    with pytest.raises(ProjectError, match="moves 2 sides of action units, more than the 1 shapes"):
        glb(Asked(most=1))


def test_a_still_of_an_animated_face_is_the_still_of_the_face() -> None:
    for suffix in (".glb", ".usda"):
        asked, without = io.BytesIO(), io.BytesIO()
        EXPORTS[suffix].write(PROJECT, SOLUTION, asked, Asked(animated=False))
        EXPORTS[suffix].write(replace(PROJECT, animation=STILL), SOLUTION, without)
        assert asked.getvalue() == without.getvalue()


@pytest.mark.parametrize("suffix", [".obj", ".ply"])
def test_a_sequence_is_one_posed_face_for_each_frame(tmp_path: Path, suffix: str) -> None:
    assert export_sequence(PROJECT, SOLUTION, tmp_path / f"face{suffix}") == 13
    assert sorted(os.listdir(tmp_path)) == [f"face.{number:04}{suffix}" for number in range(1, 14)]
    for number, places in enumerate(shown(played()), start=1):
        mesh = trimesh.load_mesh(tmp_path / f"face.{number:04}{suffix}", process=False)
        solid = [points for name, points in places.items() if not name.startswith("cornea")]
        low, high = np.concatenate(solid).min(axis=0), np.concatenate(solid).max(axis=0)
        assert np.abs(mesh.bounds - [low, high]).max() < FLOAT
        if suffix == ".ply":
            assert np.abs(mesh.vertices[:81] - places["skin"]).max() < FLOAT
            normals = np.cross(*(mesh.triangles[:, k] - mesh.triangles[:, 0] for k in (1, 2)))[0]
            raw = mesh.metadata["_ply_raw"]["vertex"]["data"]
            given = np.array([raw[axis].ravel()[mesh.faces[0, 0]] for axis in ("nx", "ny", "nz")])
            assert normals @ given > 0.7 * np.linalg.norm(normals)


def test_formats_without_frames_and_faces_that_are_still_are_no_sequence(tmp_path: Path) -> None:
    with pytest.raises(ProjectError, match=r"holds all frames.*end in \.obj or \.ply"):
        export_sequence(PROJECT, SOLUTION, tmp_path / "face.glb")
    with pytest.raises(ProjectError, match="nothing moves in this project"):
        export_sequence(replace(PROJECT, animation=STILL), SOLUTION, tmp_path / "face.obj")
    with pytest.raises(ProjectError, match="let the range end after its begin"):
        export_sequence(PROJECT, SOLUTION, tmp_path / "face.obj", Asked(span=(2.0, 1.0)))
    assert os.listdir(tmp_path) == []


@pytest.mark.parametrize("name", ["face.glb", "face.usdc", "face.obj"])
@pytest.mark.parametrize("calls", [1, 8])
def test_a_cancelled_export_leaves_the_one_before_and_nothing_else(tmp_path: Path, name: str, calls: int) -> None:
    write = export_sequence if name.endswith(".obj") else export_project
    write(PROJECT, SOLUTION, tmp_path / name)
    before = {each.name: each.read_bytes() for each in tmp_path.iterdir()}
    left = [calls]

    def cancel(_text: str, share: float) -> None:
        assert 0 <= share <= 1
        left[0] -= 1
        if not left[0]:
            raise Cancelled

    with pytest.raises(Cancelled):
        write(PROJECT, SOLUTION, tmp_path / name, Asked(rate=24.0), cancel)
    assert {each.name: each.read_bytes() for each in tmp_path.iterdir()} == before


@given(st.integers(1, 12), st.integers(0, 4), st.integers(0, 6), st.integers(0, 2**32 - 1))
def test_the_fewest_shapes_tell_what_they_were_made_of(rows: int, rank: int, most: int, seed: int) -> None:
    random = np.random.default_rng(seed)
    moved = (random.normal(size=(rows, rank)) @ random.normal(size=(rank, 18))).astype(np.float32)
    mean, shapes = fewest_shapes(moved, 1e-3, most)
    assert len(shapes) <= min(most, rank)
    weights = np.array([fitted(shapes, row - mean) for row in moved]).reshape(rows, len(shapes))
    if most >= rank:
        assert farthest(moved - mean - (weights @ shapes).astype(np.float32)) < 2e-3
    base, scaled, within = from_nothing_to_one(mean, shapes, weights)
    assert within.min(initial=0) >= 0
    assert within.max(initial=0) <= 1 + 1e-12
    assert np.abs(base + within @ scaled - (mean + weights @ shapes)).max() < 1e-4 * (1 + np.abs(moved).max())

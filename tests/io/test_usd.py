"""USD is what its own library takes for right: all its validators, and its own skinning frame by frame."""

import io
import sys
from functools import cache
from pathlib import Path

import numpy as np
import pytest
from pxr import Gf, Usd, UsdGeom, UsdShade, UsdSkel, UsdValidation

from facemodel.errors import ProjectError
from facemodel.io.export import EXPORTS, Asked, export_project
from facemodel.io.export.performance import WITHIN
from facemodel.kinematics import rig_of
from facemodel.superposition import Superposition
from tests.io.animated import PROJECT, SOLUTION, played, shown

FLOAT = 1e-3
"""Millimetres that float32 metres and what is left out of blend shapes may differ by."""


def written(folder: Path, suffix: str, asked: Asked = Asked()) -> Usd.Stage:  # noqa: B008 - a frozen value
    path = folder / f"face{suffix}"
    export_project(PROJECT, SOLUTION, path, asked)
    return Usd.Stage.Open(str(path))


@cache
def validators() -> UsdValidation.ValidationContext:
    """All that usdchecker looks at."""
    return UsdValidation.ValidationContext(UsdValidation.ValidationRegistry().GetOrLoadAllValidators())


def complaints(stage: Usd.Stage) -> list[str]:
    return [error.GetErrorAsString() for error in validators().Validate(stage)]


@pytest.mark.parametrize("suffix", [".usda", ".usdc"])
@pytest.mark.parametrize("asked", [Asked(), Asked(shaping="clip", most=3), Asked(animated=False)])
def test_no_validator_has_anything_to_say(tmp_path: Path, suffix: str, asked: Asked) -> None:
    assert complaints(written(tmp_path, suffix, asked)) == []


def test_the_validators_do_find_what_is_wrong(tmp_path: Path) -> None:
    stage = written(tmp_path, ".usda")
    stage.ClearMetadata("upAxis")
    UsdGeom.Mesh(stage.GetPrimAtPath("/Face/skin")).GetPrim().RemoveAppliedSchema("SkelBindingAPI")
    assert len(complaints(stage)) >= 2


@pytest.mark.parametrize("asked", [Asked(), Asked(shaping="clip")])
def test_its_own_skinning_has_every_frame_where_the_editor_shows_it(tmp_path: Path, asked: Asked) -> None:
    stage = written(tmp_path, ".usdc", asked)
    assert UsdSkel.BakeSkinning(UsdSkel.Root(stage.GetDefaultPrim()), Gf.Interval(0, 12))
    for frame, places in enumerate(shown(played())):
        for name, points in places.items():
            mesh = UsdGeom.Mesh(stage.GetPrimAtPath(f"/Face/{name.replace('-', '_')}"))
            carried = np.array(UsdGeom.Xformable(mesh).GetLocalTransformation(frame))
            seen = np.array(mesh.GetPointsAttr().Get(frame)) @ carried[:3, :3] + carried[3, :3]
            assert np.abs(1000 * seen - points).max() < WITHIN + FLOAT, (frame, name)


def test_a_still_face_has_every_unit_and_shows_its_expression(tmp_path: Path) -> None:
    stage = written(tmp_path, ".usda", Asked(animated=False))
    assert not stage.HasAuthoredTimeCodeRange()
    animation = UsdSkel.Animation(stage.GetPrimAtPath("/Face/Skeleton/Animation"))
    assert list(animation.GetBlendShapesAttr().Get()) == ["AU12", "AU12L", "AU12R", "AU18", "AU26", "posed"]
    assert UsdSkel.BakeSkinning(UsdSkel.Root(stage.GetDefaultPrim()), Gf.Interval.GetFullInterval())
    pose = Superposition(PROJECT.face, SOLUTION.basis, rig_of(PROJECT.units))
    pose.pose(PROJECT.expression)
    skin = np.array(UsdGeom.Mesh(stage.GetPrimAtPath("/Face/skin")).GetPointsAttr().Get())
    assert np.abs(1000 * skin - pose.points).max() < FLOAT
    teeth = np.array(UsdGeom.Mesh(stage.GetPrimAtPath("/Face/teeth_lower")).GetPointsAttr().Get())
    assert np.abs(1000 * teeth - pose.parts["teeth-lower"]).max() < 0.5


def test_frames_are_those_of_the_project(tmp_path: Path) -> None:
    stage = written(tmp_path, ".usdc", Asked(rate=24.0, span=(0.25, 0.75)))
    assert (stage.GetTimeCodesPerSecond(), stage.GetStartTimeCode(), stage.GetEndTimeCode()) == (24, 6, 18)
    assert UsdGeom.GetStageMetersPerUnit(stage) == 1
    assert UsdGeom.GetStageUpAxis(stage) == "Y"
    joints = UsdSkel.Skeleton(stage.GetPrimAtPath("/Face/Skeleton")).GetJointsAttr().Get()
    assert list(joints) == ["head", "head/jaw", "head/eyeball_left", "head/eyeball_right"]


def test_every_mesh_has_a_material(tmp_path: Path) -> None:
    stage = written(tmp_path, ".usda")
    meshes = [prim for prim in stage.Traverse() if prim.IsA(UsdGeom.Mesh)]
    assert len(meshes) == 8
    for prim in meshes:
        material, _ = UsdShade.MaterialBindingAPI(prim).ComputeBoundMaterial()
        assert material.ComputeSurfaceSource()[0].GetIdAttr().Get() == "UsdPreviewSurface"


def test_without_the_library_one_sentence_says_what_to_install(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(sys.modules, "facemodel.io.export.usd_stage", None)
    with pytest.raises(ProjectError, match=r"pip install usd-core.*glTF"):
        export_project(PROJECT, SOLUTION, tmp_path / "face.usdc")
    assert list(tmp_path.iterdir()) == []
    EXPORTS[".glb"].write(PROJECT, SOLUTION, io.BytesIO())

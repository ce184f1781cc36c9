"""A USD stage of a performance.  It needs usd-core, so nothing but `facemodel.io.export.usd` imports it."""

from __future__ import annotations

from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

from pxr import Kind, Sdf, Tf, Usd, UsdGeom, UsdSkel

from facemodel.basis import Basis
from facemodel.errors import ProjectError
from facemodel.face import Face
from facemodel.io.export.performance import Performance
from facemodel.io.export.pieces import pieces
from facemodel.io.export.usd_mesh import UsdMeshes
from facemodel.io.export.usd_skeleton import add_animation, add_skeleton
from facemodel.project import Project

ROOT = Sdf.Path("/Face")


def stage_bytes(kind: str, project: Project, basis: Basis, played: Performance, first: int) -> bytes:
    """The bytes of a file.

    Parameters
    ----------
    kind : ``usda`` or ``usdc``
    project, basis : the meshes at rest
    played : shapes and joints over time
    first : number of the first frame
    """
    face = project.face
    stage = _stage(face, played, first)
    root = UsdSkel.Root.Define(stage, ROOT)
    stage.SetDefaultPrim(root.GetPrim())
    Usd.ModelAPI(root.GetPrim()).SetKind(Kind.Tokens.component)
    root.GetPrim().SetDisplayName(face.title)
    skeleton = add_skeleton(stage, ROOT.AppendChild("Skeleton"), played.joints)
    add_animation(stage, skeleton, played, first)
    meshes = UsdMeshes(stage, ROOT, skeleton, face, played)
    for piece in pieces(project, basis, {}):
        meshes.add(piece)
    root.CreateExtentAttr(meshes.extent)
    return _bytes(stage.GetRootLayer(), kind)


def _stage(face: Face, played: Performance, first: int) -> Any:
    stage = Usd.Stage.CreateInMemory()
    UsdGeom.SetStageUpAxis(stage, UsdGeom.Tokens.y)
    UsdGeom.SetStageMetersPerUnit(stage, 1.0)
    stage.SetTimeCodesPerSecond(played.rate)
    stage.SetFramesPerSecond(played.rate)
    if len(played.times) > 1:
        stage.SetStartTimeCode(first)
        stage.SetEndTimeCode(first + len(played.times) - 1)
    layer = stage.GetRootLayer()
    layer.documentation = "Made with Risorius."
    layer.customLayerData = {"copyright": face.provenance} if face.provenance else {}
    return stage


def _bytes(layer: Any, kind: str) -> bytes:
    """The layer as a file; USD writes binary layers only under a name.

    Raises
    ------
    ProjectError
        If there is no room for it.
    """
    if kind == "usda":
        return str(layer.ExportToString()).encode()
    with TemporaryDirectory() as folder:
        path = Path(folder) / f"face.{kind}"
        try:
            written = layer.Export(str(path))
        except Tf.ErrorException:
            written = False
        if not written:
            raise ProjectError(
                f"USD cannot be written by way of “{path.parent.parent}”: there is no room or no permission; free some "
                "space there, or choose another disk in the variable TMPDIR."
            )
        return path.read_bytes()

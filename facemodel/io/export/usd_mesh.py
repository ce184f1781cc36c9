"""Meshes of a USD stage, bound to its skeleton, with their blend shapes and materials."""

from __future__ import annotations

from typing import Any

import numpy as np
from pxr import Gf, Sdf, Tf, UsdGeom, UsdShade, UsdSkel, Vt

from facemodel.face import Face
from facemodel.io.export.appearance import APPEARANCES, linear
from facemodel.io.export.gltf_mesh import METRES, UNSEEN, UNSEEN_TURN, moves_seen
from facemodel.io.export.joints import HEAD, joint_of
from facemodel.io.export.performance import Performance, Shape
from facemodel.io.export.pieces import Piece
from facemodel.io.export.usd_skeleton import shape_names
from fem.types import Float32Array

COLOURED = ("eye", "lashes")
"""Kinds of piece whose points have colours of their own."""


class UsdMeshes:
    """Adds meshes below a root.

    Attributes
    ----------
    extent : two corners of what all meshes fill at rest
    """

    def __init__(self, stage: Any, root: Sdf.Path, skeleton: Any, face: Face, played: Performance) -> None:
        self._stage, self._root, self._skeleton = stage, root, skeleton
        self._played = played
        self._names = shape_names(played)
        self._joints = [joint.name for joint in played.joints]
        self._jaw_parts = {part.name for part in face.parts if part.carrier == "jaw"}
        # A face that stands still moves its lower teeth by shapes, as it moves its skin.
        self._rigid_jaw = not played.still
        self._materials: dict[str, Any] = {}
        self.extent: Any = None
        self._low, self._high = np.full(3, np.inf), np.full(3, -np.inf)

    def add(self, piece: Piece) -> None:
        """Add a mesh."""
        mesh = UsdGeom.Mesh.Define(self._stage, self._root.AppendChild(Tf.MakeValidIdentifier(piece.name)))
        points = np.float32(METRES) * piece.positions
        mesh.CreatePointsAttr(Vt.Vec3fArray.FromNumpy(np.ascontiguousarray(points)))
        mesh.CreateFaceVertexCountsAttr(Vt.IntArray.FromNumpy(np.full(len(piece.triangles), 3, np.int32)))
        mesh.CreateFaceVertexIndicesAttr(Vt.IntArray.FromNumpy(piece.triangles.astype(np.int32).ravel()))
        mesh.CreateNormalsAttr(Vt.Vec3fArray.FromNumpy(np.ascontiguousarray(piece.normals)))
        mesh.SetNormalsInterpolation(UsdGeom.Tokens.vertex)
        mesh.CreateSubdivisionSchemeAttr(UsdGeom.Tokens.none)
        mesh.CreateDoubleSidedAttr(APPEARANCES[piece.kind].two_sided)
        self._colour(mesh, piece)
        self._bind(mesh, piece.name)
        self._fill(mesh, points)

    def _fill(self, mesh: Any, points: Float32Array) -> None:
        low, high = points.min(axis=0), points.max(axis=0)
        mesh.CreateExtentAttr(_corners(low, high))
        self._low, self._high = np.minimum(self._low, low), np.maximum(self._high, high)
        self.extent = _corners(self._low, self._high)

    def _bind(self, mesh: Any, name: str) -> None:
        """Carry a mesh by its joint, and move its points by shapes."""
        binding = UsdSkel.BindingAPI.Apply(mesh.GetPrim())
        binding.CreateSkeletonRel().SetTargets([self._skeleton.GetPath()])
        binding.CreateGeomBindTransformAttr(Gf.Matrix4d(1.0))
        joint = joint_of(name, self._jaw_parts if self._rigid_jaw else set()) or HEAD
        binding.CreateJointIndicesPrimvar(constant=True, elementSize=1).Set([self._joints.index(joint)])
        binding.CreateJointWeightsPrimvar(constant=True, elementSize=1).Set([1.0])
        shapes = [pair for pair in zip(self._names, self._played.shapes, strict=True) if moves_seen(pair[1], name)]
        if shapes:
            binding.CreateBlendShapesAttr([known for known, _ in shapes])
            targets = [self._shape(mesh.GetPath().AppendChild(known), shape, name) for known, shape in shapes]
            binding.CreateBlendShapeTargetsRel().SetTargets(targets)

    def _shape(self, path: Sdf.Path, shape: Shape, name: str) -> Sdf.Path:
        """A blend shape that holds only the points it moves."""
        moved = np.float32(METRES) * shape.moved[name]
        rows = np.flatnonzero(np.abs(moved).max(axis=1) > UNSEEN)
        turns = shape.turns.get(name)
        if turns is not None:
            turned = np.abs(turns).max(axis=1) > UNSEEN_TURN
            rows = np.union1d(rows, np.flatnonzero(turned))
        made = UsdSkel.BlendShape.Define(self._stage, path)
        made.CreateOffsetsAttr(Vt.Vec3fArray.FromNumpy(np.ascontiguousarray(moved[rows])))
        made.CreatePointIndicesAttr(Vt.IntArray.FromNumpy(rows.astype(np.int32)))
        if turns is not None:
            made.CreateNormalOffsetsAttr(Vt.Vec3fArray.FromNumpy(np.ascontiguousarray(turns[rows])))
        return path

    def _colour(self, mesh: Any, piece: Piece) -> None:
        primvars = UsdGeom.PrimvarsAPI(mesh)
        if piece.uv is not None:
            st = primvars.CreatePrimvar("st", Sdf.ValueTypeNames.TexCoord2fArray, UsdGeom.Tokens.vertex)
            st.Set(Vt.Vec2fArray.FromNumpy(piece.uv.astype(np.float32)))
        looks = APPEARANCES[piece.kind]
        if piece.kind in COLOURED:
            colours = linear(piece.colours[:, :3]).astype(np.float32)
            mesh.CreateDisplayColorPrimvar(UsdGeom.Tokens.vertex).Set(Vt.Vec3fArray.FromNumpy(colours))
            opacities = np.ascontiguousarray(piece.colours[:, 3], dtype=np.float32)
            mesh.CreateDisplayOpacityPrimvar(UsdGeom.Tokens.vertex).Set(Vt.FloatArray.FromNumpy(opacities))
        else:
            mesh.CreateDisplayColorPrimvar(UsdGeom.Tokens.constant).Set([_colour_of(piece.kind)])
            if looks.sheer:
                mesh.CreateDisplayOpacityPrimvar(UsdGeom.Tokens.constant).Set([looks.opacity])
        UsdShade.MaterialBindingAPI.Apply(mesh.GetPrim()).Bind(self._material(piece.kind))

    def _material(self, kind: str) -> Any:
        if kind not in self._materials:
            self._materials[kind] = _material(self._stage, self._root.AppendPath(f"Materials/{kind}"), kind)
        return self._materials[kind]


def _material(stage: Any, path: Sdf.Path, kind: str) -> Any:
    """A preview surface; where points have colours of their own it reads them."""
    UsdGeom.Scope.Define(stage, path.GetParentPath())
    looks = APPEARANCES[kind]
    material = UsdShade.Material.Define(stage, path)
    surface = UsdShade.Shader.Define(stage, path.AppendChild("Surface"))
    surface.CreateIdAttr("UsdPreviewSurface")
    surface.CreateInput("roughness", Sdf.ValueTypeNames.Float).Set(looks.roughness)
    surface.CreateInput("metallic", Sdf.ValueTypeNames.Float).Set(0.0)
    diffuse = surface.CreateInput("diffuseColor", Sdf.ValueTypeNames.Color3f)
    opacity = surface.CreateInput("opacity", Sdf.ValueTypeNames.Float)
    if kind in COLOURED:
        diffuse.ConnectToSource(_reader(stage, path.AppendChild("Colour"), "displayColor", "float3"))
    else:
        diffuse.Set(_colour_of(kind))
    if kind in COLOURED and looks.sheer:
        opacity.ConnectToSource(_reader(stage, path.AppendChild("Opacity"), "displayOpacity", "float"))
    else:
        opacity.Set(looks.opacity)
    material.CreateSurfaceOutput().ConnectToSource(surface.ConnectableAPI(), "surface")
    return material


def _reader(stage: Any, path: Sdf.Path, primvar: str, kind: str) -> Any:
    """The output of a shader that reads what the points have."""
    reader = UsdShade.Shader.Define(stage, path)
    reader.CreateIdAttr(f"UsdPrimvarReader_{kind}")
    reader.CreateInput("varname", Sdf.ValueTypeNames.String).Set(primvar)
    types = {"float3": Sdf.ValueTypeNames.Float3, "float": Sdf.ValueTypeNames.Float}
    return reader.CreateOutput("result", types[kind])


def _colour_of(kind: str) -> Any:
    return Gf.Vec3f(*linear(np.array(APPEARANCES[kind].colour)).tolist())


def _corners(low: Float32Array, high: Float32Array) -> Any:
    return [Gf.Vec3f(*low.tolist()), Gf.Vec3f(*high.tolist())]

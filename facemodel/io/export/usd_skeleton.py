"""Head, jaw and eyes as the joints of a USD skeleton, and the animation of joints and blend shapes."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

import numpy as np
from pxr import Gf, Sdf, Tf, UsdSkel, Vt

from facemodel.io.export.gltf_mesh import METRES
from facemodel.io.export.joints import Joint
from facemodel.io.export.performance import Performance
from fem.types import FloatArray


def joint_path(joint: Joint) -> str:
    """A joint as USD names it, below its parent."""
    return "/".join(Tf.MakeValidIdentifier(name) for name in (joint.parent, joint.name) if name)


def shape_names(played: Performance) -> list[str]:
    """The shapes as USD names them."""
    return [Tf.MakeValidIdentifier(shape.name) for shape in played.shapes]


def add_skeleton(stage: Any, path: Sdf.Path, joints: Sequence[Joint]) -> Any:
    """A skeleton at rest."""
    skeleton = UsdSkel.Skeleton.Define(stage, path)
    skeleton.CreateJointsAttr([joint_path(joint) for joint in joints])
    pivots = {joint.name: joint.pivot for joint in joints}
    skeleton.CreateBindTransformsAttr([_translation(joint.pivot) for joint in joints])
    skeleton.CreateRestTransformsAttr([_translation(joint.pivot - _origin(joint, pivots)) for joint in joints])
    return skeleton


def add_animation(stage: Any, skeleton: Any, played: Performance, first: int) -> None:
    """What moves the skeleton and the blend shapes: one sample for every frame, or a default for a single one."""
    path = skeleton.GetPath().AppendChild("Animation")
    animation = UsdSkel.Animation.Define(stage, path)
    joints = played.joints
    pivots = {joint.name: joint.pivot for joint in joints}
    animation.CreateJointsAttr([joint_path(joint) for joint in joints])
    animation.CreateScalesAttr([Gf.Vec3h(1, 1, 1)] * len(joints))
    places = np.stack([joint.places - _origin(joint, pivots) for joint in joints], axis=1)
    turns = np.stack([joint.turns for joint in joints], axis=1)
    _sample(
        animation.CreateTranslationsAttr(),
        [Vt.Vec3fArray.FromNumpy(np.float32(METRES * row)) for row in places],
        first,
    )
    _sample(animation.CreateRotationsAttr(), [_quaternions(row) for row in turns], first)
    if played.shapes:
        animation.CreateBlendShapesAttr(shape_names(played))
        rows = [Vt.FloatArray.FromNumpy(np.float32(row)) for row in played.weights]
        _sample(animation.CreateBlendShapeWeightsAttr(), rows, first)
    binding = UsdSkel.BindingAPI.Apply(skeleton.GetPrim())
    binding.CreateAnimationSourceRel().SetTargets([path])


def _sample(attribute: Any, values: Sequence[Any], first: int) -> None:
    """Give an attribute one value per frame; a single one once for all."""
    if all(value == values[0] for value in values):
        attribute.Set(values[0])
        return
    for number, value in enumerate(values):
        attribute.Set(value, first + number)


def _origin(joint: Joint, pivots: dict[str, FloatArray]) -> FloatArray:
    """The pivot (3,) of the joint that carries a joint."""
    return pivots[joint.parent] if joint.parent else np.zeros(3)


def _translation(place: FloatArray) -> Any:
    return Gf.Matrix4d(1.0).SetTranslate(Gf.Vec3d(*(METRES * place).tolist()))


def _quaternions(turns: FloatArray) -> Any:
    return Vt.QuatfArray([Gf.Quatf(w, x, y, z) for x, y, z, w in turns.tolist()])

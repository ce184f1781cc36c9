"""The head and the eyes turned: the camera and its lamps stay, everything that belongs to the head goes along."""

from __future__ import annotations

from collections.abc import Mapping

from vtkmodules.vtkCommonMath import vtkMatrix4x4

from facemodel.animation.rigid import eye_motion, head_motion
from fem.types import FloatArray
from ui.viewport.scene import Scene


def turn_head(scene: Scene, rigid: Mapping[str, float]) -> None:
    """Turn head and eyes of the face that is drawn.

    The whole world of the head is moved before the camera, so that overlays go along and places under the pointer
    are told as they are in the head.

    Parameters
    ----------
    scene : where it is drawn
    rigid : degrees and millimetres by channel; those not named rest
    """
    if scene.figure is None:
        return
    face = scene.figure.posed.face
    scene.renderer.GetActiveCamera().SetModelTransformMatrix(_matrix(head_motion(face, rigid)))
    for eye, drawn in zip(face.eyes, scene.figure.eyes, strict=True):
        drawn.turn(eye_motion(eye, rigid))


def _matrix(motion: FloatArray) -> vtkMatrix4x4:
    matrix = vtkMatrix4x4()
    matrix.DeepCopy([float(x) for x in motion.ravel()])
    return matrix

"""The template skull of one face."""

from __future__ import annotations

from collections.abc import Mapping

import igl
import numpy as np

from facemodel.face import Eye, Jaw, Skull
from facemodel.making.skull.depth import BoneEnvelope
from facemodel.making.skull.frame import Frame
from facemodel.making.skull.share import jaw_share
from facemodel.making.skull.surface import grid, meshed
from facemodel.mesh import Mesh
from fem.types import FloatArray

CONDYLE = np.array([50.0, 707.0, 75.0])
"""Centre of the left condyle on the measured head: 13 mm before the tragus, 100 mm from the right one."""


def jaw_hinge(skin: Mesh, landmarks: Mapping[str, int], anchors: FloatArray, frame: Frame) -> Jaw:
    """The hinge: the condyles, and the point where the lower incisors meet the upper ones."""
    axis = frame.here(np.array([CONDYLE * [-1, 1, 1], CONDYLE]))
    slit = skin.positions[[landmarks["upper_lip_mid"], landmarks["lower_lip_mid"]]].mean(axis=0)
    incisor = anchors[landmarks["lower_lip_incisor"]]
    return Jaw(axis, np.array([incisor[0], slit[1], incisor[2]]))


def make_skull(skin: Mesh, landmarks: Mapping[str, int], eyes: tuple[Eye, Eye]) -> Skull:
    """Derive a skull from the tables of soft-tissue depth.

    Parameters
    ----------
    skin : the whole skin, millimetres, with boundary loops mouth, eyes and neck
    landmarks : its vertices by name, see `facemodel.making.landmarks`
    eyes : left and right eyeball
    """
    frame = Frame(skin, landmarks, eyes)
    bone = BoneEnvelope(skin, landmarks, eyes)
    points, size = grid(bone.inner.positions.min(axis=0) - 4, bone.inner.positions.max(axis=0) + 4, 2.5)
    kind = igl.SignedDistanceType.SIGNED_DISTANCE_TYPE_FAST_WINDING_NUMBER
    envelope = igl.signed_distance(points, bone.inner.positions, bone.inner.triangles, kind)[0]
    q = frame.measured(points)
    low = (62 - q[:, 2]) * 0.46 - (q[:, 1] - 705) * 0.88
    cranium = np.maximum(envelope, np.maximum(low + 2, 672 - q[:, 1]))
    floor = 640 - q[:, 1] - 0.5 * (q[:, 2] - 90)
    mandible = np.maximum(envelope, np.maximum(2 - low, np.maximum(66 - q[:, 2], floor)))
    return Skull(
        meshed(cranium, points, size, 8000),
        meshed(mandible, points, size, 2500),
        bone.anchors,
        jaw_share(skin, landmarks, frame),
        jaw_hinge(skin, landmarks, bone.anchors, frame),
    )

"""The template skull of one face."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass

import igl
import numpy as np

from facemodel.face import Eye, Jaw, Skull
from facemodel.making.skull.cranium import cranium_field
from facemodel.making.skull.depth import BoneEnvelope
from facemodel.making.skull.envelope import closed
from facemodel.making.skull.fields import smooth_max
from facemodel.making.skull.frame import Frame
from facemodel.making.skull.mandible import mandible_field
from facemodel.making.skull.share import jaw_share
from facemodel.making.skull.surface import Grid, meshed
from facemodel.making.skull.teeth import LOWER, UPPER, tooth_row
from facemodel.mesh import Mesh
from fem.types import FloatArray

Shape = Callable[[FloatArray, FloatArray], FloatArray]

CONDYLE = np.array([50.0, 707.0, 75.0])
"""Centre of the left condyle on the measured head: 13 mm before the tragus, 100 mm from the right one."""


@dataclass(frozen=True)
class Block:
    """The box of the measured head that holds a bone, how finely it is sampled, and the triangles it may cost."""

    low: tuple[float, float, float]
    high: tuple[float, float, float]
    step: float
    triangles: int


THINNEST = 1.5
"""Millimetres of skin that cover the bone everywhere, also where skin folds in beside nose and lids."""

CRANIUM = Block((-74, 665, -42), (74, 852, 160), 1.25, 9000)
MANDIBLE = Block((-64, 612, 52), (64, 718, 150), 1.1, 2600)


def _inside(mesh: Mesh, points: FloatArray) -> FloatArray:
    """Signed distance (n,) to a closed surface, negative inside."""
    kind = igl.SignedDistanceType.SIGNED_DISTANCE_TYPE_FAST_WINDING_NUMBER
    return np.asarray(igl.signed_distance(points, mesh.positions, mesh.triangles, kind)[0])


def _shape(field: Shape, limits: tuple[Mesh, Mesh], frame: Frame, block: Block) -> Mesh:
    """One bone: sampled on a grid of the measured head, meshed there, and carried to this head.

    Parameters
    ----------
    limits : the surface on which bone ends, and the closed skin, under which it stays in any case
    """
    coarse = Grid.over(block.low, block.high, 2 * block.step)
    here = frame.here(coarse.points())
    end, skin = limits
    distance = smooth_max(_inside(end, here), _inside(skin, here) + THINNEST, 1.0)
    fine = coarse.halved()
    bone = meshed(fine, field(fine.points(), coarse.refined(distance)), block.triangles)
    return bone.moved(frame.here(bone.positions))


def _joined(a: Mesh, b: Mesh) -> Mesh:
    """Two closed meshes as one."""
    return Mesh(
        np.concatenate([a.positions, b.positions]),
        np.concatenate([a.triangles, b.triangles + len(a.positions)]),
    )


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
    bone = BoneEnvelope(skin, landmarks, eyes)
    frame = Frame(bone, landmarks, eyes)
    upper, lower = tooth_row(UPPER), tooth_row(LOWER)
    teeth = _joined(upper, lower)
    pairs = np.tile(igl.vertex_components(upper.triangles), 2)
    placed = frame.fitted(teeth.positions, pairs)
    limits = Mesh(*igl.loop(bone.inner.positions, bone.inner.triangles, 1)), closed(skin)
    return Skull(
        _joined(_shape(cranium_field, limits, frame, CRANIUM), upper.moved(placed[: len(upper.positions)])),
        _joined(_shape(mandible_field, limits, frame, MANDIBLE), lower.moved(placed[len(upper.positions) :])),
        bone.anchors,
        jaw_share(skin, landmarks),
        jaw_hinge(skin, landmarks, bone.anchors, frame),
    )

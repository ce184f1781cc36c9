"""The template skull of one face."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, replace

import igl
import numpy as np

from facemodel.dental_arch import DentalArch, RowName, dental_arch
from facemodel.face import Eye, Face, Jaw, Part, Skull
from facemodel.making.skull.cranium import cranium_field
from facemodel.making.skull.depth import BoneEnvelope
from facemodel.making.skull.envelope import closed
from facemodel.making.skull.fields import smooth_max
from facemodel.making.skull.frame import Frame
from facemodel.making.skull.mandible import mandible_field
from facemodel.making.skull.seated import Seat, before_row, crowns_along, seat_of
from facemodel.making.skull.share import jaw_share
from facemodel.making.skull.surface import Grid, meshed
from facemodel.making.skull.teeth import LOWER, UPPER, Row, tooth_row
from facemodel.mesh import Mesh
from fem.types import FloatArray

Shape = Callable[[FloatArray, FloatArray, FloatArray], FloatArray]

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

THIN_LIP = 0.3
"""The same over the sockets of the teeth, which the lips lie on."""

CRANIUM = Block((-74, 665, -42), (74, 852, 160), 1.25, 9000)
MANDIBLE = Block((-64, 612, 52), (64, 718, 150), 1.1, 2600)


def _inside(mesh: Mesh, points: FloatArray) -> FloatArray:
    """Signed distance (n,) to a closed surface, negative inside."""
    kind = igl.SignedDistanceType.SIGNED_DISTANCE_TYPE_FAST_WINDING_NUMBER
    return np.asarray(igl.signed_distance(points, mesh.positions, mesh.triangles, kind)[0])


def _shape(field: Shape, limits: tuple[Mesh, Mesh], frame: Frame, block: Block, seat: Seat, arch: DentalArch) -> Mesh:
    """One bone: sampled on a grid of the measured head, meshed there, and carried to this head.

    Parameters
    ----------
    limits : the surface on which bone ends, with which it goes along to its teeth, and the closed skin
    arch : of its teeth; under their gum and the skin it stays in any case
    """
    coarse = Grid.over(block.low, block.high, 2 * block.step)
    here = frame.here(coarse.points())
    seated = seat(here)
    end, skin, gum = _inside(limits[0], here), _inside(limits[1], seated), before_row(arch, seated)
    fine = coarse.halved()
    distances = smooth_max(end, np.maximum(skin + THINNEST, gum), 1.0), np.maximum(skin + THIN_LIP, gum)
    bone = meshed(fine, field(fine.points(), *map(coarse.refined, distances)), block.triangles)
    return bone.moved(seat(frame.here(bone.positions)))


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


def make_skull(
    skin: Mesh, landmarks: Mapping[str, int], eyes: tuple[Eye, Eye], arches: Mapping[RowName, DentalArch]
) -> Skull:
    """Derive a skull from the tables of soft-tissue depth, with its teeth where those of the face are.

    Parameters
    ----------
    skin : the whole skin, millimetres, with boundary loops mouth, eyes and neck
    landmarks : its vertices by name, see `facemodel.making.landmarks`
    eyes : left and right eyeball
    arches : of the ``upper`` and the ``lower`` row of the face's teeth
    """
    bone = BoneEnvelope(skin, landmarks, eyes)
    frame = Frame(bone, landmarks, eyes)
    limits = Mesh(*igl.loop(bone.inner.positions, bone.inner.triangles, 1)), closed(skin)
    upper, lower = arches["upper"], arches["lower"]
    seat = seat_of(frame, [(UPPER, upper), (LOWER, lower)])
    return Skull(
        _joined(_shape(cranium_field, limits, frame, CRANIUM, seat, upper), _crowns(UPPER, upper)),
        _joined(_shape(mandible_field, limits, frame, MANDIBLE, seat, lower), _crowns(LOWER, lower)),
        bone.anchors,
        jaw_share(skin, landmarks),
        jaw_hinge(skin, landmarks, bone.anchors, frame),
    )


def with_bones_about_teeth(face: Face) -> Face:
    """A face whose template skull is made anew about its teeth as they stand now; springs and hinge stay."""
    made = make_skull(face.skin, face.landmarks, face.eyes, arches_of(face.parts))
    return replace(face, skull=replace(face.skull, cranium=made.cranium, mandible=made.mandible))


def arches_of(parts: Iterable[Part]) -> dict[RowName, DentalArch]:
    """The arches of the rows of teeth among the parts of a face."""
    arches = (dental_arch(part) for part in parts if part.kind == "teeth")
    return {arch.jaw: arch for arch in arches}


def _crowns(row: Row, arch: DentalArch) -> Mesh:
    """The crowns of a row along the arch of a face; those of a bone come last."""
    crowns = tooth_row(row)
    return crowns.moved(crowns_along(row, arch))

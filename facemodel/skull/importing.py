"""The skull of a head made from bone that was fitted into it."""

from __future__ import annotations

import numpy as np

from facemodel.errors import SkullError
from facemodel.face import Face, Skull
from facemodel.mesh import Mesh, submesh
from facemodel.skull.depths import whole
from facemodel.skull.feet import feet_on
from facemodel.skull.jaw_proposal import proposed_jaw

FARTHEST = 400.0
"""Millimetres from the middle of a head within which all bone of it lies."""


def skull_of(face: Face, bone: Mesh, known: Skull) -> Skull:
    """The skull that bone makes under the skin of a face; its springs are laid anew, its jaw is cut out.

    Parameters
    ----------
    bone : one closed mesh that lies in the head, millimetres
    known : another skull of the same head, by which jaw, hinge and the directions of springs are known

    Raises
    ------
    SkullError
        If the bone does not lie in the head.
    """
    middle = (face.skin.positions.min(axis=0) + face.skin.positions.max(axis=0)) / 2
    if not np.isfinite(bone.positions).all() or np.abs(bone.positions - middle).max() > FARTHEST:
        raise SkullError("The skull would not lie in the head; pick its landmarks anew.")
    inside = np.asarray(proposed_jaw(bone, known)[bone.triangles].all(axis=1))
    jaw = inside & ~inside.all()
    return Skull(
        cranium=submesh(bone, ~jaw)[0],
        mandible=submesh(bone, jaw)[0],
        anchors=feet_on(face.skin, known.anchors, whole(known), bone),
        jawbone=known.jawbone,
        jaw=known.jaw,
    )

"""The cranium, modelled on the measured head: what is hollowed out of the bone under the skin.

Coordinates are those of the measured head (see `Frame`), mirrored to the left side; ``bone`` is the distance to the
surface on which all bone ends, so that every feature lies under the face at the depth of the tables.
"""

from __future__ import annotations

import numpy as np

from facemodel.making.skull.fields import (
    along,
    carved,
    ellipsoid,
    outline,
    rod,
    smooth_max,
    smooth_min,
)
from facemodel.making.skull.teeth import UPPER, sockets
from fem.types import FloatArray

ARCH = [
    (62, 719), (70, 716.5), (78, 714.5), (90, 713.5), (100, 713.5), (112, 714),
    (116, 700), (112, 691), (106, 694.5), (100, 698.5), (90, 701.5), (78, 704), (70, 705), (64, 707),
]  # fmt: skip
"""Zygomatic arch and bone seen from the side, (z, y)."""

FOSSA = [
    (90, 745), (101, 741), (109, 734), (112.5, 724), (111, 712), (106, 704), (101, 697), (96.5, 688), (94.5, 676),
    (94.5, 640), (74, 640), (74, 690), (78, 702), (78.5, 718), (80, 730),
]  # fmt: skip
"""Temporal and infratemporal fossa seen from the side, (z, y)."""

NOSTRIL = [(0, 704.5), (4, 703.5), (6.3, 700.5), (8.8, 695), (11, 687), (11.2, 682.5), (8, 679), (3, 678), (0, 679.5)]
"""Half of the piriform aperture seen from the front, (x, y)."""

ARCH_THICKNESS = 6.0


def braincase(p: FloatArray, bone: FloatArray) -> FloatArray:
    """The vault, closed below by the base, with mastoid and the part of the temporal bone that holds the ear."""
    x, y, z = p.T
    down, back = np.minimum(y - 745, 0) / 56, np.minimum(z - 42, 0) / 86
    level = ((x / 72) ** 2.6 + np.abs(down) ** 2.6 + np.abs(back) ** 2.6) ** (1 / 2.6)
    case = smooth_max(bone, (level - 1) * 56, 4)
    petrous = ellipsoid(p, (50, 710, 58), (14, 13, 15))
    mastoid = rod(p, [(48, 710, 46), (44, 697, 46), (41.5, 687, 48)], [13, 10.5, 7])
    lobe = ellipsoid(p, (20, 706, 6), (24, 15, 24))
    condyle = ellipsoid(p, (12, 690, 44), (6, 6, 10))
    for part in (petrous, mastoid, lobe, condyle):
        case = smooth_min(case, part, 5)
    foramen = ellipsoid(p, (0, 686, 28), (14, 14, 17))
    return carved(case, foramen, 3)


def face_block(p: FloatArray, bone: FloatArray) -> FloatArray:
    """Forehead and midface in front of the braincase, down to the sockets of the teeth."""
    _, y, z = p.T
    margin = along(z, [(148, 671), (136, 672.5), (120, 675.5), (97, 680.5), (80, 684)])
    block = smooth_max(np.maximum(88 - z, margin - y), bone, 1)
    palate = ellipsoid(p, (0, 672, 116), (21, 15, 26))
    choana = rod(p, [(7.5, 696, 70), (7.5, 694, 98)], [7.5, 7.0])
    plate = rod(p, [(20, 704, 88), (20, 690, 85), (21, 677, 84)], [6, 5, 3])
    return carved(carved(smooth_min(block, plate, 4), palate, 3), choana, 2)


def orbit(p: FloatArray) -> FloatArray:
    """The eye's socket: a rounded pyramid whose inner wall runs straight back and whose outer one turns in."""
    x, y, z = p.T
    outer = along(z, [(84, 14), (100, 29), (112, 41), (118, 45), (135, 49), (160, 52)])
    inner = along(z, [(84, 10), (112, 11.5), (128, 12.5), (138, 13), (160, 8)])
    top = along(z, [(84, 734), (105, 743), (122, 747.5), (132, 746.5), (140, 744.5), (160, 746)])
    floor = along(z, [(84, 724), (100, 714), (120, 708.5), (130, 711), (137, 713), (160, 712)])
    droop = 0.10 * (x - 30)
    u = (x - (outer + inner) / 2) / ((outer - inner) / 2)
    v = (y + droop - (top + floor) / 2) / ((top - floor) / 2)
    level = (np.abs(u) ** 2.7 + np.abs(v) ** 2.7) ** (1 / 2.7)
    socket = smooth_max((level - 1) * (top - floor) / 2, 86 - z, 4)
    fissure = rod(p, [(12, 727, 80), (22, 732, 91), (31, 736, 98)], [2.4, 1.7, 1.2])
    return np.minimum(socket, fissure)


def nose(p: FloatArray) -> FloatArray:
    """The hollow of the nose behind the piriform aperture, parted by the septum."""
    x, y, z = p.T
    hollow = smooth_max(outline(x, y, NOSTRIL), 112 - z, 4)
    septum = np.maximum(
        x - 1.1 - along(z, [(125, 1.5), (140, 0.0)]), z - along(y, [(680, 144), (690, 136), (706, 146)])
    )
    concha = rod(p, [(12, 688, 141), (9.5, 687, 130), (9, 688, 112)], [2.2, 3.2, 3.0])
    return carved(carved(hollow, septum, 1), concha, 1)


def fossa(p: FloatArray) -> FloatArray:
    """What lies beside the skull behind the cheek: the room of the chewing muscles and of the coronoid process."""
    x, y, z = p.T
    wall = along(y, [(676, 25), (690, 27), (702, 34), (712, 42), (722, 46.5), (732, 48.5), (745, 53)])
    wall = wall + along(z, [(78, 3), (90, 1), (100, -1), (112, -2)])
    ramp = along(z, [(70, 1.6), (80, 0.8), (94, 0.8), (106, 2.5)])
    beyond = outline(z, y, FOSSA) + 4
    return np.asarray((wall + ramp * (beyond + np.sqrt(beyond**2 + 40)) / 2 - x) / np.sqrt(1 + ramp**2))


def cranium_field(p: FloatArray, bone: FloatArray, cover: FloatArray) -> FloatArray:
    """The cranium without teeth.

    Parameters
    ----------
    p : (n, 3) points of the measured head, either side
    bone : (n,) signed distance to the surface on which bone ends
    cover : (n,) the same to the one on which the sockets of teeth end, which stand out of it as lips lie on them
    """
    p = np.abs(p[:, :1]) * [1, 0, 0] + p * [0, 1, 1]
    x, y, z = p.T
    skull = smooth_min(braincase(p, bone), face_block(p, bone), 3)
    skull = carved(skull, fossa(p), 4)
    shell = smooth_max(np.maximum(bone, -bone - ARCH_THICKNESS), outline(z, y, ARCH), 3)
    skull = smooth_min(skull, np.maximum(shell, 30 - x), 4)
    tubercle = smooth_max(ellipsoid(p, (55, 708, 87), (7, 6, 6)), bone, 1)
    skull = smooth_min(skull, tubercle, 4)
    joint = ellipsoid(p, (50, 705.5, 75), (15, 8.5, 7.2))
    skull = carved(carved(skull, joint, 2.5), orbit(p), 5)
    spine = smooth_max(rod(p, [(0, 680, 138), (0, 679, 148.5)], [3, 1.2]), bone, 1)
    skull = smooth_min(np.maximum(skull, bone), smooth_max(sockets(p, UPPER), cover, 1.5), 2)
    skull = smooth_min(carved(skull, nose(p), 4), spine, 2)
    canal = rod(p, [(75, 706, 61.5), (52, 704.5, 62.5)], [3.0, 2.6])
    outlet = ellipsoid(p, (28.5, 703.5, 137), (2.6, 2.6, 5))
    return carved(carved(skull, canal, 1.5), outlet, 1)

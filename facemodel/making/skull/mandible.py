"""The mandible, modelled on the measured head along its own bow: arc length from the chin, height, and offset.

Coordinates as in `cranium`.
"""

from __future__ import annotations

import numpy as np

from facemodel.making.skull.fields import along, carved, ellipsoid, outline, rod, smooth_max, smooth_min
from facemodel.making.skull.teeth import LOWER, sockets
from fem.types import FloatArray

BOW = np.array(
    [(0, 132.5), (8, 131.5), (14, 127), (19, 118), (23.8, 107), (29.2, 97), (35.5, 88), (41.5, 80), (46, 72), (49, 60)]
)
"""Plan of the bone's middle from the chin to behind the joint, (x, z)."""

SIDE = [
    (-20, 624.5), (0, 624.5), (10, 625.5), (20, 629), (30, 634), (40, 640.5), (52, 648.5), (62, 654.5), (71, 657.5),
    (79.5, 660.5), (82.5, 671), (81.5, 686), (79.5, 700), (77, 707), (73.5, 707), (72, 699), (69, 692), (66, 691.5),
    (63, 695), (60, 703), (57.5, 706), (55, 704), (52, 694), (48.5, 680), (45, 669.5),
    (40, 666.5), (30, 661), (20, 656), (10, 652.5), (0, 652), (-20, 652),
]  # fmt: skip
"""The bone unrolled: arc length along the bow and height, (s, y), from the lower border over the ramus forward."""

LEAN = 0.11
"""The ramus leans out by this much per millimetre of height above the body."""


def unrolled(p: FloatArray) -> tuple[FloatArray, FloatArray]:
    """Arc length (n,) along the bow from the chin, and offset (n,) from its middle, positive outwards."""
    lean = LEAN * np.maximum(p[:, 1] - 655, 0) * along(p[:, 2], [(92, 1), (108, 0)])
    point = np.stack([np.maximum(p[:, 0] - lean, 0), p[:, 2]], axis=1)
    starts = np.concatenate([[0.0], np.cumsum(np.linalg.norm(np.diff(BOW, axis=0), axis=1))])
    best = np.full(len(p), np.inf)
    arc, offset = np.zeros(len(p)), np.zeros(len(p))
    for a, b, start in zip(BOW[:-1], BOW[1:], starts, strict=False):
        length = np.linalg.norm(b - a)
        direction = (b - a) / length
        t = np.clip((point - a) @ direction, 0, length)
        gap = point - a - t[:, None] * direction
        distance = np.linalg.norm(gap, axis=1)
        outward = gap @ np.array([-direction[1], direction[0]])
        nearer = distance < best
        best = np.where(nearer, distance, best)
        arc = np.where(nearer, start + t, arc)
        offset = np.where(nearer, np.where(outward < 0, -distance, distance), offset)
    return arc, offset


def mandible_field(p: FloatArray, bone: FloatArray, cover: FloatArray) -> FloatArray:
    """The mandible without teeth; parameters as in `cranium_field`."""
    p = np.abs(p[:, :1]) * [1, 0, 0] + p * [0, 1, 1]
    y = p[:, 1]
    s, r = unrolled(p)
    ramus = along(s, [(40, 0.0), (56, 1.0)])
    inner = (1 - ramus) * along(y, [(626, 5.5), (640, 4.5), (655, 5.0)]) + ramus * 2.6
    outer = (1 - ramus) * 8.0 + ramus * 3.2
    plate = smooth_max(outline(s, y, SIDE), np.maximum(r - outer, -r - inner), 5)
    neck = rod(p, [(47.5, 690, 73), (49.5, 704, 75)], [3.6, 4.0])
    head = ellipsoid(p, (50, 707, 75), (10, 5, 4.8))
    chin = ellipsoid(p, (7, 629, 133), (10, 6, 7))
    whole = smooth_min(smooth_min(plate, chin, 4), smooth_min(neck, head, 3), 3)
    whole = smooth_min(smooth_max(whole, bone, 1.5), smooth_max(sockets(p, LOWER), cover, 1.5), 3)
    foramen = ellipsoid(p, (22, 643, 122), (4, 2.2, 2.2))
    return carved(whole, foramen, 1)

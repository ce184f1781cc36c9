"""The body of a sphincter: a ring, half a ring or the arch of a lid, laid under the skin."""

from __future__ import annotations

import numpy as np

from facemodel.laying.drape import draped
from facemodel.laying.rings import frame_of
from facemodel.mesh import Mesh
from facemodel.muscles import Muscle, Sphincter
from fem.types import FloatArray
from ui.viewport.overlays.lens import ACROSS, grain_of, lens

AROUND = 72
"""Segments round a sphincter."""

SLIM = 0.28
"""Half width of a ring over its width of influence."""

UNDER_SKIN = 1.0
"""Millimetres of skin over a ring, and twice as many of the outer half of its belly."""

TAPER = 0.30
"""Share of half a ring over which its ends run out to a point."""

LID = (0.06 * np.pi, 0.94 * np.pi)
"""Angles of the canthi on the arch of a lid."""


def ring_body(muscle: Muscle, skin: Mesh) -> tuple[FloatArray, FloatArray, bool]:
    """Points (rows, columns, 3), millimetres along and across (rows, columns, 2), and whether the columns close."""
    ring = muscle.ring
    assert ring is not None
    closed = not ring.sector.any() and muscle.model != "lid"
    turn, taper = _turns(ring, muscle.model == "lid")
    shares = _lid_shares(turn, taper) if muscle.model == "lid" else _shares(ring, muscle.width, taper)
    turns = np.broadcast_to(turn, shares.shape[:2])
    on_skin = draped(ring, turns, shares, skin)
    out = frame_of(ring)[2]
    out = out / np.linalg.norm(out)
    half = np.linalg.norm(on_skin[-1] - on_skin[0], axis=1) / 2
    thickness = np.minimum(UNDER_SKIN / 2 + 0.1 * half, 0.4 * half) * np.sqrt(taper)
    middles = on_skin - (UNDER_SKIN + thickness)[:, None] * out
    body = lens(middles, thickness, np.broadcast_to(out, (len(turn), 3)))
    return body, grain_of(body, middles), closed


def _turns(ring: Sphincter, lid: bool) -> tuple[FloatArray, FloatArray]:
    """Angles (columns,) round the ring, and how far (columns,) it has its full width there."""
    if lid:
        turn = np.linspace(*LID, AROUND // 2)
    elif ring.sector.any():
        a, b = np.linalg.norm(ring.long_axis), np.linalg.norm(ring.short_axis)
        middle = np.arctan2(ring.sector @ ring.short_axis / b, ring.sector @ ring.long_axis / a)
        turn = middle + np.linspace(-np.pi / 2, np.pi / 2, AROUND // 2 + 1)
    else:
        return np.linspace(0, 2 * np.pi, AROUND, endpoint=False), np.ones(AROUND)
    to_end = np.minimum(np.linspace(0, 1, len(turn)), np.linspace(1, 0, len(turn))) / TAPER
    return turn, np.sin(np.pi / 2 * np.clip(to_end, 0.03, 1.0))


def _shares(ring: Sphincter, width: float, taper: FloatArray) -> FloatArray:
    """Factors (ROWS, columns, 2) on the half axes: as wide along the long axis as along the short one."""
    lengths = np.array([np.linalg.norm(ring.long_axis), np.linalg.norm(ring.short_axis)])
    half = np.minimum(SLIM * width, 0.8 * lengths.min())
    return np.asarray(1 + (ACROSS[:, None] * half * taper)[..., None] / lengths)


def _lid_shares(turn: FloatArray, taper: FloatArray) -> FloatArray:
    """From the margin of a lid to its fold."""
    spread = 0.68 + 0.32 * ACROSS[:, None] * taper
    return np.stack([np.full(spread.shape, 0.95), spread], axis=-1)

"""Lay the plane figure of a ring on the skin, as smooth as a muscle is, whatever holes and folds the skin has there."""

from __future__ import annotations

from functools import lru_cache

import numpy as np
from scipy.ndimage import gaussian_filter

from facemodel.laying.places import ahead
from facemodel.laying.rings import frame_of
from facemodel.mesh import Mesh
from facemodel.muscles import Sphincter
from fem.types import BoolArray, FloatArray

FAR = 60.0
"""Millimetres before the plane of a ring from which the skin is looked for."""

DEEP = 30.0
"""Millimetres from the usual height beyond which what is seen is no skin of the ring: the back of a mouth, the nose."""

WAVES = 4
"""Waves round a ring that its height follows; a fold of the skin is more of them, and no fold of the muscle."""

FOLD = 1.5
"""Millimetres off the smooth height from which the skin counts less and less."""

DEEPEST, EVEN = 3.0, 2.0
"""Millimetres that a ring goes under the skin where that is lower than around it, and places over which it does so."""

WHOLE = 1.8 * np.pi
"""Angle from the first place to the last beyond which a ring closes."""

AROUND = 64
"""Places of the line of a ring."""

ROUNDS = 6
"""In which the height is fitted; it stands still after four."""


@lru_cache(maxsize=256)
def ring_line(ring: Sphincter, skin: Mesh) -> FloatArray:
    """The whole ring on the skin as `AROUND` places (AROUND, 3), from the tip of its long half axis on."""
    return draped(ring, ring_turns(), np.ones((AROUND, 2)), skin)


def ring_turns() -> FloatArray:
    """The angles (AROUND,) of the places of `ring_line`."""
    return np.linspace(0, 2 * np.pi, AROUND, endpoint=False)


def of_sector(ring: Sphincter, turns: FloatArray) -> BoolArray:
    """At which angles (n,) there is some of a ring that may be a half one."""
    if not ring.sector.any():
        return np.ones(len(turns), dtype=np.bool_)
    way = np.cos(turns)[:, None] * ring.long_axis + np.sin(turns)[:, None] * ring.short_axis
    return np.asarray(way @ ring.sector > 0)


def draped(ring: Sphincter, turns: FloatArray, shares: FloatArray, skin: Mesh) -> FloatArray:
    """Places (..., 3) on the skin over points of the plane of a ring.

    Parameters
    ----------
    turns : (...) angles from the long half axis towards the short one
    shares : (..., 2) factors on both half axes; ones are on the ring itself
    skin : whose holes are bridged and whose folds are passed over
    """
    along, up, out = frame_of(ring)
    out = out / np.linalg.norm(out)
    flat = ring.centre + (shares[..., :1] * np.cos(turns)[..., None]) * along
    flat = flat + (shares[..., 1:] * np.sin(turns)[..., None]) * up
    places = flat.reshape(-1, 3)
    height = FAR - ahead(skin, places + FAR * out, np.broadcast_to(-out, places.shape))
    seen = np.isfinite(height)
    seen[seen] = np.abs(height[seen] - np.median(height[seen])) < DEEP if seen.any() else False
    if not seen.any():
        return flat
    smooth = _smooth(turns.ravel(), shares.mean(axis=-1).ravel(), height, seen)
    # What would stand out of the skin goes under it.
    out_of_it = np.where(seen, np.clip(smooth - height, 0.0, DEEPEST), 0.0).reshape(turns.shape)
    modes = [*["nearest"] * (turns.ndim - 1), "wrap" if np.ptp(turns) > WHOLE else "nearest"]
    under = smooth.reshape(turns.shape) - gaussian_filter(out_of_it, EVEN, mode=modes)
    return np.asarray(flat + under[..., None] * out)


def _smooth(turns: FloatArray, share: FloatArray, height: FloatArray, seen: BoolArray) -> FloatArray:
    """Heights (n,) without holes and folds: waves round the ring that change evenly across it."""
    waves = [np.ones_like(turns)]
    for k in range(1, WAVES + 1):
        waves += [np.cos(k * turns), np.sin(k * turns)]
    across = (share - share.mean()) / max(float(np.ptp(share)), 1e-9)
    table = np.stack([wave * across**power for wave in waves for power in range(2)], axis=1)
    if np.ptp(share) < 1e-9:
        table = table[:, ::2]
    weight = seen.astype(np.float64)
    known = np.where(seen, height, 0.0)
    coefficients = np.zeros(table.shape[1])
    for _ in range(ROUNDS):
        root = np.sqrt(weight)[:, None]
        coefficients = np.linalg.lstsq(root * table, root[:, 0] * known, rcond=1e-6)[0]
        off = (table @ coefficients - known) / FOLD
        weight = seen / (1 + off**2) ** 2
    return np.asarray(table @ coefficients)

"""How alike two displacement fields of one surface are."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from fem.types import FloatArray

MOST = 0.5
"""Share of the largest measured displacement from which on skin counts as moving most."""


@dataclass(frozen=True)
class Figures:
    """A solved field against a measured one; the solved one is scaled by `factor` but for the cosine.

    Attributes
    ----------
    cosine : area-weighted, 1 is the same field up to its size
    factor : the non-negative factor on the solved field that brings it nearest to the measured one
    explained : share of the measured variance about rest that the solved field explains
    rms : area-weighted root mean square difference over the whole skin, millimetres
    largest : largest difference, millimetres
    direction : mean angle between both where the measured field is at least `MOST` of its largest, degrees
    measured, solved : largest displacement of each, the solved one as it is, millimetres
    """

    cosine: float
    factor: float
    explained: float
    rms: float
    largest: float
    direction: float
    measured: float
    solved: float


def compare_fields(measured: FloatArray, solved: FloatArray, areas: FloatArray) -> Figures:
    """Compare two fields (N, 3) in millimetres on vertices that stand for some area each (N,)."""
    weights = areas / areas.sum()
    mm, ss, ms = (
        float(np.einsum("n,nc,nc->", weights, a, b))
        for a, b in ((measured, measured), (solved, solved), (measured, solved))
    )
    factor = max(ms / ss, 0.0) if ss > 0 else 0.0
    apart = measured - factor * solved
    off = float(np.einsum("n,nc,nc->", weights, apart, apart))
    size = np.linalg.norm(measured, axis=1)
    return Figures(
        cosine=ms / np.sqrt(mm * ss) if mm > 0 and ss > 0 else 0.0,
        factor=factor,
        explained=1 - off / mm if mm > 0 else 0.0,
        rms=float(np.sqrt(off)),
        largest=float(np.linalg.norm(apart, axis=1).max()),
        direction=_direction(measured, solved, weights, size),
        measured=float(size.max()),
        solved=float(np.linalg.norm(solved, axis=1).max()),
    )


def _direction(measured: FloatArray, solved: FloatArray, weights: FloatArray, size: FloatArray) -> float:
    most = size >= MOST * max(float(size.max()), np.finfo(np.float64).tiny)
    lengths = np.maximum(size[most] * np.linalg.norm(solved[most], axis=1), np.finfo(np.float64).tiny)
    cosines = np.clip(np.einsum("nc,nc->n", measured[most], solved[most]) / lengths, -1.0, 1.0)
    if not most.any():
        return 0.0
    return float(np.degrees(np.average(np.arccos(cosines), weights=weights[most])))

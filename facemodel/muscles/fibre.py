"""The linear fibre of Koch, Gross and Bosshard 1998, eqs. 1 to 10, and the fan between central fibres."""

from __future__ import annotations

import numpy as np

from facemodel.mesh import Mesh
from facemodel.muscles.muscle import Fibre, Muscle
from fem.types import FloatArray

SHORTEST = 1e-6
"""Millimetres; below this a fibre has no direction."""


def longitudinal(epsilon: FloatArray, kappa: float) -> FloatArray:
    """Weight along the fibre, T1 (eq. 7): 0 at the origin, about 1 at the attachment."""
    e = np.clip(epsilon, 0.0, 1.0) ** kappa
    return np.asarray(np.sin(np.pi / 2 * e) + (np.sin(2 * np.pi * e - np.pi / 2) + 1) / 8)


def lateral(gamma: FloatArray) -> FloatArray:
    """Weight across the fibre, T2 (eq. 8): 1 on it, 0 at its width and beyond."""
    return np.asarray(np.where(gamma < 1, (np.cos(np.pi * np.minimum(gamma, 1.0) ** 1.8) + 1) / 2, 0.0))


def fan(fibres: tuple[Fibre, ...], count: int) -> tuple[FloatArray, FloatArray]:
    """Origins and attachments (n, 3) of the fibres spread evenly between the central ones.

    The central fibres are taken in order as the spine of the muscle; a muscle with one central fibre has
    only that.
    """
    origins = np.array([f.origin for f in fibres])
    attachments = np.array([f.attachment for f in fibres])
    if len(fibres) == 1:
        return origins, attachments
    at = np.linspace(0, len(fibres) - 1, count)
    low = np.minimum(at.astype(int), len(fibres) - 2)
    share = (at - low)[:, None]
    return (
        origins[low] * (1 - share) + origins[low + 1] * share,
        attachments[low] * (1 - share) + attachments[low + 1] * share,
    )


def fibre_forces(muscle: Muscle, skin: Mesh) -> FloatArray:
    """Force per area (N, 3) on the skin, N/mm^2, of a muscle made of linear fibres (eqs. 9 and 10).

    The fibres of the fan are averaged, so that the number of generated fibres changes the grain and not the
    strength. Beyond the paper, no force acts further than the width past the attachment, where eq. 7 would
    stay at one.
    """
    origins, attachments = fan(muscle.fibres, muscle.count)
    x, normals = skin.positions, skin.normals
    total = np.zeros_like(x)
    nearest = np.linalg.norm(x[:, None] - attachments[None], axis=2).argmin(axis=0)
    for origin, attachment, at in zip(origins, attachments, nearest, strict=True):
        length = np.linalg.norm(origin - attachment)
        if length < SHORTEST:
            continue
        m = (origin - attachment) / length
        n = normals[at] - (normals[at] @ m) * m
        n /= max(float(np.linalg.norm(n)), SHORTEST)
        rho = (origin - x) @ m
        p = x - origin + rho[:, None] * m
        omega = np.linalg.norm(p - (p @ n)[:, None] * n, axis=1)
        depth = np.abs(p @ n)
        epsilon = rho / length
        weight = longitudinal(epsilon, muscle.kappa) * lateral(omega / muscle.width)
        weight *= lateral(np.maximum(rho - length, 0.0) / muscle.width)
        weight *= lateral(depth / max(length, muscle.width))
        weight[rho < 0] = 0.0
        total += weight[:, None] * m
    return np.asarray(muscle.strength / len(origins) * total)

"""The linear fibre of Koch, Gross and Bosshard 1998, eqs. 1 to 10, and the fan between central fibres."""

from __future__ import annotations

import numpy as np

from facemodel.mesh import Mesh
from facemodel.muscles.muscle import Fibre, Muscle
from fem.types import FloatArray, IntArray

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
    length = np.linalg.norm(origins - attachments, axis=1)
    whole = length > SHORTEST
    if not whole.any():
        return np.zeros_like(skin.positions)
    origins, attachments, length = origins[whole], attachments[whole], length[whole]
    m = (origins - attachments) / length[:, None]
    x = skin.positions
    near = _near(x, origins, attachments, muscle.width)
    n = _normals_across(skin, attachments, m)
    offset = x[near][None] - origins[:, None]
    rho = -np.einsum("fic,fc->fi", offset, m)
    p = offset + rho[:, :, None] * m[:, None]
    depth = np.einsum("fic,fc->fi", p, n)
    omega = np.linalg.norm(p - depth[:, :, None] * n[:, None], axis=2)
    beyond = np.maximum(rho - length[:, None], 0.0)
    reach = np.maximum(length, muscle.width)[:, None]
    weight = longitudinal(rho / length[:, None], muscle.kappa) * lateral(omega / muscle.width)
    weight *= lateral(beyond / muscle.width) * lateral(np.abs(depth) / reach) * (rho >= 0)
    total = np.zeros_like(x)
    total[near] = muscle.strength / len(m) * (weight.T @ m)
    return total


def _near(x: FloatArray, origins: FloatArray, attachments: FloatArray, width: float) -> IntArray:
    """Vertices (n,) in the box around a muscle, outside of which no force acts."""
    ends = np.concatenate([origins, attachments])
    longest = float(np.linalg.norm(origins - attachments, axis=1).max())
    # The farthest force: a width past the attachment, a width aside and as deep as the fibre is long.
    reach = np.sqrt(2 * width**2 + max(longest, width) ** 2)
    inside = (x > ends.min(axis=0) - reach) & (x < ends.max(axis=0) + reach)
    return np.flatnonzero(inside.all(axis=1))


def _normals_across(skin: Mesh, attachments: FloatArray, m: FloatArray) -> FloatArray:
    """Normals (f, 3) of the skin at the attachments, made perpendicular to the fibres."""
    n = skin.normals[skin.tree.query(attachments)[1]]
    n = n - np.einsum("fc,fc->f", n, m)[:, None] * m
    return np.asarray(n / np.maximum(np.linalg.norm(n, axis=1, keepdims=True), SHORTEST))

"""The linear fibre of Koch, Gross and Bosshard 1998, eqs. 1 to 10, and the fan between central fibres."""

from __future__ import annotations

import numpy as np

from facemodel.mesh import Mesh
from facemodel.muscles.curve import SHORTEST, STEPS, curves, feet, paths
from facemodel.muscles.muscle import Fibre, Muscle
from fem.types import FloatArray, IntArray


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
    """Force per area (N, 3) on the skin, N/mm^2, of a muscle made of fibres (eqs. 9 and 10).

    The fibres of the fan are averaged, so that the number of generated fibres changes the grain and not the
    strength. Beyond the paper, no force acts further than the width past the attachment, where eq. 7 would
    stay at one; and a bent fibre pulls along its tangent at the nearest point, with its arclength in place of
    the distance between its ends.

    The printed formulas give n_j as the difference of the normals at both ends, which vanishes on a flat skin;
    the average of eq. 1's prose is meant, and the skin's normal at the attachment is taken for it. Eq. 6 says
    that gamma is zero outside the width, where eq. 8 would be largest; there the weight is zero.
    """
    if any(fibre.via for fibre in muscle.fibres):
        return _bent_forces(muscle, skin)
    return _straight_forces(muscle, skin)


def _straight_forces(muscle: Muscle, skin: Mesh) -> FloatArray:
    origins, attachments = fan(muscle.fibres, muscle.count)
    length = np.linalg.norm(origins - attachments, axis=1)
    whole = length > SHORTEST
    if not whole.any():
        return np.zeros_like(skin.positions)
    origins, attachments, length = origins[whole], attachments[whole], length[whole]
    m = (origins - attachments) / length[:, None]
    x = skin.positions
    near = _near(x, np.concatenate([origins, attachments]), float(length.max()), muscle.width)
    n = _normals_across(skin, attachments, m)
    offset = x[near][None] - origins[:, None]
    rho = -np.einsum("fic,fc->fi", offset, m)
    p = offset + rho[:, :, None] * m[:, None]
    depth = np.einsum("fic,fc->fi", p, n)
    omega = np.linalg.norm(p - depth[:, :, None] * n[:, None], axis=2)
    weight = _weight(muscle, rho, omega, depth, np.broadcast_to(length[:, None], rho.shape))
    total = np.zeros_like(x)
    total[near] = muscle.strength / len(m) * (weight.T @ m)
    return total


def _bent_forces(muscle: Muscle, skin: Mesh) -> FloatArray:
    points = paths(muscle.fibres, muscle.count)
    bent = curves(points, skin.normals[skin.tree.query(points[:, -1])[1]]).whole
    total = np.zeros_like(skin.positions)
    if not len(bent.length):
        return total
    longest = float(bent.length.max())
    near = _near(skin.positions, bent.points.reshape(-1, 3), longest, muscle.width)
    at = feet(bent, skin.positions[near], _reach(longest, muscle.width) + longest / STEPS)
    depth = np.einsum("pc,pc->p", at.offset, at.across)
    omega = np.linalg.norm(at.offset - depth[:, None] * at.across, axis=1)
    weight = _weight(muscle, at.rho, omega, depth, bent.length[at.curve])
    for axis in range(3):
        total[near, axis] = np.bincount(at.place, weight * at.pull[:, axis], len(near))
    return np.asarray(muscle.strength / len(bent.length) * total)


def _weight(muscle: Muscle, rho: FloatArray, omega: FloatArray, depth: FloatArray, length: FloatArray) -> FloatArray:
    """Weight of fibres of some ``length`` at distances along, across and below them; all of one shape."""
    beyond, reach = rho - length, np.maximum(length, muscle.width)
    reached = (rho >= 0) & (beyond < muscle.width) & (omega < muscle.width) & (np.abs(depth) < reach)
    rho, length, reach = rho[reached], length[reached], reach[reached]
    some = longitudinal(rho / length, muscle.kappa) * lateral(omega[reached] / muscle.width)
    some *= lateral(np.maximum(beyond[reached], 0.0) / muscle.width) * lateral(np.abs(depth[reached]) / reach)
    weight = np.zeros_like(omega)
    weight[reached] = some
    return weight


def _near(x: FloatArray, places: FloatArray, longest: float, width: float) -> IntArray:
    """Vertices (n,) in the box around the places of a muscle, outside of which no force acts."""
    reach = _reach(longest, width)
    inside = (x > places.min(axis=0) - reach) & (x < places.max(axis=0) + reach)
    return np.flatnonzero(inside.all(axis=1))


def _reach(longest: float, width: float) -> float:
    """The farthest force: a width past the attachment, a width aside and as deep as the fibre is long."""
    return float(np.sqrt(2 * width**2 + max(longest, width) ** 2))


def _normals_across(skin: Mesh, attachments: FloatArray, m: FloatArray) -> FloatArray:
    """Normals (f, 3) of the skin at the attachments, made perpendicular to the fibres."""
    n = skin.normals[skin.tree.query(attachments)[1]]
    n = n - np.einsum("fc,fc->f", n, m)[:, None] * m
    return np.asarray(n / np.maximum(np.linalg.norm(n, axis=1, keepdims=True), SHORTEST))

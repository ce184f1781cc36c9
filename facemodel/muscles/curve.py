"""Fibres that bend over the bone: a smooth curve through their points, its length, its frames, its nearest point."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.interpolate import CubicSpline

from facemodel.muscles.muscle import Fibre
from fem.types import FloatArray, IntArray

STEPS = 16
"""Segments of equal length into which a curve is cut: a quarter circle is then 0.04 % short."""

FINE = 8
"""Points per segment from which equal lengths are read off."""

SHORTEST = 1e-6
"""Millimetres; below this a fibre has no direction."""


@dataclass(frozen=True, eq=False)
class Curves:
    """Several curves, cut into `STEPS` segments of equal length each.

    Attributes
    ----------
    points : (f, STEPS + 1, 3) from origin to attachment, millimetres
    pull : (f, STEPS + 1, 3) unit tangents towards the origin
    across : (f, STEPS + 1, 3) unit normals, perpendicular to the tangents and carried along without turning
    length : (f,) millimetres
    """

    points: FloatArray
    pull: FloatArray
    across: FloatArray
    length: FloatArray

    @property
    def whole(self) -> Curves:
        """Only the curves that have a length, which alone have a direction."""
        keep = self.length > SHORTEST
        return Curves(self.points[keep], self.pull[keep], self.across[keep], self.length[keep])


@dataclass(frozen=True, eq=False)
class Feet:
    """The nearest points of curves on places, as P pairs of a curve and a place that lie near enough.

    Attributes
    ----------
    curve, place : (P,) which two
    offset : (P, 3) from the nearest point to the place
    rho : (P,) arclength from the origin; negative behind it, larger than the length past the attachment
    pull, across : (P, 3) tangent and normal of the curve there
    """

    curve: IntArray
    place: IntArray
    offset: FloatArray
    rho: FloatArray
    pull: FloatArray
    across: FloatArray


def path(fibre: Fibre, steps: int = STEPS) -> FloatArray:
    """Points (steps + 1, 3) at equal lengths along a fibre, straight or bent, from origin to attachment.

    A bent fibre is the natural cubic spline through its points over the length of their chords.
    """
    points = fibre.points
    gaps = np.linalg.norm(np.diff(points, axis=0), axis=1)
    apart = np.append(True, gaps > SHORTEST)
    points, chord = points[apart], np.append(0.0, np.cumsum(gaps[gaps > SHORTEST]))
    if len(points) < 3:
        ends = fibre.origin, fibre.attachment
        return np.asarray(np.linspace(*ends, steps + 1))
    spline = CubicSpline(chord, points, bc_type="natural")
    # The given points are among the fine ones, so that no knot is cut off.
    fine = np.unique(np.concatenate([np.linspace(0, chord[-1], FINE * steps + 1), chord]))
    run = spline(fine)
    reached = np.append(0.0, np.cumsum(np.linalg.norm(np.diff(run, axis=0), axis=1)))
    at = np.interp(np.linspace(0, reached[-1], steps + 1), reached, fine)
    line = spline(at)
    line[0], line[-1] = fibre.origin, fibre.attachment
    return np.asarray(line)


def paths(fibres: tuple[Fibre, ...], count: int, steps: int = STEPS) -> FloatArray:
    """Points (n, steps + 1, 3) of the fan of ``count`` fibres spread evenly between the central ones.

    The central fibres are taken in order as the spine of the muscle; a muscle with one central fibre has
    only that.
    """
    central = np.array([path(fibre, steps) for fibre in fibres])
    if len(fibres) == 1:
        return central
    at = np.linspace(0, len(fibres) - 1, count)
    low = np.minimum(at.astype(int), len(fibres) - 2)
    share = (at - low)[:, None, None]
    return np.asarray(central[low] * (1 - share) + central[low + 1] * share)


def curves(points: FloatArray, normals: FloatArray) -> Curves:
    """Tangents, normals and lengths of paths (f, STEPS + 1, 3) whose skin normals at the attachments are (f, 3)."""
    step = np.diff(points, axis=1)
    length = np.linalg.norm(step, axis=2).sum(axis=1)
    slope = np.concatenate([step[:, :1], step[:, 1:] + step[:, :-1], step[:, -1:]], axis=1)
    if points.shape[1] > 2:
        # A parabola through the last three points meets the end of a curve better than its last chord does.
        slope[:, 0] = 3 * step[:, 0] - step[:, 1]
        slope[:, -1] = 3 * step[:, -1] - step[:, -2]
    pull = -_unit(slope)
    across = np.empty_like(pull)
    normal = normals
    for k in range(points.shape[1] - 1, -1, -1):
        normal = _unit(normal - np.einsum("fc,fc->f", normal, pull[:, k])[:, None] * pull[:, k])
        across[:, k] = normal
    return Curves(points, pull, across, length)


def feet(of: Curves, places: FloatArray, within: float) -> Feet:
    """The nearest points of every curve on places (n, 3); the end segments go on straight past the ends.

    Pairs whose nearest cut is farther apart than ``within`` millimetres are left out.
    """
    points, steps = of.points, of.points.shape[1] - 1
    knots = points.reshape(-1, 3)
    away = (-2.0 * places) @ knots.T
    away += np.einsum("kc,kc->k", knots, knots)
    away = away.reshape(-1, steps + 1)
    near = away.argmin(axis=1).reshape(len(places), -1)
    least = np.take_along_axis(away, near.reshape(-1, 1), axis=1).reshape(near.shape)
    place, curve = np.nonzero(least + np.einsum("nc,nc->n", places, places)[:, None] < within**2)
    knot = near[place, curve]
    offset = places[place] - points[curve, knot]
    before, ahead = np.maximum(knot - 1, 0), np.minimum(knot, steps - 1)
    endless = np.inf
    back, won_back = _abreast(
        offset,
        points[curve, before + 1] - points[curve, before],
        np.where(knot > 1, -1.0, -endless),
        np.where(knot == steps, endless, 0.0),
    )
    ahead_step = points[curve, ahead + 1] - points[curve, ahead]
    forth, won_forth = _abreast(
        offset, ahead_step, np.where(knot == 0, -endless, 0.0), np.where(knot < steps - 1, 1.0, endless)
    )
    forward = (knot == 0) | (knot < steps) & (won_forth >= won_back)
    segment = np.where(forward, ahead, before)
    share = np.where(forward, forth, back + 1.0)[:, None]
    inside = np.clip(share, 0.0, 1.0)
    foot = points[curve, segment] * (1 - share) + points[curve, segment + 1] * share
    pull = of.pull[curve, segment] * (1 - inside) + of.pull[curve, segment + 1] * inside
    across = of.across[curve, segment] * (1 - inside) + of.across[curve, segment + 1] * inside
    rho = (segment + share[:, 0]) * (of.length / steps)[curve]
    return Feet(curve, place, places[place] - foot, rho, _unit(pull), _unit(across))


def _abreast(
    offset: FloatArray, step: FloatArray, least: FloatArray, most: FloatArray
) -> tuple[FloatArray, FloatArray]:
    """Share of a step (P, 3) that lies abreast of an offset from its start or end, and how much nearer that is."""
    square = np.maximum(np.einsum("pc,pc->p", step, step), SHORTEST**2)
    free = np.einsum("pc,pc->p", offset, step) / square
    share = np.clip(free, least, most)
    return share, square * share * (2 * free - share)


def _unit(vectors: FloatArray) -> FloatArray:
    return np.asarray(vectors / np.maximum(np.linalg.norm(vectors, axis=-1, keepdims=True), SHORTEST))

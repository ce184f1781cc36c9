"""Fit a skull from elsewhere to a head by landmarks: turned, moved and scaled differently along its axes, or bent.

Koch et al. 1998 (section 4.1) scale a template skull non-proportionally to the face; the counterpart of a landmark on
bone is the place that lies as deep under the same landmark of the skin as tables of tissue depth say.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal

import numpy as np
from scipy.interpolate import RBFInterpolator
from scipy.optimize import least_squares
from scipy.spatial.transform import Rotation

from facemodel.errors import SkullError
from facemodel.face import Face
from facemodel.skull.placement import carried
from facemodel.skull.tissue_depths import table
from fem.types import FloatArray

Kind = Literal["alike", "axes", "bent"]
"""How a skull may be scaled: alike in all directions, along each axis by itself, or that and bent to the landmarks."""

KINDS: Mapping[Kind, str] = {"alike": "Alike", "axes": "By axis", "bent": "Bent"}

FEWEST = 4
"""Landmarks by which a skull can be fitted; three would leave one direction unscaled."""

FLATTEST = 0.02
"""Smallest over largest extent of the landmarks below which they lie on a line."""

EVEN = 4.0
"""Millimetres of residual that a factor of e in the scale of one axis counts as much as: landmarks that lie in a plane
do not say how deep a skull is, and it is then as deep as it is wide."""

UNITS = np.array([1e-2, 1e-2, 1e-2, 1.0, 1.0, 1.0, 1e-2, 1e-2, 1e-2])
"""Changes of turn (radians), place (millimetres) and logarithm of the scale that move bone about as far."""


@dataclass(frozen=True, eq=False)
class SkullFit:
    """How a skull is carried from its own axes and unit to a head.

    Attributes
    ----------
    way : (4, 4) affine
    scale : along the skull's own axes x, y and z
    bend : what is left after it, spread over space; none where the skull is not bent
    residuals : millimetres by landmark between where it comes to lie and where it should
    """

    way: FloatArray
    scale: FloatArray
    bend: RBFInterpolator | None
    residuals: Mapping[str, float]

    def __call__(self, points: FloatArray) -> FloatArray:
        """Where points (n, 3) of the skull come to lie, millimetres."""
        moved = carried(points, self.way)
        return moved if self.bend is None else moved + np.asarray(self.bend(moved))

    @property
    def rms(self) -> float:
        """Of the residuals, millimetres."""
        left = np.array(list(self.residuals.values()))
        return float(np.sqrt((left**2).mean())) if len(left) else 0.0


def bone_targets(face: Face) -> dict[str, FloatArray]:
    """Where (3,) on a head bone should lie by landmark: along its spring, as deep as the tables say."""
    skull = face.skull
    feet = skull.placement.feet if len(skull.placement.feet) else skull.anchors
    found = {}
    for name, depth in table().items():
        if name in face.landmarks:
            start = face.skin.positions[face.landmarks[name]]
            inward = feet[face.landmarks[name]] - start
            length = float(np.linalg.norm(inward))
            found[name] = start + depth * (inward / length if length > 0 else -face.skin.normals[face.landmarks[name]])
    return found


def fitted(picked: Mapping[str, FloatArray], wanted: Mapping[str, FloatArray], kind: Kind = "axes") -> SkullFit:
    """The fit of a skull by landmarks.

    Parameters
    ----------
    picked : places (3,) by name on the skull, in its own axes and unit
    wanted : places (3,) by name where they should come to lie, millimetres
    kind : how it may be scaled

    Raises
    ------
    SkullError
        If both share fewer than three landmarks, or these lie on a line.
    """
    names = [name for name in picked if name in wanted]
    if len(names) < 3:
        raise SkullError(f"{len(names)} landmarks are picked on the skull and at least {FEWEST} are needed; pick more.")
    start, goal = (np.array([places[name] for name in names]) for places in (picked, wanted))
    for places, whose in ((start, "skull"), (goal, "head")):
        extent = np.linalg.svd(places - places.mean(axis=0), compute_uv=False)
        if extent[1] <= FLATTEST * extent[0]:
            raise SkullError(f"The landmarks on the {whose} lie on a line; pick some beside it.")
    way, scale = similarity(start, goal)
    if kind != "alike":
        way, scale = by_axes(start, goal, way, scale)
    left = goal - carried(start, way)
    bend = None
    if kind == "bent" and len(names) >= FEWEST:
        # A degree lower than usual: what an affine map can do is done, and far from the landmarks nothing is bent.
        bend = RBFInterpolator(carried(start, way), left, kernel="linear", degree=0)
        left = goal - carried(start, way) - bend(carried(start, way))
    away = np.linalg.norm(left, axis=1)
    return SkullFit(way, scale, bend, dict(zip(names, away.tolist(), strict=True)))


def similarity(start: FloatArray, goal: FloatArray) -> tuple[FloatArray, FloatArray]:
    """The turn, move and one scale (Umeyama 1991) that take points (n, 3) nearest to others: (4, 4), and scale (3,)."""
    middle, aim = start.mean(axis=0), goal.mean(axis=0)
    u, spread, vt = np.linalg.svd((goal - aim).T @ (start - middle))
    turned = np.array([1.0, 1.0, np.sign(np.linalg.det(u @ vt))])
    turn = (u * turned) @ vt
    size = float((spread * turned).sum() / ((start - middle) ** 2).sum())
    return _way(size * turn, middle, aim), np.full(3, size)


def by_axes(start: FloatArray, goal: FloatArray, way: FloatArray, scale: FloatArray) -> tuple[FloatArray, FloatArray]:
    """The turn, move and scales along the own axes that take points (n, 3) nearest to others, from a first guess."""
    middle = start.mean(axis=0)
    offset = start - middle
    turn = Rotation.from_matrix(way[:3, :3] / scale).as_rotvec()
    aim = carried(middle[None], way)[0]

    def left(numbers: FloatArray) -> FloatArray:
        linear = Rotation.from_rotvec(numbers[:3]).as_matrix() * np.exp(numbers[6:])
        missed = offset @ linear.T + numbers[3:6] - goal
        return np.concatenate([missed.ravel(), EVEN * (numbers[6:] - numbers[6:].mean())])

    found = least_squares(left, np.concatenate([turn, aim, np.log(scale)]), x_scale=UNITS, method="lm").x
    own = np.exp(found[6:])
    return _way(Rotation.from_rotvec(found[:3]).as_matrix() * own, middle, found[3:6]), own


def _way(linear: FloatArray, middle: FloatArray, aim: FloatArray) -> FloatArray:
    way = np.eye(4)
    way[:3, :3] = linear
    way[:3, 3] = aim - linear @ middle
    return way

"""How deep skin is in what it meets, found on the drawn triangles alone: by none of the rules that keep it apart."""

from __future__ import annotations

from collections.abc import Iterator

import igl
import numpy as np
from scipy.spatial import KDTree

from facemodel.actions import Expression
from facemodel.basis import Basis
from facemodel.contact.drawn import BESIDE_CORNER
from facemodel.face import Eye, Face
from facemodel.openings import mouth_of, on_upper_side
from facemodel.superposition import Superposition
from fem.types import BoolArray, FloatArray, IntArray

LIP = 8.0
"""Millimetres from the edge of a lip within which its skin may meet something."""

CORNER = 0.9
"""Share of half the mouth up to which there are two lips; in its corners one piece of skin creases."""

AROUND = 10.0
"""Millimetres from that edge up to which the other lip is one surface."""

THICK = 8.0
"""Millimetres; what is farther behind a lip than that is not in it but in the open mouth, before its other end."""

BACK = 12.0
"""Millimetres that the back of a lip goes on beyond the edge at which its skin ends, as its flesh does."""

INSIDE = 0.5
"""Winding number from which on a place is in a lip.  A place behind its skin need not be: in an open mouth, or with one
lip behind the other one, what is nearest may face away and yet be met nowhere."""

NOTHING = 0.02
"""Millimetres that nobody sees: lips that lie on each other."""

ON_EDGE = 1e-3
"""Barycentric coordinates below this are on the edge of a triangle."""

SIGHTS = ((0, 0), (0, -25), (0, 20), (35, 0), (-35, 0))
"""Degrees to the left and up from the front from which one looks at a closed eye."""

STEP = 0.06
"""Millimetres between lines of sight, across the slit of the lids."""

SKIN_DEEP = 0.3
"""Millimetres behind the eyeball's front within which a lid still covers it: what is drawn is no sphere."""


def random_mixes(names: tuple[str, ...], count: int, seed: int = 0) -> Iterator[dict[str, float]]:
    """Expressions of one to all fields, each at any weight up to 1; half of them of no more than seven."""
    random = np.random.default_rng(seed)
    for k in range(count):
        some = int(random.integers(1, len(names) + 1) if k % 2 else random.integers(1, 8))
        chosen = random.choice(names, some, replace=False).tolist()
        yield dict(zip(chosen, random.uniform(0, 1, some).tolist(), strict=True))


class MouthDepths:
    """Measures lips in each other and in the teeth.

    Parameters
    ----------
    face, basis : what is posed
    """

    def __init__(self, face: Face, basis: Basis) -> None:
        mouth = mouth_of(face)
        assert mouth is not None
        display = basis.display
        side = on_upper_side(face.skin, mouth, BESIDE_CORNER)[face.skin.triangles[display.elements]]
        upper = np.einsum("pk,pk->p", display.barycentric, side.astype(np.float64)) > 0.5
        edge = face.skin.positions[np.concatenate([mouth.upper, mouth.lower])]
        away = KDTree(edge).query(display.points)[0]
        right, left = face.skin.positions[list(mouth.corners)][:, 0]
        along = np.abs(display.points[:, 0] - (right + left) / 2) / (left - right) * 2
        lips, other = (away < LIP) & (along < CORNER), (away < AROUND) & (along < 1)
        self._lips = tuple(np.flatnonzero(lips & (upper == up)) for up in (True, False))
        self._patches = tuple(_patch(display.triangles, other & (upper == up)) for up in (True, False))
        loops = igl.boundary_loop_all(display.triangles)
        margin = np.isin(np.arange(len(display.points)), np.concatenate([np.array(loop) for loop in loops]))
        self._inner = tuple(_inner_edge(patch, margin) for patch in self._patches)
        rows = [part for part in face.parts if part.kind == "teeth"]
        self._teeth = tuple((row.name, _patch(row.mesh.triangles, _all(row.mesh.positions))) for row in rows)

    def in_each_other(self, posed: Superposition) -> float:
        """How far the skin of one lip is behind the nearest place of the other one, millimetres at most."""
        points = posed.points.astype(np.float64)
        deepest = 0.0
        for number, sign in ((0, 1.0), (1, -1.0)):
            lip = points[self._lips[1 - number]]
            behind = _behind(lip, self._patches[number], points)
            deep = np.flatnonzero(behind > max(deepest, NOTHING))
            if len(deep):
                flesh = _flesh(points, self._patches[number][0], self._inner[number], sign)
                inside = igl.winding_number(*flesh, lip[deep]) > INSIDE
                deepest = max(deepest, float(behind[deep][inside].max(initial=0.0)))
        return deepest

    def in_teeth(self, posed: Superposition) -> float:
        """How far the skin of a lip is behind the front of a row of teeth, millimetres at most."""
        lips = posed.points[np.concatenate(self._lips)].astype(np.float64)
        return max(_within(lips, posed.parts[name].astype(np.float64), patch) for name, patch in self._teeth)


Patch = tuple[IntArray, BoolArray]
"""Triangles (T, 3), and which of all points (P,) lie on their border."""


def _all(points: FloatArray) -> BoolArray:
    return np.ones(len(points), dtype=np.bool_)


def _patch(triangles: IntArray, chosen: BoolArray) -> Patch:
    own = np.ascontiguousarray(triangles[chosen[triangles].all(axis=1)])
    border = np.zeros(len(chosen), dtype=np.bool_)
    border[np.concatenate([np.array(loop) for loop in igl.boundary_loop_all(own)])] = True
    return own, border


def _inner_edge(patch: Patch, margin: BoolArray) -> IntArray:
    """The border edges (n, 2) of a lip at which all skin ends, in the direction in which its triangles have them.

    Parameters
    ----------
    margin : (P,) which points lie on the border of all skin
    """
    loops = [np.array(loop) for loop in igl.boundary_loop_all(patch[0])]
    steps = np.concatenate([np.stack([loop, np.roll(loop, -1)], axis=1) for loop in loops])
    return np.asarray(steps[margin[steps].all(axis=1)])


def _flesh(surface: FloatArray, lip: IntArray, inner: IntArray, sign: float) -> tuple[FloatArray, IntArray]:
    """A lip with its back, straight up (sign 1) or down (-1) from the edge at which its skin ends within the mouth."""
    first = len(surface)
    ends = surface[inner.ravel()] + sign * BACK * np.array([0.0, 1.0, 0.0])
    over = first + np.arange(len(ends)).reshape(-1, 2)
    one, other = inner.T
    back = np.concatenate([np.stack([other, one, over[:, 0]], axis=1), np.stack([other, *over.T], axis=1)])
    return np.concatenate([surface, ends]), np.concatenate([lip, back])


def _behind(points: FloatArray, patch: Patch, surface: FloatArray) -> FloatArray:
    """How far (n,) points (n, 3) are behind a surface; what is nearest to its border is beside it."""
    triangles, border = patch
    kind = igl.SIGNED_DISTANCE_TYPE_PSEUDONORMAL
    signed, at, nearest, _ = igl.signed_distance(points, surface, triangles, kind)
    corners = surface[triangles[at]]
    opposite = [np.cross(corners[:, (k + 1) % 3] - nearest, corners[:, (k + 2) % 3] - nearest) for k in range(3)]
    share = np.linalg.norm(np.stack(opposite, axis=1), axis=2)
    share /= share.sum(axis=1, keepdims=True) + 1e-12
    beside = ((share < ON_EDGE) | border[triangles[at]]).all(axis=1) | (signed < -THICK)
    return np.asarray(np.where(beside, 0.0, np.maximum(-signed, 0.0)))


def _within(points: FloatArray, teeth: FloatArray, patch: Patch) -> float:
    near = points[((points > teeth.min(axis=0)) & (points < teeth.max(axis=0))).all(axis=1)]
    return float(_behind(near, patch, teeth).max()) if len(near) else 0.0


def seen_of_eyeball(eye: Eye, posed: Superposition) -> float:
    """Height of what is seen of an eyeball between its lids, from wherever it is seen most, millimetres."""
    points, triangles = posed.points.astype(np.float64), np.ascontiguousarray(posed.basis.display.triangles)
    tree = igl.AABB()
    tree.init(points, triangles)
    across, up = np.meshgrid(
        np.linspace(-0.95, 0.95, 60) * eye.radius, np.arange(-0.8 * eye.radius, 0.8 * eye.radius, STEP), indexing="ij"
    )
    bulge = np.sqrt(np.maximum(eye.radius**2 - across**2 - up**2, 0.0))
    met = bulge > 0.2 * eye.radius
    most = 0.0
    for yaw, pitch in np.radians(SIGHTS):
        sight = -np.array([np.sin(yaw) * np.cos(pitch), np.sin(pitch), np.cos(yaw) * np.cos(pitch)])
        right = np.cross([0.0, 1.0, 0.0], sight) / np.cos(pitch)
        start = eye.centre + across[met][:, None] * right + up[met][:, None] * np.cross(sight, right)
        start -= 4 * eye.radius * sight
        hit, far, _ = tree.intersect_ray_first(points, triangles, start, np.tile(sight, (len(start), 1)))
        covered = (np.asarray(hit) >= 0) & (far < 4 * eye.radius - bulge[met] + SKIN_DEEP)
        seen = np.zeros(met.shape, dtype=np.bool_)
        seen[met] = ~covered
        most = max(most, float(seen.sum(axis=1).max() * STEP))
    return most


def in_eyeball(eye: Eye, posed: Superposition) -> float:
    """How far the skin of the lids is within an eyeball, millimetres; below zero outside of it."""
    rest = posed.basis.display.points - eye.centre
    near = (np.linalg.norm(rest, axis=1) < eye.radius + 5.0) & (rest[:, 2] > 0.4 * eye.radius)
    return float((eye.radius - np.linalg.norm(posed.points[near] - eye.centre, axis=1)).max())


def worst_mix(
    depths: MouthDepths, posed: Superposition, mixes: Iterator[Expression]
) -> tuple[float, float, Expression]:
    """The deepest that lips are in each other and in the teeth over many mixes, and the mix in which they are."""
    lips = teeth = 0.0
    worst: Expression = {}
    for mix in mixes:
        posed.pose(mix)
        in_lips, in_teeth = depths.in_each_other(posed), depths.in_teeth(posed)
        if max(in_lips, in_teeth) > max(lips, teeth):
            worst = dict(mix)
        lips, teeth = max(lips, in_lips), max(teeth, in_teeth)
    return lips, teeth, worst

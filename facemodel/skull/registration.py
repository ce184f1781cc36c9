"""Lay a skull of unknown unit and axes into a head, before anybody has picked a landmark, and say where they may be.

Iterated closest points (Besl and McKay 1992) from all 24 ways in which axes can be named, with the share of the worst
pairs left out (Chetverikov et al. 2002): one skull may lack its jaw, the other the back of its head.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from itertools import permutations, product

import numpy as np
from scipy.spatial import KDTree

from facemodel.face import Skull
from facemodel.mesh import Mesh
from facemodel.skull.depths import whole
from facemodel.skull.fitting import by_axes, similarity
from facemodel.skull.placement import carried
from fem.types import FloatArray

SAMPLES = 700
"""Vertices of each skull that are paired."""

KEPT = 0.85
"""Share of the pairs that count, the nearest ones."""

FIRST_ROUNDS, LAST_ROUNDS = 12, 40
"""Rounds by which the named axes are told apart, and those after which a skull has settled."""


def quarter_turns() -> FloatArray:
    """The turns (24, 3, 3) that take the axes to axes, the one that changes nothing first."""
    made = []
    for order in permutations(range(3)):
        for signs in product((1.0, -1.0), repeat=3):
            turn = np.zeros((3, 3))
            turn[range(3), order] = signs
            if np.linalg.det(turn) > 0:
                made.append(turn)
    return np.array(made)


@dataclass(frozen=True, eq=False)
class _Pair:
    """Samples (n, 3) of a skull and of the one it is laid on, with their search trees."""

    own: FloatArray
    goal: FloatArray
    goal_tree: KDTree

    def matched(self, way: FloatArray) -> tuple[FloatArray, FloatArray, float]:
        """Paired places of the skull and of the other one, both ways, and how far they are apart on the whole."""
        moved = carried(self.own, way)
        away, there = self.goal_tree.query(moved)
        back, here = KDTree(moved).query(self.goal)
        distance = np.concatenate([away, back])
        near = np.argsort(distance)[: int(KEPT * len(distance))]
        own = np.concatenate([self.own, self.own[here]])[near]
        goal = np.concatenate([self.goal[there], self.goal])[near]
        return own, goal, float(np.sqrt((distance[near] ** 2).mean()))


def laid_on(bone: Mesh, skull: Skull) -> FloatArray:
    """The affine map (4, 4) that lays a skull of any unit and named axes on the skull of a head, scaled by axis."""
    other = whole(skull)
    goal = _samples(other)
    pair = _Pair(_samples(bone), goal, KDTree(goal))
    tried = [_settled(pair, _first(pair, turn), FIRST_ROUNDS) for turn in quarter_turns()]
    way = min(tried, key=lambda each: pair.matched(each)[2])
    way = _settled(pair, way, LAST_ROUNDS)
    for _ in range(LAST_ROUNDS):
        own, goal, _ = pair.matched(way)
        way = by_axes(own, goal, *_parted(way))[0]
    return way


def proposed(bone: Mesh, way: FloatArray, wanted: Mapping[str, FloatArray]) -> dict[str, FloatArray]:
    """Where (3,) on a skull, in its own axes and unit, the landmarks of a head may be: under where they should lie.

    Parameters
    ----------
    way : (4, 4) how the skull lies now
    wanted : places (3,) of the head by name
    """
    moved = bone.moved(carried(bone.positions, way))
    vertices = moved.tree.query(np.array(list(wanted.values())))[1]
    return dict(zip(wanted, bone.positions[vertices], strict=True))


def _samples(mesh: Mesh) -> FloatArray:
    """Places (n, 3) spread evenly over a surface: the vertices, drawn by the area about them."""
    area = mesh.vertex_areas / mesh.vertex_areas.sum()
    chosen = np.random.default_rng(0).choice(len(area), min(SAMPLES, int((area > 0).sum())), replace=False, p=area)
    return np.asarray(mesh.positions[np.sort(chosen)])


def _first(pair: _Pair, turn: FloatArray) -> FloatArray:
    """Turned, and brought to the same middle and size."""
    size = float(np.linalg.norm(pair.goal.std(axis=0)) / np.linalg.norm(pair.own.std(axis=0)))
    way = np.eye(4)
    way[:3, :3] = size * turn
    way[:3, 3] = pair.goal.mean(axis=0) - way[:3, :3] @ pair.own.mean(axis=0)
    return way


def _settled(pair: _Pair, way: FloatArray, rounds: int) -> FloatArray:
    for _ in range(rounds):
        own, goal, _ = pair.matched(way)
        way = similarity(own, goal)[0]
    return way


def _parted(way: FloatArray) -> tuple[FloatArray, FloatArray]:
    """A map, and its scales (3,) along the own axes."""
    return way, np.linalg.norm(way[:3, :3], axis=0)

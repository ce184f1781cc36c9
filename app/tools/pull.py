"""Pull a point of the face; the weights follow that bring it there."""

from __future__ import annotations

from typing import ClassVar

import numpy as np

from app.posing import PointPull
from app.tools.pointer import Pointer, Ray
from app.tools.tool import Bench, Tool
from app.view_state import Workspace
from facemodel.actions import Expression
from facemodel.solution import Solution
from fem.types import FloatArray

STARTS = 3.0
"""Pixels that the hand travels before a press pulls, so that a click changes nothing."""


class PullTool(Tool):
    """Drags a point of the skin in the plane of the picture; with auto-key on, what it does becomes keys."""

    id: ClassVar[str] = "pull"
    title: ClassVar[str] = "Pull the face"
    shortcut: ClassVar[str] = "D"
    hint: ClassVar[str] = "Drag a point of the face: the sliders follow · Esc lets it go back"
    workspaces: ClassVar[frozenset[Workspace]] = frozenset(("expression",))

    def __init__(self, bench: Bench) -> None:
        super().__init__(bench)
        self._pressed: Pointer | None = None
        self._place: FloatArray = np.zeros(3)
        self._pull: PointPull | None = None

    def press(self, pointer: Pointer) -> None:
        """Take hold of a point of the skin; beside the face, of nothing."""
        solution = self.bench.document.solution
        if pointer.skin is None or pointer.ray is None or solution is None:
            return
        point = _drawn_point(solution, pointer.skin.position)
        if point >= solution.basis.display.moving:
            return
        self._pressed, self.busy = pointer, True
        self._place = posed_point(solution, point, self.bench.document.shown)
        self._pull = PointPull(self.bench.document, point, linked=self.bench.view.state.linked)

    def move(self, pointer: Pointer) -> None:
        """The point follows the hand."""
        start = self._pressed
        if start is None or start.ray is None or pointer.ray is None or self._pull is None:
            return
        if max(abs(pointer.x - start.x), abs(pointer.y - start.y)) >= STARTS or self.bench.document.held:
            sight = start.ray.along
            before, now = (_in_plane(ray, self._place, sight) for ray in (start.ray, pointer.ray))
            self._pull.move(self._place + now - before, sight)

    def release(self, pointer: Pointer) -> None:
        """The point stays where it is."""
        self.move(pointer)
        pull, self._pull, self._pressed, self.busy = self._pull, None, None, False
        if pull is not None:
            pull.release()

    def cancel(self) -> None:
        """The face goes back."""
        pull, self._pull, self._pressed, self.busy = self._pull, None, None, False
        if pull is not None:
            pull.cancel()


def posed_point(solution: Solution, point: int, weights: Expression) -> FloatArray:
    """Where (3,) a drawn point of the skin is under some weights."""
    basis = solution.basis
    place = basis.display.points[point].astype(np.float64)
    for name, weight in weights.items():
        if name in basis.index and point < basis.display.moving:
            place = place + weight * basis.moving_field(name)[point]
    return np.asarray(place)


def _drawn_point(solution: Solution, place: FloatArray) -> int:
    """The drawn point of the skin that is nearest to a place on the skin at rest."""
    return int(np.linalg.norm(solution.basis.display.points - place, axis=1).argmin())


def _in_plane(ray: Ray, place: FloatArray, normal: FloatArray) -> FloatArray:
    """Where (3,) a line of sight meets the plane through a place across a direction."""
    along = float(ray.along @ normal)
    return np.asarray(ray.origin + float((place - ray.origin) @ normal) / along * ray.along)

"""Select bone by painting over it."""

from __future__ import annotations

from typing import ClassVar

import numpy as np

from app.tools.bones import taken
from app.tools.pointer import Modifier, Pointer
from app.tools.sight import Ball
from app.tools.tool import Bench, Tool
from app.view_state import Workspace
from facemodel.skull.jaw_region import whole_skull
from fem.types import BoolArray, FloatArray


class BoneBrush(Tool):
    """A stroke selects all bone within a ball about the pointer, through and through; Ctrl takes it out again."""

    id: ClassVar[str] = "bone-brush"
    title: ClassVar[str] = "Paint bone"
    shortcut: ClassVar[str] = "C"
    hint: ClassVar[str] = "Drag over the bone to select it · Ctrl takes out · [ ] size · X both sides"
    workspaces: ClassVar[frozenset[Workspace]] = frozenset(("skull",))
    asks_skin: ClassVar[bool] = False
    asks_skull: ClassVar[bool] = True

    def __init__(self, bench: Bench) -> None:
        super().__init__(bench)
        self._before: BoolArray | None = None
        self._painted: BoolArray = np.zeros(0, dtype=np.bool_)
        self._held: frozenset[Modifier] = frozenset()
        self._last: FloatArray | None = None
        bench.brush.changed.connect(self._resized)
        self._ball: Ball | None = None

    @property
    def usable(self) -> bool:
        """Not while another skull is fitted, in whose place the own one is not seen."""
        return not self.bench.fitting.on

    def press(self, pointer: Pointer) -> None:
        """Begin a stroke."""
        if pointer.skull is None:
            return
        skull = self.bench.document.project.face.skull
        self._before = self.bench.bones.selected(skull)
        self._painted = np.zeros(len(whole_skull(skull).mesh.positions), dtype=np.bool_)
        self._held = frozenset(("control",)) if "control" in pointer.modifiers else frozenset(("shift",))
        self._last, self.busy = None, True
        self.move(pointer)

    def move(self, pointer: Pointer) -> None:
        """Go on with the stroke; beside the bone the brush is lifted."""
        self.hover(pointer)
        if pointer.skull is None:
            self._last = None
            return
        face = self.bench.document.project.face
        bone, place = whole_skull(face.skull).mesh, pointer.skull.position
        start = place if self._last is None else self._last
        self._painted |= _near_way(bone.positions, start, place, self.bench.brush.state.radius)
        self._last = place
        mirror = self.bench.brush.state.mirror
        self.bench.bones.select(face.skull, taken(face, self._before, self._painted, self._held, mirror))

    def release(self, pointer: Pointer) -> None:
        """End the stroke; what it selected stays so."""
        self.busy, self._last = False, None

    def hover(self, pointer: Pointer) -> None:
        """Show what would be selected."""
        hit = pointer.skull
        self._show(None if hit is None else Ball(hit.position, self.bench.brush.state.radius, hit.surface))

    def leave(self) -> None:
        """Take the ball away."""
        self._show(None)

    def cancel(self) -> None:
        """What was selected before the stroke is selected again."""
        if self.busy:
            self.bench.bones.select(self.bench.document.project.face.skull, self._before)
        self.busy, self._last = False, None

    def _show(self, ball: Ball | None) -> None:
        self._ball = ball
        self.bench.sight.ball_changed.emit(ball)

    def _resized(self, *_now: object) -> None:
        if self._ball is not None:
            self._show(Ball(self._ball.centre, self.bench.brush.state.radius, self._ball.surface))


def _near_way(points: FloatArray, start: FloatArray, end: FloatArray, radius: float) -> BoolArray:
    """Which points (n, 3) lie within a radius of the straight way between two places."""
    way = end - start
    share = np.clip((points - start) @ way / max(float(way @ way), 1e-12), 0.0, 1.0)
    return np.asarray(np.linalg.norm(points - start - share[:, None] * way, axis=1) <= radius)

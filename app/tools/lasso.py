"""Select a region of the skin by drawing around it on the screen."""

from __future__ import annotations

from typing import ClassVar

import numpy as np

from app.tools.pointer import Modifier, Pointer
from app.tools.tool import Bench, Tool
from app.view_state import Workspace
from facemodel.painting.mirror import NOBODY
from facemodel.painting.regions import LEAST_CORNERS, lasso
from fem.types import BoolArray, FloatArray, IntArray

NEAREST = 2.0
"""Pixels between two corners of the outline; a hand draws no finer."""


class Outline(Tool):
    """Draws an outline from press to release; what is done with it is that of each tool."""

    def __init__(self, bench: Bench) -> None:
        super().__init__(bench)
        self._corners: list[tuple[float, float]] = []
        self._modifiers: frozenset[Modifier] = frozenset()

    def press(self, pointer: Pointer) -> None:
        """Begin an outline."""
        self.busy, self._corners, self._modifiers = True, [], pointer.modifiers
        self.move(pointer)

    def move(self, pointer: Pointer) -> None:
        """Go on with the outline."""
        here = (pointer.x, pointer.y)
        if not self._corners or np.hypot(*np.subtract(here, self._corners[-1])) >= NEAREST:
            self._corners.append(here)
            self.bench.sight.outline_changed.emit(np.array(self._corners))

    def closed(self, pointer: Pointer) -> tuple[FloatArray, frozenset[Modifier]]:
        """End the outline where the pointer is: its corners (k, 2) in pixels, and the keys that it began with."""
        self.move(pointer)
        corners, modifiers = np.array(self._corners), self._modifiers
        self.cancel()
        return corners, modifiers

    def cancel(self) -> None:
        """Let go of the outline; what was selected stays."""
        self.busy, self._corners = False, []
        self.bench.sight.outline_changed.emit(None)


class LassoTool(Outline):
    """Selects what is seen inside the outline; a click alone selects nothing."""

    id: ClassVar[str] = "lasso"
    title: ClassVar[str] = "Lasso"
    shortcut: ClassVar[str] = "Shift+B"
    hint: ClassVar[str] = "Draw around a region to select it · Shift adds · Ctrl takes away · click to deselect"
    workspaces: ClassVar[frozenset[Workspace]] = frozenset(("tissue",))

    def release(self, pointer: Pointer) -> None:
        """Close the outline and select."""
        corners, modifiers = self.closed(pointer)
        face, regions = self.bench.document.project.face, self.bench.regions
        inside = np.zeros(len(face.skin.positions), dtype=np.bool_)
        if self.bench.projector is not None and len(corners) >= LEAST_CORNERS:
            inside = lasso(corners, *self.bench.projector.skin_on_screen())
        if self.bench.brush.state.mirror:
            inside = both_sides(inside, self.bench.ground.partners(face))
        before = regions.selected(face)
        if before is not None and "shift" in modifiers:
            inside = before | inside
        elif before is not None and "control" in modifiers:
            inside = before & ~inside
        regions.select(face, inside)


def both_sides(region: BoolArray, partners: IntArray) -> BoolArray:
    """A region (N,) with its mirror image."""
    across = np.zeros_like(region)
    paired = partners != NOBODY
    across[paired] = region[partners[paired]]
    return region | across

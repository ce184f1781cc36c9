"""Fill a region with what the brush paints."""

from __future__ import annotations

from typing import ClassVar

import numpy as np

from app.commands import paint_deltas
from app.tools.brush_state import BrushState
from app.tools.lasso import both_sides
from app.tools.pointer import Pointer
from app.tools.tool import Bench, Tool
from app.view_state import Workspace
from facemodel.face import Face
from facemodel.painting.regions import filled, flood
from fem.types import BoolArray

HALF_TURN = 180.0
"""Degrees after which a line is the same again."""


class FillTool(Tool):
    """A click fills the selection it lies in, or else all that is connected with the place and of like value."""

    id: ClassVar[str] = "fill"
    title: ClassVar[str] = "Fill"
    shortcut: ClassVar[str] = "G"
    hint: ClassVar[str] = (
        "Click to fill the selection, or what is connected and of like value · Shift smooths · Ctrl takes away"
    )
    workspaces: ClassVar[frozenset[Workspace]] = frozenset(("tissue",))

    def press(self, pointer: Pointer) -> None:
        """Fill about the place, as one step."""
        if pointer.skin is None:
            return
        face, state = self.bench.document.project.face, self.bench.brush.state
        region = self.bench.regions.selected(face)
        if region is None or not region[pointer.skin.vertex]:
            region = like_values(face, state, pointer.skin.vertex)
        if state.mirror:
            region = both_sides(region, self.bench.ground.partners(face))
        fill(self.bench, region, state, pointer)


def fill(bench: Bench, region: BoolArray, state: BrushState, pointer: Pointer | None = None) -> None:
    """Do to a region (N,) but for what is locked what the brush does in its middle, as one step.

    Raises
    ------
    PaintError
        If the brush's mode needs a way, as combing does.
    """
    document, face = bench.document, bench.document.project.face
    locked = bench.regions.locked(face)
    free = region if locked is None else region & ~locked
    brush = state.brush(pointer.modifiers if pointer else frozenset())
    delta = filled(bench.ground.surface(face), face, state.paint_layer, brush, free)
    document.run(paint_deltas((delta,), f"Fill {state.paint_layer.title.lower()}"))


def like_values(face: Face, state: BrushState, vertex: int) -> BoolArray:
    """Vertices (N,) connected with one over values that are like its own, within the tolerance of the brush."""
    layer = state.paint_layer
    values = layer.values(face)
    if layer.kind == "choice":
        return flood(face.skin, values, vertex, 0.0)
    if layer.kind == "angle":
        return flood(face.skin, values, vertex, state.tolerance * HALF_TURN / 2, HALF_TURN)
    return flood(face.skin, values, vertex, state.tolerance * float(np.ptp(values)))

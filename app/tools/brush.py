"""Paint a layer by strokes on the skin."""

from __future__ import annotations

from typing import ClassVar

import numpy as np

from app.commands import paint_deltas
from app.tools.pointer import Hit, Pointer, skin_hit
from app.tools.sight import Ring, Working
from app.tools.tool import Bench, Tool
from app.view_state import Workspace
from facemodel.face import Face
from facemodel.mesh import Mesh
from facemodel.painting.brush import Mode
from facemodel.painting.geodesic import SurfacePoint
from facemodel.painting.stroke import Stroke, Touch
from fem.types import BoolArray

VERBS: dict[Mode, str] = {
    "set": "Paint",
    "add": "Add to",
    "scale": "Scale",
    "smooth": "Smooth",
    "comb": "Comb",
    "erase": "Erase",
}


class BrushTool(Tool):
    """A stroke paints from press to release; what it touches is drawn at once, and becomes one step when it ends."""

    id: ClassVar[str] = "brush"
    title: ClassVar[str] = "Brush"
    shortcut: ClassVar[str] = "B"
    hint: ClassVar[str] = (
        "Drag to paint · Shift smooths · Ctrl takes away · Ctrl+Shift-click picks the value · "
        "[ ] size · Shift+[ ] strength"
    )
    workspaces: ClassVar[frozenset[Workspace]] = frozenset(("tissue",))

    def __init__(self, bench: Bench) -> None:
        super().__init__(bench)
        self._stroke: Stroke | None = None
        self._skin: Mesh | None = None
        self._touched: BoolArray = np.zeros(0, dtype=np.bool_)
        bench.brush.changed.connect(self._redraw_ring)
        self._last: Hit | None = None

    def press(self, pointer: Pointer) -> None:
        """Begin a stroke, or pick the value of the place."""
        if pointer.skin is None:
            return
        if {"shift", "control"} <= pointer.modifiers:
            self._pick(pointer.skin)
            return
        self._stroke = self._begun(pointer)
        self._skin = self._face.skin
        self._touched = np.zeros(len(self._skin.positions), dtype=np.bool_)
        self.busy = True
        self.move(pointer)

    def move(self, pointer: Pointer) -> None:
        """Go on with the stroke; beside the face the brush is off the skin."""
        self.hover(pointer)
        if self._stroke is None:
            return
        if pointer.skin is None:
            self._stroke.lift()
            return
        point = SurfacePoint(pointer.skin.triangle, pointer.skin.barycentric)
        self._show(self._stroke.extend(point, pointer.pressure))

    def release(self, pointer: Pointer) -> None:
        """End the stroke; it becomes one step."""
        stroke, self._stroke, self.busy = self._stroke, None, False
        if stroke is not None:
            label = f"{VERBS[stroke.brush.mode]} {_lower(stroke.layer.title)}"
            self.bench.document.run(paint_deltas((stroke.delta(),), label))

    def hover(self, pointer: Pointer) -> None:
        """Show where the brush would paint."""
        self._last = pointer.skin
        if pointer.skin is None:
            self.leave()
        else:
            self._redraw_ring()

    def leave(self) -> None:
        """Take the ring away."""
        self._last = None
        self.bench.sight.ring_changed.emit(None)

    def cancel(self) -> None:
        """Put back what the stroke has painted; on another head there is nothing of it."""
        stroke, self._stroke, self.busy = self._stroke, None, False
        if stroke is not None and self._skin is self._face.skin:
            vertices = np.flatnonzero(self._touched)
            values = stroke.layer.values(self._face)
            self.bench.sight.working_changed.emit(Working(stroke.layer.key, vertices, values[vertices]))

    @property
    def _face(self) -> Face:
        return self.bench.document.project.face

    def _begun(self, pointer: Pointer) -> Stroke:
        state, face = self.bench.brush.state, self._face
        return Stroke(
            self.bench.ground.surface(face),
            face,
            state.paint_layer,
            state.brush(pointer.modifiers),
            self.bench.ground.partners(face) if state.mirror else None,
            self.bench.regions.kept(face),
        )

    def _show(self, touch: Touch) -> None:
        assert self._stroke is not None
        self._touched[touch.vertices] = True
        if len(touch.vertices):
            self.bench.sight.working_changed.emit(Working(self._stroke.layer.key, touch.vertices, touch.values))

    def _pick(self, hit: Hit) -> None:
        layer, face = self.bench.brush.state.paint_layer, self._face
        self.bench.brush.set_value(layer.picked(face, SurfacePoint(hit.triangle, hit.barycentric)))

    def _redraw_ring(self) -> None:
        state, hit = self.bench.brush.state, self._last
        if hit is None:
            return
        point = SurfacePoint(hit.triangle, hit.barycentric)
        mirrored = None
        if state.mirror:
            other = self.bench.ground.mirrored(self._face, point)
            mirrored = skin_hit(self._face, other.triangle, other.barycentric)
        self.bench.sight.ring_changed.emit(Ring(hit, mirrored, state.radius, state.hardness))


def _lower(title: str) -> str:
    return title[:1].lower() + title[1:]

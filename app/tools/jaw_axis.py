"""Place the axis of the jaw by dragging its two ends; the turn about it is seen at once."""

from __future__ import annotations

from typing import ClassVar

import numpy as np

from app.authoring.jaw import with_jaw_axis
from app.tools.gizmo import FINE
from app.tools.grips import in_plane
from app.tools.place_skull import FINGER
from app.tools.pointer import Pointer
from app.tools.tool import Bench, Tool
from app.view_state import Workspace
from facemodel.laying.places import middle_plane
from fem.types import FloatArray


class JawAxisTool(Tool):
    """Drags an end of the axis in the plane that faces the eye; with the mirror on the other end goes alike."""

    id: ClassVar[str] = "jaw-axis"
    title: ClassVar[str] = "Jaw axis"
    shortcut: ClassVar[str] = "J"
    hint: ClassVar[str] = (
        "Drag an end of the jaw’s axis · X moves both ends alike · Shift is finer · Ctrl keeps the height"
    )
    workspaces: ClassVar[frozenset[Workspace]] = frozenset(("skull",))
    asks_skin: ClassVar[bool] = False

    def __init__(self, bench: Bench) -> None:
        super().__init__(bench)
        self._end = 0
        self._start: FloatArray = np.zeros((2, 3))
        self._from: FloatArray | None = None
        self._axis: FloatArray | None = None

    @property
    def usable(self) -> bool:
        """Not while another skull is fitted, in whose place the own one is not seen."""
        return not self.bench.fitting.on

    def press(self, pointer: Pointer) -> None:
        """Take hold of an end."""
        end = self._under(pointer)
        if end is None:
            return
        self._end, self._start = end, self.bench.document.project.face.skull.jaw.axis
        self._from = in_plane(pointer, self._start[end])
        self._axis, self.busy = None, True
        self.bench.sight.end_changed.emit(end)

    def move(self, pointer: Pointer) -> None:
        """The end follows."""
        to = in_plane(pointer, self._start[self._end])
        if to is None or self._from is None:
            return
        way = (to - self._from) * (FINE if "shift" in pointer.modifiers else 1.0)
        if "control" in pointer.modifiers:
            way[1] = 0.0
        self._axis = self._moved(way)
        self.bench.sight.axis_changed.emit(self._axis)

    def release(self, pointer: Pointer) -> None:
        """Leave the axis where it was shown last, as one step.

        Raises
        ------
        SkullError
            If no jaw can turn about it; it is then where it was.
        """
        axis = self._axis
        self.cancel()
        self.hover(pointer)
        if axis is not None:
            document = self.bench.document
            document.edit(with_jaw_axis(document.project, *axis), "Place the jaw’s axis")

    def hover(self, pointer: Pointer) -> None:
        """Show which end would be taken."""
        self.bench.sight.end_changed.emit(self._under(pointer))

    def leave(self) -> None:
        """Neither would be taken."""
        self.bench.sight.end_changed.emit(None)

    def cancel(self) -> None:
        """Let go; the axis is where it was."""
        self.busy, self._axis, self._from = False, None, None
        self.bench.sight.axis_changed.emit(None)
        self.bench.sight.end_changed.emit(None)

    def _moved(self, way: FloatArray) -> FloatArray:
        """The ends (2, 3) of the axis after one of them went a way (3,)."""
        axis = self._start.copy()
        axis[self._end] += way
        if self.bench.brush.state.mirror:
            across = middle_plane(self.bench.document.project.face)[1]
            axis[1 - self._end] += way - 2 * (way @ across) * across
        return axis

    def _under(self, pointer: Pointer) -> int | None:
        if pointer.ray is None:
            return None
        away = pointer.ray.distance(self.bench.document.project.face.skull.jaw.axis)
        near = int(away.argmin())
        return near if away[near] <= FINGER * pointer.reach else None

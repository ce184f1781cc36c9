"""Pick landmarks on a skull that is being fitted, and drag those that are picked."""

from __future__ import annotations

from collections.abc import Mapping
from typing import ClassVar

import igl
import numpy as np

from app.tools.place_skull import FINGER
from app.tools.pointer import Pointer
from app.tools.tool import Bench, Tool
from app.view_state import Workspace
from facemodel.mesh import Mesh
from fem.types import FloatArray


class LandmarkTool(Tool):
    """A press on the bone picks the landmark that is asked for; one on a picked landmark drags it over the bone."""

    id: ClassVar[str] = "skull-landmark"
    title: ClassVar[str] = "Pick landmarks"
    hint: ClassVar[str] = "Click the landmark that is asked for on the bone · drag one that is picked to another place"
    workspaces: ClassVar[frozenset[Workspace]] = frozenset(("skull",))
    asks_skin: ClassVar[bool] = False

    def __init__(self, bench: Bench) -> None:
        super().__init__(bench)
        self._before: Mapping[str, FloatArray] = {}
        self._asked = ""
        self._fresh = False
        self._ready: tuple[Mesh, igl.AABB] | None = None

    @property
    def usable(self) -> bool:
        """Only while there is a skull to be fitted."""
        return self.bench.fitting.on

    def press(self, pointer: Pointer) -> None:
        """Pick, or take hold of what is picked."""
        fitting = self.bench.fitting
        place, near = self._place(pointer), self.near(pointer)
        if near is None and place is None:
            return
        self._before, self._asked = dict(fitting.picked), fitting.active
        if near is not None:
            fitting.choose(near)
        self._fresh = fitting.active not in fitting.picked
        fitting.held = self.busy = True
        self.move(pointer)

    def move(self, pointer: Pointer) -> None:
        """The landmark goes along with the pointer over the bone; beside it it waits."""
        place = self._place(pointer)
        if place is not None:
            self.bench.fitting.pick(self.bench.fitting.active, place)

    def release(self, pointer: Pointer) -> None:
        """The skull is fitted to it, and the next one is asked for."""
        self.busy = False
        self.bench.fitting.let_go(onward=self._fresh)

    def hover(self, pointer: Pointer) -> None:
        """Name what would be taken."""
        self.bench.fitting.point(self.near(pointer) or "")

    def leave(self) -> None:
        """Nothing would be taken."""
        self.bench.fitting.point("")

    def cancel(self) -> None:
        """What was picked before is picked again."""
        if self.busy:
            self.busy = False
            self.bench.fitting.restore(self._before)
            self.bench.fitting.choose(self._asked)

    def near(self, pointer: Pointer) -> str | None:
        """The picked landmark under the pointer."""
        fitting = self.bench.fitting
        if pointer.ray is None or not fitting.picked:
            return None
        names = list(fitting.picked)
        away = pointer.ray.distance(fitting.laid(np.array(list(fitting.picked.values()))))
        nearest = int(away.argmin())
        return names[nearest] if away[nearest] <= FINGER * pointer.reach else None

    def _place(self, pointer: Pointer) -> FloatArray | None:
        """The place (3,) on the skull under the pointer, in its own axes and unit."""
        fitting = self.bench.fitting
        if pointer.ray is None or fitting.guest is None:
            return None
        mesh = fitting.mesh
        if self._ready is None or self._ready[0] is not mesh:
            tree = igl.AABB()
            tree.init(mesh.positions, mesh.triangles)
            self._ready = mesh, tree
        line = pointer.ray.origin[None], pointer.ray.along[None]
        met, _, shares = self._ready[1].intersect_ray_first(mesh.positions, mesh.triangles, *line)
        if int(met[0]) < 0:
            return None
        corners = fitting.guest.bone.mesh.positions[mesh.triangles[int(met[0])]]
        u, v = (float(share) for share in shares[0, :2])
        return np.asarray(np.array([1 - u - v, u, v]) @ corners)

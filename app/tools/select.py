"""Name the muscle under the pointer, and select it."""

from __future__ import annotations

from typing import ClassVar

import numpy as np

from app.tools.pointer import Pointer, Ray
from app.tools.tool import Bench, Tool
from facemodel.face import Face
from facemodel.laying.drape import of_sector, ring_line, ring_turns
from facemodel.laying.rings import frame_of
from facemodel.muscles import Muscle
from facemodel.muscles.models import MODELS

SAMPLES = 12
"""Places along a straight piece of fibre that the pointer is measured against."""


class SelectTool(Tool):
    """Hovering names a muscle, a click selects it; Shift or Ctrl selects several."""

    id: ClassVar[str] = "select"
    title: ClassVar[str] = "Select"
    shortcut: ClassVar[str] = "V"
    hint: ClassVar[str] = "Click a muscle to select it · Shift-click selects several"

    def press(self, pointer: Pointer) -> None:
        """Select what is under the pointer; beside the face, nothing."""
        muscle = muscle_under(self.bench, pointer)
        if muscle is None:
            if not pointer.modifiers:
                self.bench.view.change(muscle="")
        elif pointer.modifiers:
            self.bench.view.select_also(muscle.key)
        else:
            self.bench.view.change(muscle=muscle.key)

    def hover(self, pointer: Pointer) -> None:
        """Name what is under the pointer."""
        muscle = muscle_under(self.bench, pointer)
        self.bench.sight.point_at(muscle.key if muscle else "")

    def leave(self) -> None:
        """Nothing is under the pointer."""
        self.bench.sight.point_at("")


def muscle_under(bench: Bench, pointer: Pointer) -> Muscle | None:
    """The muscle whose fibres or ring the pointer is on, else the one that pulls most on the skin there."""
    project, state = bench.document.project, bench.view.state
    shown = [muscle for muscle in project.muscles if muscle.key not in state.hidden]
    if (state.muscles or state.workspace == "muscles") and pointer.ray is not None and shown:
        distances = [muscle_distance(muscle, pointer.ray, project.face) for muscle in shown]
        nearest = int(np.argmin(distances))
        if distances[nearest] <= pointer.reach:
            return shown[nearest]
    if pointer.skin is None:
        return None
    return bench.pulls.strongest(project, pointer.skin.vertex, state.hidden)


def muscle_distance(muscle: Muscle, ray: Ray, face: Face) -> float:
    """Millimetres between a line of sight and the fibres of a muscle, or its ring on the side that is seen."""
    if muscle.ring is None or MODELS[muscle.model].geometry != "ring":
        return fibre_distance(muscle, ray)
    line = ring_line(muscle.ring, face.skin)[of_sector(muscle.ring, ring_turns())]
    facing = frame_of(muscle.ring)[2] @ ray.along < 0
    return float(ray.distance(line).min()) if facing and len(line) else float("inf")


def fibre_distance(muscle: Muscle, ray: Ray) -> float:
    """Millimetres between a line of sight and the central fibres of a muscle; infinite for a ring."""
    if MODELS[muscle.model].geometry != "fibres":
        return float("inf")
    share = np.linspace(0.0, 1.0, SAMPLES)[:, None, None]
    return min(
        float(ray.distance(((1 - share) * fibre.points[:-1] + share * fibre.points[1:]).reshape(-1, 3)).min())
        for fibre in muscle.fibres
    )

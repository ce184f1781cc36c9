"""Lay sphincters by hand: an ellipse on the skin, from its middle to the tip of its long axis."""

from __future__ import annotations

from typing import ClassVar

import numpy as np

from app.tools.laying import group_at
from app.tools.muscle_hand import Drag, MuscleHand
from app.tools.pointer import Pointer
from facemodel.errors import MuscleError
from facemodel.laying.collection import drafted_muscle
from facemodel.laying.rings import laid_ring
from facemodel.muscles import Muscle

HEIGHT = 0.6
"""Short half axis of a new ring over its long one; with Shift it is round."""


class RingTool(MuscleHand):
    """Press on the skin and drag lays a ring; press on a handle of a selected muscle drags it."""

    id: ClassVar[str] = "ring"
    title: ClassVar[str] = "Ring"
    shortcut: ClassVar[str] = "Shift+N"
    hint: ClassVar[str] = "Press in the middle of a sphincter and drag to the end of its ring · Shift lays it round"

    def begun(self, pointer: Pointer) -> Drag | None:
        """From a place on the skin: a new ring about it."""
        if pointer.skin is None:
            return None
        centre = pointer.skin.position

        def made(now: Pointer) -> Muscle | None:
            if now.skin is None:
                raise MuscleError("A ring lies on the skin; let go over the face.")
            tip = now.skin.position
            height = float(np.linalg.norm(tip - centre)) * (1.0 if "shift" in now.modifiers else HEIGHT)
            face = self._project.face
            group = group_at(face, centre)
            ring = laid_ring(face, centre, tip, height)
            return drafted_muscle(self._project, f"{group.capitalize()} sphincter", group, ring=ring)

        return Drag("Lay", made)

"""Lay muscles by hand: draw a fibre from bone to skin, drag what there is of a muscle, bend a fibre over the bone."""

from __future__ import annotations

from typing import ClassVar

from app.tools.grips import place_on_fibre
from app.tools.laying import drafted
from app.tools.muscle_hand import Drag, MuscleHand
from app.tools.pointer import Pointer
from app.tools.sight import Grip
from facemodel.errors import MuscleError
from facemodel.laying.fibres import added_fibre, bent, laid_fibre
from facemodel.laying.handles import Handle
from facemodel.muscles import Muscle
from facemodel.muscles.models import MODELS


class FibreTool(MuscleHand):
    """Press on the skull and drag to the skin lays a fibre; press on a handle of a selected muscle drags it."""

    id: ClassVar[str] = "fibre"
    title: ClassVar[str] = "Fibre"
    shortcut: ClassVar[str] = "N"
    hint: ClassVar[str] = (
        "Press on the bone and drag to the skin · drag an end · Ctrl-drag a fibre to bend it · Shift adds to the muscle"
    )

    def begun(self, pointer: Pointer) -> Drag | None:
        """Bend a fibre, or begin a new one."""
        return self._bending(pointer) or self._drawing(pointer)

    def _meant(self, pointer: Pointer) -> list[Muscle]:
        if "control" in pointer.modifiers:
            return self._near(pointer)
        own = super()._meant(pointer)
        if own or "shift" not in pointer.modifiers or pointer.skull is None:
            return own
        return self._seen()

    def _bending(self, pointer: Pointer) -> Drag | None:
        """With Ctrl on a fibre of a selected muscle: a point of it that is dragged off the straight line."""
        near = self._near(pointer) if "control" in pointer.modifiers else []
        if not near:
            return None
        number, point = place_on_fibre(near[0], pointer)
        muscle, place = bent(near[0], number, point)
        return self._moving(Grip(muscle, Handle("via", point, number, place)))

    def _drawing(self, pointer: Pointer) -> Drag | None:
        """From a place on the skull: a new muscle, or with Shift one more fibre of the selected one."""
        if pointer.skull is None:
            return None
        start = pointer.skull.position
        own = [muscle for muscle in self._own() if MODELS[muscle.model].geometry == "fibres"]
        adds = "shift" in pointer.modifiers and bool(own)

        def made(now: Pointer) -> Muscle | None:
            if now.skin is None:
                raise MuscleError("A fibre ends in the skin; let go over the face.")
            fibre = laid_fibre(self._project.face, start, now.skin.position, bone=self.bone_snap, skin=self.skin_snap)
            return added_fibre(own[0], fibre) if adds else drafted(self._project, fibre)

        return Drag("Add fibre to" if adds else "Lay", made)

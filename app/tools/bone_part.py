"""Select bone by what it is connected with."""

from __future__ import annotations

from typing import ClassVar

from app.tools.bones import taken
from app.tools.pointer import Hit, Pointer
from app.tools.tool import Tool
from app.view_state import Workspace
from facemodel.face import Skull
from facemodel.skull.jaw_region import part_around, whole_skull


class BonePart(Tool):
    """A click selects all bone that is connected with the place, or only what of it lies no higher."""

    id: ClassVar[str] = "bone-part"
    title: ClassVar[str] = "Pick part of bone"
    shortcut: ClassVar[str] = "Shift+L"
    hint: ClassVar[str] = "Click a piece of bone to select it · Shift adds · Ctrl takes away · click beside to deselect"
    workspaces: ClassVar[frozenset[Workspace]] = frozenset(("skull",))
    asks_skin: ClassVar[bool] = False
    asks_skull: ClassVar[bool] = True

    @property
    def usable(self) -> bool:
        """Not while another skull is fitted, in whose place the own one is not seen."""
        return not self.bench.fitting.on

    def press(self, pointer: Pointer) -> None:
        """Select about the place."""
        face, bones = self.bench.document.project.face, self.bench.bones
        if pointer.skull is None:
            if not pointer.modifiers:
                bones.select(face.skull, None)
            return
        part = part_around(whole_skull(face.skull).mesh, bone_vertex(face.skull, pointer.skull), bones.hand.lower)
        before, mirror = bones.selected(face.skull), self.bench.brush.state.mirror
        bones.select(face.skull, taken(face, before, part, pointer.modifiers, mirror))


def bone_vertex(skull: Skull, hit: Hit) -> int:
    """The vertex of the whole skull that a place on one of its bones is nearest to."""
    own = hit.vertex + (len(skull.cranium.positions) if hit.surface == "mandible" else 0)
    return int(whole_skull(skull).corners[own])

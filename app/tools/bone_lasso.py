"""Select bone by drawing around it on the screen."""

from __future__ import annotations

from typing import ClassVar

import numpy as np

from app.tools.bones import taken
from app.tools.lasso import Outline
from app.tools.pointer import Pointer
from app.view_state import Workspace
from facemodel.painting.regions import LEAST_CORNERS, lasso


class BoneLasso(Outline):
    """Draws an outline from press to release and selects the bone inside of it; a click selects nothing."""

    id: ClassVar[str] = "bone-lasso"
    title: ClassVar[str] = "Lasso bone"
    shortcut: ClassVar[str] = "Shift+C"
    hint: ClassVar[str] = "Draw around bone to select it · Shift adds · Ctrl takes away · click to deselect"
    workspaces: ClassVar[frozenset[Workspace]] = frozenset(("skull",))
    asks_skin: ClassVar[bool] = False

    @property
    def usable(self) -> bool:
        """Not while another skull is fitted, in whose place the own one is not seen."""
        return not self.bench.fitting.on

    def release(self, pointer: Pointer) -> None:
        """Close the outline and select."""
        corners, held = self.closed(pointer)
        face, bones, projector = self.bench.document.project.face, self.bench.bones, self.bench.projector
        if projector is None:
            return
        screen, seen = projector.bone_on_screen()
        if bones.hand.through:
            seen = np.ones(len(screen), dtype=np.bool_)
        inside = lasso(corners, screen, seen) if len(corners) >= LEAST_CORNERS else np.zeros_like(seen)
        before = bones.selected(face.skull)
        bones.select(face.skull, taken(face, before, inside, held, self.bench.brush.state.mirror))

"""The muscles: bodies with visible fibres, coloured by group; what contracts glows, what is selected stands out."""

from __future__ import annotations

import numpy as np
from vtkmodules.vtkRenderingCore import vtkRenderer

from facemodel.muscles import Muscle
from ui.viewport.muscle_fields import activations
from ui.viewport.overlays.fibre_grain import GLSL, wear_grain
from ui.viewport.overlays.glow import ACCENT
from ui.viewport.overlays.laid_muscle import LaidMuscle, laid_muscle
from ui.viewport.overlays.overlay import Drawn, Overlay
from ui.viewport.shading import BAND, apply
from ui.viewport.surface import Surface

REST, FULL = 0.62, 1.25
"""Brightness of a muscle at rest and fully contracted."""
HOT = (1.00, 0.66, 0.36)
"""What a contracting muscle turns to."""
SWELL = 1.2
"""Millimetres that a contracted muscle is thicker."""


class MusclesOverlay(Overlay):
    """All muscles of a project in one actor."""

    def __init__(self, renderer: vtkRenderer) -> None:
        super().__init__(renderer)
        self._muscles: list[Muscle] = []
        self._laid: list[LaidMuscle] = []

    def build(self, drawn: Drawn) -> None:
        """Lay the bodies under the resting skin; where they lie as before, what draws them is taken again."""
        # The force of the jaw has no shape of its own: its muscles lie under the others.
        self._muscles = [
            muscle
            for muscle in drawn.project.muscles
            if (muscle.fibres or muscle.ring is not None) and muscle.key not in drawn.hidden
        ]
        if not self._muscles:
            return
        face, display = drawn.project.face, drawn.figure.posed.basis.display
        bones = face.skull.cranium, face.skull.mandible
        laid = [laid_muscle(muscle, face.skin, bones, display) for muscle in self._muscles]
        if [id(each) for each in laid] != [id(each) for each in self._laid]:
            self._laid = laid
            self._draw(laid)
        self._anchored = display.points
        self.add(self._surface.actor)

    def _draw(self, laid: list[LaidMuscle]) -> None:
        """Put all bodies into one surface."""
        sizes = [len(each.points) for each in laid]
        first = np.cumsum([0, *sizes])
        self._rest = np.concatenate([each.points for each in laid])
        triangles = np.concatenate([each.triangles + k for each, k in zip(laid, first, strict=False)])
        self._owner = np.repeat(np.arange(len(laid)), sizes)
        self._base = np.concatenate([each.colours for each in laid])
        self._share = np.concatenate([each.share for each in laid])
        self._anchors = np.concatenate([each.anchors for each in laid])
        self._pulls = np.concatenate([each.pulls for each in laid])
        self._normals = np.concatenate([each.normals for each in laid])
        colours = np.full((len(self._rest), 4), 255, dtype=np.uint8)
        self._surface = Surface(self._rest.astype(np.float32), self._normals, triangles, colours)
        wear_grain(self._surface, np.concatenate([each.grain for each in laid]))
        apply(self._surface.actor, BAND, detail=GLSL)

    def follow(self, drawn: Drawn) -> None:
        """Colour by contraction and selection, and move the attachments with the skin."""
        if not self._muscles:
            return
        active = activations(drawn.project, drawn.expression)
        keys = [muscle.key for muscle in self._muscles]
        pull = np.array([active.get(key, 0.0) for key in keys])
        chosen = np.array([key == drawn.muscle or key in drawn.others | drawn.glowing for key in keys])
        at = pull[self._owner][:, None]
        colour = self._base * (REST + (FULL - REST) * at)
        colour += (np.array(HOT) - colour) * 0.45 * at
        colour += (np.array(ACCENT) - colour) * 0.75 * chosen[self._owner][:, None]
        colours = self._surface.colours
        assert colours is not None
        colours[:, :3] = np.clip(255 * colour, 0, 255)
        self._surface.points[:] = self._rest
        if any(drawn.expression.values()):
            moved = drawn.figure.posed.points - self._anchored
            self._surface.points[:] += np.einsum("nk,nkc->nc", self._pulls, moved[self._anchors])
            self._surface.points[:] += (SWELL * pull[self._owner] * (1 - self._share))[:, None] * self._normals
        self._surface.recoloured()
        self._surface.moved()

"""The influence area of the selected muscle: how hard it pulls each place of the skin, as colours with a legend."""

from __future__ import annotations

import numpy as np

from facemodel.muscles.models import MODELS
from facemodel.smooth import smooth
from fem.types import Float32Array
from ui.viewport.colour_map import cividis
from ui.viewport.look import at_points
from ui.viewport.muscle_fields import muscle_named, muscle_pull
from ui.viewport.overlays.legend import legend
from ui.viewport.overlays.overlay import Drawn, Overlay

COVER = 0.70
"""How much of the skin the colours cover, so that form stays readable."""
KPA = 1000.0
"""Kilopascal in a newton per square millimetre."""
FADE = 0.20
"""Share of the largest pull below which the colours fade into the skin."""


class InfluenceOverlay(Overlay):
    """Legend of the influence; the colours themselves are laid on the skin, see `influence_paint`."""

    def build(self, drawn: Drawn) -> None:
        """Make the legend."""
        muscle = muscle_named(drawn.project, drawn.muscle)
        if muscle is not None:
            top = float(muscle_pull(muscle, drawn.project.face).max())
            moves = MODELS[muscle.model].action == "displacement"
            self.add(legend("Way, mm", top) if moves else legend("Pull, kPa", KPA * top))


def influence_paint(drawn: Drawn) -> Float32Array | None:
    """Colours (P, 4) of the selected muscle's influence, or None if no muscle is selected."""
    muscle = muscle_named(drawn.project, drawn.muscle)
    if muscle is None:
        return None
    face = drawn.project.face
    pull = muscle_pull(muscle, face)
    share = at_points(face, drawn.figure.posed.basis.display, pull / max(float(pull.max()), 1e-12))
    cover = COVER * smooth(share, 0.0, FADE)
    return np.column_stack([cividis(share), cover]).astype(np.float32)

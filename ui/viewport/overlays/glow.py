"""What lies under the pointer glows: the skin takes the accent colour where the muscles meant pull."""

from __future__ import annotations

import numpy as np

from fem.types import Float32Array
from ui.viewport.look import at_points
from ui.viewport.muscle_fields import muscle_pull
from ui.viewport.overlays.overlay import Drawn

ACCENT = (0.949, 0.518, 0.361)
COVER = 0.62
"""How much of the skin the glow covers where the pull is largest."""


def glow_paint(drawn: Drawn) -> Float32Array | None:
    """Colours (P, 4) of the glow, or None if nothing glows."""
    face = drawn.project.face
    total = np.zeros(len(face.skin.positions))
    for muscle in drawn.project.muscles:
        if muscle.key in drawn.glowing:
            pull = muscle_pull(muscle, face)
            total = np.maximum(total, pull / max(float(pull.max()), 1e-12))
    if not total.any():
        return None
    cover = COVER * at_points(face, drawn.figure.posed.basis.display, np.sqrt(total))
    return np.column_stack([np.broadcast_to(ACCENT, (len(cover), 3)), cover]).astype(np.float32)

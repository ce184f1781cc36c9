"""What a muscle is called."""

from __future__ import annotations

from facemodel.muscles import Muscle

SIDES = {"L": "left", "R": "right", "M": ""}


def muscle_label(muscle: Muscle) -> str:
    """Title and side."""
    side = SIDES[muscle.side]
    return f"{muscle.title}, {side}" if side else muscle.title

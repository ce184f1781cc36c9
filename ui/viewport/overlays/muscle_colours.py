"""The colours of muscles on the face: of their group, or their own."""

from __future__ import annotations

from collections.abc import Mapping

from facemodel.muscles import Muscle

GROUPS: Mapping[str, tuple[float, float, float]] = {
    "brow": (0.80, 0.58, 0.27),
    "eye": (0.36, 0.60, 0.62),
    "nose": (0.58, 0.47, 0.74),
    "cheek": (0.74, 0.33, 0.31),
    "lip": (0.76, 0.42, 0.52),
    "chin": (0.53, 0.60, 0.35),
}
"""Colours of muscle groups, alike in brightness."""
OTHER = (0.62, 0.40, 0.36)


def colour_of(muscle: Muscle) -> tuple[float, float, float]:
    """The colour of a muscle at rest: its own, else that of its group."""
    if muscle.colour:
        red, green, blue = (int(muscle.colour[k : k + 2], 16) / 255 for k in (1, 3, 5))
        return red, green, blue
    return GROUPS.get(muscle.group, OTHER)

"""The head and the eyes turned by channels, beside what the sliders do: lids follow, and all that is drawn."""

from __future__ import annotations

from facemodel.kinematics import Rigid
from ui.viewport.scene import Scene


def turn_head(scene: Scene, rigid: Rigid) -> None:
    """Turn head and eyes of the face that is drawn; it is seen when the face is posed next.

    Parameters
    ----------
    scene : where it is drawn
    rigid : degrees and millimetres by channel; those not named rest
    """
    if scene.figure is not None:
        scene.figure.posed.turned = rigid

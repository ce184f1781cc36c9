"""What the viewport shows.  It is no part of the project, so it is neither saved with it nor undone."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

ViewName = Literal["front", "left", "right", "three-quarter", "top", "free"]

VIEW_TITLES: dict[ViewName, str] = {
    "front": "Front",
    "left": "Left side",
    "right": "Right side",
    "three-quarter": "Three-quarter",
    "top": "Top",
}
"""The views that can be asked for; sides are the subject's own."""


@dataclass(frozen=True)
class ViewState:
    """What the viewport shows.

    Attributes
    ----------
    view : the direction looked from; ``free`` once the camera was turned by hand
    perspective : near things look larger; otherwise the projection is parallel
    turntable : the head turns slowly
    skull, muscles, forces, supports, wireframe : drawn with the skin or not
    influence : colour the skin by how strongly the selected muscle pulls there
    muscle : key of the selected muscle; empty for none
    linked : the sliders of left and right move together
    """

    view: ViewName = "three-quarter"
    perspective: bool = True
    turntable: bool = False
    skull: bool = False
    muscles: bool = False
    forces: bool = False
    supports: bool = False
    wireframe: bool = False
    influence: bool = False
    muscle: str = ""
    linked: bool = True

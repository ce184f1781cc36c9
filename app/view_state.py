"""What the viewport shows.  It is no part of the project, so it is neither saved with it nor undone."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

ViewName = Literal["front", "left", "right", "three-quarter", "top", "free"]

Workspace = Literal["expression", "actions", "muscles", "skull", "tissue"]

WORKSPACE_TITLES: dict[Workspace, str] = {
    "expression": "Expression",
    "actions": "Actions",
    "muscles": "Muscles",
    "skull": "Skull",
    "tissue": "Tissue",
}
"""The workspaces, in the order of their tabs."""

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
    workspace : which tab is open; it decides the panel and the tools, never camera or pose
    view : the direction looked from; ``free`` once the camera was turned by hand
    perspective : near things look larger; otherwise the projection is parallel
    turntable : the head turns slowly
    skull, muscles, forces, supports, wireframe : drawn with the skin or not
    influence : colour the skin by how strongly the selected muscle pulls there
    muscle : key of the selected muscle, of several the one selected last; empty for none
    others : keys of the muscles that are selected with it
    hidden, locked : keys of muscles that are not drawn, and of those that no hand changes
    unit : number of the selected action unit; none without one
    solo : show the selected action unit alone
    layer : key of the painted layer over the skin, see `facemodel.painting.layers`; empty for none
    layer_opacity : of it, 0 to 1
    contours, glyphs : lines of equal value, and ellipses of the stiffness, drawn with the layer
    before : show the face as it was before the last solve
    change_map : colour the skin by how far the last solve moved what is shown
    depth_map : colour the skin by how deep the bone lies
    origins_follow : muscles go along when the bone moves that they come from
    linked : the sliders of left and right move together
    """

    workspace: Workspace = "expression"
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
    others: frozenset[str] = frozenset()
    hidden: frozenset[str] = frozenset()
    locked: frozenset[str] = frozenset()
    unit: int | None = None
    solo: bool = False
    layer: str = ""
    layer_opacity: float = 0.7
    contours: bool = False
    glyphs: bool = False
    before: bool = False
    change_map: bool = False
    depth_map: bool = False
    origins_follow: bool = True
    linked: bool = True

    @property
    def selected(self) -> frozenset[str]:
        """Keys of all selected muscles."""
        return self.others | {self.muscle} if self.muscle else frozenset()

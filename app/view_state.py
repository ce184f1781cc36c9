"""What the viewport shows.  It is no part of the project, so it is neither saved with it nor undone."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal

from app.quality import FLUID, Level, Quality

ViewName = Literal["front", "left", "right", "three-quarter", "top", "free"]

Workspace = Literal["expression", "actions", "muscles", "skull", "tissue"]

UnitMap = Literal["", "motion", "sculpted"]
"""What of the action unit in hand is laid on the skin as colours: nothing, how far it moves, what is sculpted on it."""

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
    trying : a hand is changing what the selected action unit is made of
    mixing : in the Actions workspace expressions are worked on, not one action unit
    unit_map : what of the selected action unit is laid on the skin
    apart_map : colour the skin by how far superposition is from a full solve, where that was checked
    layer : key of the painted layer over the skin, see `facemodel.painting.layers`; empty for none
    layer_opacity : of it, 0 to 1
    contours, glyphs : lines of equal value, and ellipses of the stiffness, drawn with the layer
    before : show the face as it was before the last solve
    change_map : colour the skin by how far the last solve moved what is shown
    depth_map : colour the skin by how deep the bone lies
    origins_follow : muscles go along when the bone moves that they come from
    carry : muscles, units and expressions go along to another individual
    jaw_open, jaw_slide, jaw_side : degrees, and millimetres forward and to the subject's left, by which the jaw is
        moved only to be looked at in the Skull workspace, whatever the sliders say
    linear : show the pure linear sum of the fields: no arc of the jaw, nothing that lids and lips meet
    linked : the sliders of left and right move together
    quality : how finely the face is to be drawn
    least_rate : frames a second below which the automatic quality steps down
    level : how finely it is drawn now while it moves, asked for or found
    tools : by workspace the id of the tool in hand, where it is not the first one
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
    trying: bool = False
    mixing: bool = False
    unit_map: UnitMap = ""
    apart_map: bool = True
    layer: str = ""
    layer_opacity: float = 0.7
    contours: bool = False
    glyphs: bool = False
    before: bool = False
    change_map: bool = False
    depth_map: bool = False
    origins_follow: bool = True
    carry: bool = False
    jaw_open: float = 0.0
    jaw_slide: float = 0.0
    jaw_side: float = 0.0
    linear: bool = False
    linked: bool = True
    quality: Quality = "automatic"
    least_rate: float = FLUID
    level: Level = "balanced"
    tools: Mapping[Workspace, str] = field(default_factory=dict)

    @property
    def tool(self) -> str:
        """Id of the tool in hand; empty for the first one of the workspace."""
        return self.tools.get(self.workspace, "")

    @property
    def jaw_tried(self) -> bool:
        """Whether the jaw is moved only to be looked at."""
        return self.workspace == "skull" and (self.jaw_open, self.jaw_slide, self.jaw_side) != (0.0, 0.0, 0.0)

    @property
    def selected(self) -> frozenset[str]:
        """Keys of all selected muscles."""
        return self.others | {self.muscle} if self.muscle else frozenset()

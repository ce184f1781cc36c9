"""Tools: what the hand on the face does, as press, move and release; no window and no pixel but the lasso's."""

from app.tools.brush import BrushTool
from app.tools.brush_state import BrushState, HandBrush
from app.tools.fibre import FibreTool
from app.tools.fill import FillTool
from app.tools.lasso import LassoTool
from app.tools.place_skull import MoveSkull, ScaleSkull, TurnSkull
from app.tools.pointer import Hit, Pointer, Projector, Ray, skin_hit, skull_hit
from app.tools.ring import RingTool
from app.tools.sculpt import SculptTool
from app.tools.sculpt_state import HandSculpt, SculptState
from app.tools.select import SelectTool
from app.tools.sight import Ghost, Grip, Ring, Sight, Working
from app.tools.tool import Bench, Tool
from app.tools.toolbox import ToolBox

TOOLS = (
    SelectTool,
    SculptTool,
    BrushTool,
    LassoTool,
    FillTool,
    FibreTool,
    RingTool,
    MoveSkull,
    TurnSkull,
    ScaleSkull,
)
"""All tools, in the order in which they are shown."""

__all__ = [
    "TOOLS",
    "Bench",
    "BrushState",
    "BrushTool",
    "FibreTool",
    "FillTool",
    "Ghost",
    "Grip",
    "HandBrush",
    "HandSculpt",
    "Hit",
    "LassoTool",
    "MoveSkull",
    "Pointer",
    "Projector",
    "Ray",
    "Ring",
    "RingTool",
    "ScaleSkull",
    "SculptState",
    "SculptTool",
    "SelectTool",
    "Sight",
    "Tool",
    "ToolBox",
    "TurnSkull",
    "Working",
    "skin_hit",
    "skull_hit",
]

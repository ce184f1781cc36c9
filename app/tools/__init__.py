"""Tools: what the hand on the face does, as press, move and release; no window and no pixel but the lasso's."""

from app.tools.bone_brush import BoneBrush
from app.tools.bone_lasso import BoneLasso
from app.tools.bone_part import BonePart
from app.tools.brush import BrushTool
from app.tools.brush_state import BrushState, HandBrush
from app.tools.fibre import FibreTool
from app.tools.fill import FillTool
from app.tools.fold import FoldTool
from app.tools.jaw_axis import JawAxisTool
from app.tools.lasso import LassoTool
from app.tools.place_skull import MoveSkull, ScaleSkull, TurnSkull
from app.tools.pointer import Hit, Pointer, Projector, Ray, skin_hit, skull_hit
from app.tools.pull import PullTool
from app.tools.ring import RingTool
from app.tools.sculpt import SculptTool
from app.tools.sculpt_state import HandSculpt, SculptState
from app.tools.select import SelectTool
from app.tools.sight import Ball, Ghost, Grip, Ring, Sight, Working
from app.tools.skull_landmark import LandmarkTool
from app.tools.tool import Bench, Tool
from app.tools.toolbox import ToolBox

SKULL_TOOLS = (MoveSkull, TurnSkull, ScaleSkull, BoneBrush, BoneLasso, BonePart, JawAxisTool, LandmarkTool)
"""Those of the Skull workspace."""

TOOLS = (PullTool, SelectTool, SculptTool, BrushTool, LassoTool, FillTool, FibreTool, RingTool, FoldTool, *SKULL_TOOLS)
"""All tools, in the order in which they are shown."""

__all__ = [
    "SKULL_TOOLS",
    "TOOLS",
    "Ball",
    "Bench",
    "BoneBrush",
    "BoneLasso",
    "BonePart",
    "BrushState",
    "BrushTool",
    "FibreTool",
    "FillTool",
    "FoldTool",
    "Ghost",
    "Grip",
    "HandBrush",
    "HandSculpt",
    "Hit",
    "JawAxisTool",
    "LandmarkTool",
    "LassoTool",
    "MoveSkull",
    "Pointer",
    "Projector",
    "PullTool",
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

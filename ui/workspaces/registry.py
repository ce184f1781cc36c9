"""The workspaces that there are, in the order of their tabs.  A new one is one more entry here."""

from __future__ import annotations

from app.tools.bone_brush import BoneBrush
from app.tools.bone_lasso import BoneLasso
from app.tools.bone_part import BonePart
from app.tools.brush import BrushTool
from app.tools.fibre import FibreTool
from app.tools.fill import FillTool
from app.tools.fold import FoldTool
from app.tools.jaw_axis import JawAxisTool
from app.tools.lasso import LassoTool
from app.tools.place_skull import MoveSkull, ScaleSkull, TurnSkull
from app.tools.pull import PullTool
from app.tools.ring import RingTool
from app.tools.sculpt import SculptTool
from app.tools.select import SelectTool
from app.tools.skull_landmark import LandmarkTool
from app.tools.tool import Tool
from facemodel.sculpting.sampler import correction_sampler
from ui.panels.actions.panel import ActionsPanel
from ui.panels.expression_panel import ExpressionPanel
from ui.panels.muscles.comparison.opening import compare_on_demand
from ui.panels.muscles.panel import MusclesPanel
from ui.panels.skull.panel import SkullPanel
from ui.panels.tissue.panel import TissuePanel
from ui.viewport.overlays.bone_dye import BoneDye
from ui.viewport.overlays.bone_faults import BoneFaults
from ui.viewport.overlays.cursor import BrushRing
from ui.viewport.overlays.depth_map import DepthMap
from ui.viewport.overlays.fibre_ghost import FibreGhost
from ui.viewport.overlays.gizmo import SkullGizmo
from ui.viewport.overlays.glyphs import Glyphs
from ui.viewport.overlays.guest_skull import GuestSkull
from ui.viewport.overlays.handles import MuscleHandles
from ui.viewport.overlays.jaw_axis import JawAxis
from ui.viewport.overlays.lasso import LassoOutline, RegionOutlines
from ui.viewport.overlays.layer import LayerDrawing
from ui.viewport.overlays.muscles_sight import MusclesInSight
from ui.viewport.overlays.sculpt_sight import SculptInSight
from ui.viewport.overlays.skull_sight import SkullInSight
from ui.viewport.overlays.unit_maps import UnitMaps
from ui.workspaces.workspace import Parts, WorkspaceKind


def _expression_panel(parts: Parts) -> ExpressionPanel:
    return ExpressionPanel(parts.context.document, parts.context.view, parts.portraits)


def _actions_panel(parts: Parts) -> ActionsPanel:
    panel = ActionsPanel(parts.context, parts.toolbox, parts.check, parts.portraits)
    panel.muscles_hovered.connect(parts.viewport.glow)
    return panel


def _muscles_panel(parts: Parts) -> MusclesPanel:
    panel = MusclesPanel(parts.context, parts.toolbox)
    panel.muscles_hovered.connect(parts.viewport.glow)
    compare_on_demand(panel, parts)
    return panel


def _prepare_solver(parts: Parts) -> None:
    """A living solver, so that the first edit is as quick as all others; as soon as there is a face to show."""
    document, solving = parts.context.document, parts.context.solving
    if document.solution is not None:
        solving.prepare()
        return

    def once(solution: object) -> None:
        if solution is not None:
            document.solution_changed.disconnect(once)
            solving.prepare()

    document.solution_changed.connect(once)


def _prepare_sculpting(parts: Parts) -> None:
    """Besides, ways from the skin's vertices to what is drawn, so that the first stroke follows the hand at once."""
    _prepare_painting(parts)
    document = parts.context.document
    solution = document.solution
    if solution is not None:
        face, display = document.project.face, solution.basis.display
        parts.preparation.begin(lambda: correction_sampler(face, display))


def _skull_panel(parts: Parts) -> SkullPanel:
    panel = SkullPanel(parts.context, parts.toolbox)
    panel.place_asked.connect(parts.viewport.show_places)
    return panel


def _tissue_panel(parts: Parts) -> TissuePanel:
    return TissuePanel(parts.context, parts.bench)


def _prepare_painting(parts: Parts) -> None:
    """Distances on the skin and a living solver, so that the first stroke is as quick as all others."""
    surface = parts.bench.ground.surface(parts.context.document.project.face)
    parts.preparation.begin(lambda: surface.geodesics)
    _prepare_solver(parts)


WORKSPACES: tuple[WorkspaceKind, ...] = (
    WorkspaceKind("expression", _expression_panel, (PullTool, SelectTool)),
    WorkspaceKind(
        "actions",
        _actions_panel,
        (SelectTool, SculptTool),
        (UnitMaps, SculptInSight, BrushRing),
        _prepare_sculpting,
    ),
    WorkspaceKind(
        "muscles",
        _muscles_panel,
        (SelectTool, FibreTool, RingTool, FoldTool),
        (MusclesInSight, MuscleHandles, FibreGhost),
        _prepare_solver,
    ),
    WorkspaceKind(
        "skull",
        _skull_panel,
        (MoveSkull, TurnSkull, ScaleSkull, BoneBrush, BoneLasso, BonePart, JawAxisTool, LandmarkTool, SelectTool),
        (SkullInSight, DepthMap, BoneFaults, BoneDye, GuestSkull, JawAxis, SkullGizmo, LassoOutline),
        _prepare_solver,
    ),
    WorkspaceKind(
        "tissue",
        _tissue_panel,
        (BrushTool, LassoTool, FillTool),
        (LayerDrawing, Glyphs, RegionOutlines, LassoOutline, BrushRing),
        _prepare_painting,
    ),
)


def all_tools() -> tuple[type[Tool], ...]:
    """The tools of all workspaces, each once."""
    return tuple(dict.fromkeys(tool for kind in WORKSPACES for tool in kind.tools))

"""The workspaces that there are, in the order of their tabs.  A new one is one more entry here."""

from __future__ import annotations

from app.tools.brush import BrushTool
from app.tools.fill import FillTool
from app.tools.lasso import LassoTool
from app.tools.select import SelectTool
from app.tools.tool import Tool
from ui.panels.expression_panel import ExpressionPanel
from ui.panels.tissue.panel import TissuePanel
from ui.viewport.overlays.cursor import BrushRing
from ui.viewport.overlays.glyphs import Glyphs
from ui.viewport.overlays.lasso import LassoOutline, RegionOutlines
from ui.viewport.overlays.layer import LayerDrawing
from ui.workspaces.workspace import Parts, WorkspaceKind


def _expression_panel(parts: Parts) -> ExpressionPanel:
    return ExpressionPanel(parts.context.document, parts.context.view)


def _tissue_panel(parts: Parts) -> TissuePanel:
    return TissuePanel(parts.context, parts.bench)


def _prepare_painting(parts: Parts) -> None:
    """Distances on the skin and a living solver, so that the first stroke is as quick as all others."""
    surface = parts.bench.ground.surface(parts.context.document.project.face)
    parts.preparation.begin(lambda: surface.geodesics)
    if parts.context.document.solution is not None:
        parts.context.solving.prepare()


WORKSPACES: tuple[WorkspaceKind, ...] = (
    WorkspaceKind("expression", _expression_panel, (SelectTool,)),
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

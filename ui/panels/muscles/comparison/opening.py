"""Open the comparison of models when it is first asked for, and bring what is chosen in it to the panel."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QPoint

from fem.types import FloatArray
from ui.panels.muscles.comparison.window import ComparisonWindow
from ui.panels.muscles.panel import MusclesPanel
from ui.theme.metrics import GRID
from ui.workspaces.workspace import Parts


def compare_on_demand(panel: MusclesPanel, parts: Parts) -> None:
    """Let a panel open the comparison; it is made once and keeps its place on the screen."""
    made: list[ComparisonWindow] = []

    def camera() -> tuple[FloatArray, FloatArray]:
        seen = parts.viewport.scene.renderer.GetActiveCamera()
        return -np.array(seen.GetDirectionOfProjection()), np.array(seen.GetViewUp())

    def open_() -> None:
        if not made:
            made.append(ComparisonWindow(panel.window(), parts.context, camera))
            made[0].chosen.connect(panel.properties.identity.take_model)
            corner = parts.viewport.mapToGlobal(parts.viewport.rect().topLeft())
            made[0].move(corner + QPoint(2 * GRID, 2 * GRID))
        made[0].show()
        made[0].raise_()

    panel.compared.connect(open_)

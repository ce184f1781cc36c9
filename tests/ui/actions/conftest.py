"""A small document with all that actions work on, solved at once, and the panel of the Actions workspace on it."""

from collections.abc import Callable

import pytest

from app.actions.context import Context
from app.superposition_check import SuperpositionCheck
from app.tools import Bench, SculptTool, SelectTool, ToolBox
from tests.app.conftest import context as context
from tests.app.conftest import desk as desk
from ui.panels.actions.panel import ActionsPanel
from ui.portraits import Portraits
from ui.window.delivery import UiThread


@pytest.fixture
def toolbox(context: Context) -> ToolBox:
    return ToolBox(Bench(context.document, context.view), (SelectTool, SculptTool))


@pytest.fixture
def make_panel(shown, context: Context, toolbox: ToolBox, portraits: Portraits) -> Callable[..., ActionsPanel]:
    def make(width: int = 360, height: int = 800) -> ActionsPanel:
        context.view.change(workspace="actions", unit=12)
        context.solving.solve()
        thread = UiThread()
        check = SuperpositionCheck(context.document, context.view, thread.deliver)
        panel = ActionsPanel(context, toolbox, check, portraits)
        thread.setParent(panel)
        panel.resize(width, height)
        return shown(panel)

    return make

"""What a workspace is: a value that names its panel, its tools and what it draws."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from typing import Protocol

from PySide6.QtWidgets import QWidget

from app.actions.context import Context
from app.superposition_check import SuperpositionCheck
from app.tools.tool import Bench, Tool
from app.tools.toolbox import ToolBox
from app.view_state import WORKSPACE_TITLES, Workspace
from ui.portraits import Portraits
from ui.window.preparation import Preparation
from ui.window.viewport_widget import Viewport


@dataclass(frozen=True, eq=False)
class Parts:
    """What panels and drawings of a workspace work on.

    Attributes
    ----------
    context : document, view, settings, solving and the window's services
    bench : the brush, regions, and what tools have drawn
    toolbox : the tools; one of them is in hand
    viewport : where the face is
    check : the superposition check of what is seen
    portraits : pictures of the named expressions
    preparation : does what takes a while away from the window's thread
    """

    context: Context
    bench: Bench
    toolbox: ToolBox
    viewport: Viewport
    check: SuperpositionCheck
    portraits: Portraits
    preparation: Preparation


class Drawing(Protocol):
    """Something that is drawn over the face while a workspace is open; it follows whatever it shows by itself."""

    def switch(self, on: bool) -> None:
        """Begin to draw, or take everything off the face again."""


@dataclass(frozen=True)
class WorkspaceKind:
    """A workspace as the window builds it.

    Attributes
    ----------
    id : which one
    panel : makes what stands at the right, once, when it is first opened
    tools : kinds of tools that it brings; one that several workspaces bring is made once
    drawings : make what is drawn over the face while it is open
    prepare : begins what will be wanted soon, whenever it is opened
    """

    id: Workspace
    panel: Callable[[Parts], QWidget]
    tools: tuple[type[Tool], ...] = ()
    drawings: tuple[Callable[[Parts], Drawing], ...] = ()
    prepare: Callable[[Parts], None] | None = None

    @property
    def title(self) -> str:
        """What its tab says."""
        return WORKSPACE_TITLES[self.id]

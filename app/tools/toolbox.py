"""The tool in hand, and the way of the pointer to it."""

from __future__ import annotations

from collections.abc import Callable, Sequence

from psygnal import Signal

from app.tools.pointer import Pointer
from app.tools.tool import Bench, Tool
from app.view_state import ViewState, Workspace
from facemodel.errors import RisoriusError, UnknownNameError


class ToolBox:
    """Holds the tools, one of them in hand, and routes the pointer to it.

    A gesture ends when the button goes up or Esc is pressed, and also when the document changes under it; it is then
    as if it had never begun.  An error that is meant for people ends it too and is told.

    Parameters
    ----------
    bench : what the tools work on
    kinds : of tools, in the order in which they are shown; the first one that a workspace has is in hand there
    """

    tool_changed = Signal(object)
    """(Tool) another one is in hand."""
    busy_changed = Signal(bool)
    """A gesture began or ended."""
    failed = Signal(str)
    """(sentence) a gesture came to nothing."""

    def __init__(self, bench: Bench, kinds: Sequence[Callable[[Bench], Tool]]) -> None:
        self.bench = bench
        self.tools: tuple[Tool, ...] = tuple(kind(bench) for kind in kinds)
        self._in_hand: dict[Workspace, Tool] = {}
        self._busy = False
        self._routing = False
        bench.view.changed.connect(self._follow_view)
        bench.document.history_changed.connect(self._follow_document)

    @property
    def tool(self) -> Tool:
        """The tool in hand; every workspace remembers its own."""
        workspace = self.bench.view.state.workspace
        held = self._in_hand.get(workspace)
        return held if held is not None and held.usable else self.offered(workspace)[0]

    @property
    def busy(self) -> bool:
        """Whether a gesture is under way."""
        return self._busy

    def offered(self, workspace: Workspace) -> tuple[Tool, ...]:
        """The tools of a workspace that there is use for."""
        return tuple(tool for tool in self.tools if workspace in tool.workspaces and tool.usable)

    def take(self, tool_id: str) -> None:
        """Take another tool in hand.

        Raises
        ------
        UnknownNameError
            If the workspace has no such tool.
        """
        workspace = self.bench.view.state.workspace
        for tool in self.offered(workspace):
            if tool.id == tool_id:
                self._put_away()
                self._in_hand[workspace] = tool
                self._note(tool, workspace)
                self.tool_changed.emit(tool)
                return
        known = ", ".join(tool.id for tool in self.offered(workspace))
        raise UnknownNameError(f"There is no tool “{tool_id}” here; choose one of {known}.")

    def press(self, pointer: Pointer) -> None:
        """The left button goes down over the face."""
        self._route(self.tool.press, pointer)

    def move(self, pointer: Pointer) -> None:
        """The pointer moves: part of a gesture, or it only hovers."""
        self._route(self.tool.move if self.tool.busy else self.tool.hover, pointer)

    def release(self, pointer: Pointer) -> None:
        """The left button goes up."""
        if self.tool.busy:
            self._route(self.tool.release, pointer)

    def leave(self) -> None:
        """The pointer leaves the viewport."""
        if not self.tool.busy:
            self.tool.leave()

    def cancel(self) -> bool:
        """End the gesture under way and undo what it did; whether there was one."""
        was_busy = self.tool.busy
        if was_busy:
            self.tool.cancel()
        self._tell_busy()
        return was_busy

    def _route(self, act: Callable[[Pointer], None], pointer: Pointer) -> None:
        self._routing = True
        try:
            act(pointer)
        except RisoriusError as error:
            self.tool.cancel()
            self.failed.emit(str(error))
        finally:
            self._routing = False
            self._tell_busy()

    def _note(self, tool: Tool, workspace: Workspace) -> None:
        """Write down what is in hand where others see it; the first tool needs no word."""
        view = self.bench.view
        others = {each: name for each, name in view.state.tools.items() if each != workspace}
        first = tool is self.offered(workspace)[0]
        view.change(tools=others if first else {**others, workspace: tool.id})

    def _put_away(self) -> None:
        self.cancel()
        self.tool.leave()
        self.bench.sight.clear()

    def _tell_busy(self) -> None:
        if self._busy != self.tool.busy:
            self._busy = self.tool.busy
            self.busy_changed.emit(self._busy)

    def _follow_view(self, now: ViewState, before: ViewState) -> None:
        if now.workspace != before.workspace:
            left = self._in_hand.get(before.workspace) or self.offered(before.workspace)[0]
            if left.busy:
                left.cancel()
            left.leave()
            self.bench.sight.clear()
            self._tell_busy()
            self.tool_changed.emit(self.tool)

    def _follow_document(self) -> None:
        """What a gesture began with is gone: let it go."""
        if not self._routing:
            self.cancel()

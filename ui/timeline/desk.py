"""The timeline of a window: its parts made and tied together, and tied to the viewport."""

from __future__ import annotations

from PySide6.QtCore import QObject, Signal

from app.actions.action import Action
from app.document import Document
from app.playback.playhead import Playhead
from app.timeline.actions import timeline_actions
from app.timeline.timeline import Timeline
from ui.timeline.dock import TimelineDock
from ui.timeline.line_paint import LinePainter
from ui.timeline.panel import TimelinePanel
from ui.timeline.player import Player
from ui.timeline.sight_actions import sight_actions
from ui.timeline.transport import Transport
from ui.timeline.view import TimelineView
from ui.window.action_binding import ActionBinding
from ui.window.viewport_widget import Viewport


class TimelineDesk(QObject):
    """Everything of the timeline that has to do with a screen.

    Signals
    -------
    advised(str) : a line for the status bar; empty when there is nothing to say any more
    failed(str) : why something came to nothing

    Attributes
    ----------
    dock : where it is

    Parameters
    ----------
    view : what part of which timeline is seen
    binding : the actions of the window
    viewport : where the face is drawn
    """

    advised = Signal(str)
    failed = Signal(str)

    def __init__(self, view: TimelineView, binding: ActionBinding, viewport: Viewport) -> None:
        super().__init__()
        self.timeline, self.view = view.timeline, view
        self.painter = LinePainter(lambda _time: None)
        self.panel = TimelinePanel(view, binding, self.painter)
        self.dock = TimelineDock(Transport(self.timeline, binding), self.panel)
        canvas = viewport.canvas
        self._player = Player(self.timeline.playhead, lambda: self.timeline.rate, lambda: canvas.frames)
        self.panel.advised.connect(self.advised)
        self.panel.failed.connect(self.failed)

    def close(self) -> None:
        """Stop for good."""
        self.timeline.playhead.close()


def timeline_view(document: Document) -> TimelineView:
    """A view on the timeline of a document, with a playhead of its own."""
    return TimelineView(Timeline(document, Playhead(document)))


def desk_actions(view: TimelineView) -> tuple[Action, ...]:
    """All actions of the timeline."""
    return (*timeline_actions(view.timeline), *sight_actions(view))

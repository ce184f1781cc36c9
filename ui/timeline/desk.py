"""The timeline of a window: its parts made and tied together, and tied to the viewport."""

from __future__ import annotations

from PySide6.QtCore import QObject, Signal

from app.actions.action import Action
from app.document import Document
from app.playback.playhead import Playhead
from app.timeline.actions import timeline_actions
from app.timeline.state import TimelineState
from app.timeline.timeline import Timeline
from ui.timeline.dock import TimelineDock
from ui.timeline.inspector.clip_page import ClipPage
from ui.timeline.inspector.curves_page import CurvesPage
from ui.timeline.inspector.event_page import EventPage
from ui.timeline.inspector.inspector import Inspector
from ui.timeline.inspector.keys_page import KeysPage
from ui.timeline.inspector.layer_page import LayerPage, TrackPage
from ui.timeline.inspector.life_page import LifePage
from ui.timeline.inspector.marks_pages import ExpressionPage, MarkerPage, RangePage
from ui.timeline.inspector.speech_page import SoundPage
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
        self.inspector = Inspector(self.timeline, PAGES)
        self.panel = TimelinePanel(view, binding, self.painter, self.inspector)
        transport = Transport(self.timeline, binding, self.inspector)
        self.dock = TimelineDock(transport, self.panel)
        self.timeline.changed.connect(self._open_page)
        self.timeline.playhead.posed.connect(lambda pose: viewport.turn_head(pose.rigid))
        canvas = viewport.canvas
        self._player = Player(self.timeline.playhead, lambda: self.timeline.rate, lambda: canvas.frames)
        self.panel.advised.connect(self.advised)
        self.panel.failed.connect(self.failed)

    def _open_page(self, now: TimelineState, before: TimelineState) -> None:
        """What was asked for is shown even if everything was folded: a new key, or a page of parameters."""
        if (now.page and not before.page) or (now.chosen and not before.chosen):
            self.dock.open()
        if now.page and not before.page:
            self.inspector.show()

    def close(self) -> None:
        """Stop for good."""
        self.timeline.playhead.close()


PAGES = {
    "clip": ClipPage,
    "keys": KeysPage,
    "event": EventPage,
    "expression": ExpressionPage,
    "marker": MarkerPage,
    "range": RangePage,
    "sound": SoundPage,
    "layer": LayerPage,
    "track": TrackPage,
    "life": LifePage,
    "curves": CurvesPage,
}


def timeline_view(document: Document) -> TimelineView:
    """A view on the timeline of a document, with a playhead of its own."""
    return TimelineView(Timeline(document, Playhead(document)))


def desk_actions(view: TimelineView) -> tuple[Action, ...]:
    """All actions of the timeline."""
    return (*timeline_actions(view.timeline), *sight_actions(view))

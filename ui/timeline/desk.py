"""The timeline of a window: its parts made and tied together, and tied to the viewport."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QObject, Signal

from app.actions.action import Action
from app.actions.context import Context
from app.audio import Accompaniment
from app.document import Document
from app.playback.playhead import Playhead
from app.timeline.actions import timeline_actions
from app.timeline.exchange import Exchange, exchange_actions
from app.timeline.sounds import SoundShelf
from app.timeline.state import TimelineState
from app.timeline.timeline import Timeline
from ui.portraits import Portraits
from ui.timeline.dialogs.asking import TimelineDialogs
from ui.timeline.dock import TimelineDock
from ui.timeline.inspector.clip_page import ClipPage
from ui.timeline.inspector.curves_page import CurvesPage
from ui.timeline.inspector.event_page import EventPage
from ui.timeline.inspector.inspector import Inspector, Make
from ui.timeline.inspector.keys_page import KeysPage
from ui.timeline.inspector.layer_page import LayerPage
from ui.timeline.inspector.life_page import LifePage
from ui.timeline.inspector.marks_pages import ExpressionPage, MarkerPage, RangePage
from ui.timeline.inspector.sound_page import audio_page
from ui.timeline.inspector.speech_page import SoundPage, SpeechFields
from ui.timeline.inspector.track_page import TrackPage
from ui.timeline.key_portraits import KeyPortraits
from ui.timeline.line_paint import LinePainter
from ui.timeline.paint.sound import SoundPainter
from ui.timeline.panel import TimelinePanel
from ui.timeline.player import Player
from ui.timeline.sight_actions import sight_actions
from ui.timeline.transport import Transport
from ui.timeline.view import TimelineView
from ui.window.action_binding import ActionBinding
from ui.window.delivery import UiThread
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
    context : services of the window
    portraits : the studio that takes those of key expressions
    """

    advised = Signal(str)
    failed = Signal(str)

    def __init__(
        self,
        view: TimelineView,
        binding: ActionBinding,
        viewport: Viewport,
        context: Context,
        portraits: Portraits,
    ) -> None:
        # Its signals keep what is connected to them; they have to end with the window that is.
        super().__init__(viewport.window())
        self.timeline, self.view = view.timeline, view
        document, playhead, deliver = view.timeline.document, view.timeline.playhead, UiThread(self).deliver
        self.sounds = SoundShelf(document, deliver)
        self.accompaniment = Accompaniment(document, playhead)
        dialogs = TimelineDialogs(viewport.window(), self.timeline, context, self.sounds, lambda: self.dock.open())
        self.exchange = Exchange(self.timeline, context, dialogs, deliver)
        self.painter = LinePainter(KeyPortraits(self.timeline, portraits).picture)
        portraits.taken.connect(lambda _name: self.painter.refreshed.emit())
        self.painter.add("audio", SoundPainter(self.sounds).paint)
        self.inspector = Inspector(self.timeline, self._pages())
        self.panel = TimelinePanel(view, binding, self.painter, self.inspector)
        transport = Transport(self.timeline, binding, self.inspector)
        self.dock = TimelineDock(transport, self.panel)
        self.timeline.changed.connect(self._open_page)
        self.timeline.playhead.posed.connect(lambda pose: viewport.turn_head(pose.rigid))
        canvas = viewport.canvas
        self._player = Player(playhead, lambda: self.timeline.rate, lambda: canvas.frames, self.accompaniment.tick)
        self.panel.advised.connect(self.advised)
        self.panel.failed.connect(self.failed)
        self.sounds.changed.connect(self._take_sound)
        self.accompaniment.failed.connect(self.failed.emit)

    def _open_page(self, now: TimelineState, before: TimelineState) -> None:
        """What was asked for is shown even if everything was folded: a new key, or a page of parameters."""
        if (now.page and not before.page) or (now.chosen and not before.chosen):
            self.dock.open()
        if now.page and not before.page:
            self.timeline.change(fields=True)

    def close(self) -> None:
        """Stop for good."""
        self.accompaniment.close()
        self.timeline.playhead.close()
        self.sounds.close()
        self.exchange.close()

    def _take_sound(self) -> None:
        self.accompaniment.take(self.sounds.sound)
        self.view.content.emit()

    def _pages(self) -> dict[str, Make]:
        asks = self.exchange.asks
        return {
            **PAGES,
            "audio": audio_page(self.sounds),
            "speech": lambda timeline: SpeechFields(timeline, asks.type_speech, asks.edit_visemes),
        }


PAGES: dict[str, Make] = {
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


def desk_actions(view: TimelineView, desk: Callable[[], TimelineDesk]) -> tuple[Action, ...]:
    """All actions of the timeline; its desk is asked for when one needs it."""
    exchanging = exchange_actions(lambda: desk().exchange, view.timeline)
    return (*timeline_actions(view.timeline), *sight_actions(view), *exchanging)

"""The body of the timeline on a window of its own, over the small face with a bit of everything on it."""

from collections.abc import Callable, Iterator

import pytest
from PySide6.QtWidgets import QMainWindow

from app.actions import Context
from app.actions.table import all_actions
from app.document import Document
from app.playback import Playhead
from app.timeline.actions import timeline_actions
from app.timeline.sounds import SoundShelf
from app.timeline.timeline import Timeline
from tests.app.conftest import context as context
from tests.app.conftest import desk as desk
from tests.timeline.stage import lively, with_animation
from tests.ui.timeline.stage import Stage
from ui.timeline.desk import PAGES
from ui.timeline.inspector.inspector import Inspector
from ui.timeline.inspector.sound_page import audio_page
from ui.timeline.inspector.speech_page import SpeechFields
from ui.timeline.line_paint import LinePainter
from ui.timeline.paint.sound import SoundPainter
from ui.timeline.panel import TimelinePanel
from ui.timeline.sight_actions import sight_actions
from ui.timeline.transport import Transport
from ui.timeline.view import TimelineView
from ui.window.action_binding import ActionBinding
from ui.window.held_hand import HeldHand


@pytest.fixture
def document(patch) -> Document:
    return Document(with_animation(patch, lively()))


@pytest.fixture
def stage(shown: Callable, context: Context) -> Iterator[Stage]:
    timeline = Timeline(context.document, Playhead(context.document))
    view = TimelineView(timeline)
    window = QMainWindow()
    own = (*timeline_actions(timeline), *sight_actions(view))
    signals = (timeline.changed, timeline.playhead.playing_changed)
    binding = ActionBinding(window, context, lambda each: (*all_actions(each), *own), signals)
    hand = HeldHand(window, binding.qt)
    shelf, opened = SoundShelf(context.document), list[str]()
    painter = LinePainter(lambda _time: None)
    painter.add("audio", SoundPainter(shelf).paint)
    pages = {
        **PAGES,
        "audio": audio_page(shelf),
        "speech": lambda each: SpeechFields(each, lambda: opened.append("type"), lambda: opened.append("visemes")),
    }
    panel = TimelinePanel(view, binding, painter, Inspector(timeline, pages))
    transport = Transport(timeline, binding, panel.inspector)
    transport.show_folded(False)
    window.setCentralWidget(panel)
    window.setMenuWidget(transport)
    window.resize(1200, 760)
    shown(window)
    made = Stage(window, context, timeline, view, panel, transport, opened)
    made.settle()
    yield made
    hand.close()
    shelf.close()
    timeline.playhead.close()

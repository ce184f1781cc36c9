"""The dialogs of the timeline as `app.timeline.exchange.Asks` wants them."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QWidget

from app.actions.context import Context, FileQuestion
from app.actions.paths import folder, with_suffix
from app.timeline.exchange import Again
from app.timeline.sounds import SoundShelf
from app.timeline.timeline import Timeline
from facemodel.animation.capture import Capture
from ui.timeline.dialogs.mapping_page import MappingPage
from ui.timeline.dialogs.speech_page import SpeechPage
from ui.timeline.dialogs.viseme_page import VisemePage

WAV = ".wav"


class TimelineDialogs:
    """Opens dialogs over a window.

    Parameters
    ----------
    parent : the window
    timeline : what they are about
    context : services of the window
    shelf : where the sound is
    unfold : brings the timeline into view
    """

    def __init__(
        self,
        parent: QWidget,
        timeline: Timeline,
        context: Context,
        shelf: SoundShelf,
        unfold: Callable[[], None],
    ) -> None:
        self._parent, self._timeline, self._context, self._shelf = parent, timeline, context, shelf
        self._unfold = unfold
        self._speech: SpeechPage | None = None
        self._visemes: VisemePage | None = None
        self._mapping: MappingPage | None = None

    def map_capture(self, capture: Capture, path: Path, again: Again) -> None:
        """Show how the channels of a capture become those of the face, and take it in when that is settled.

        One that still waits is taken in as it is seen.
        """
        if self._mapping is not None:
            self._mapping.accept()
        self._mapping = page = MappingPage(self._parent, self._timeline, self._context.host, capture, path, again)
        self._unfold()
        page.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        page.accepted.connect(lambda: self._context.host.show_message(f"Imported {path.name}: {page.notes.text()}"))
        page.finished.connect(self._mapped)
        page.show()
        self._context.host.show_message(f"Scrub or play to see what {path.name} does; “Import” takes it in")

    def _mapped(self, _how: int) -> None:
        self._mapping = None

    def type_speech(self) -> None:
        """Let words or sounds be typed; the window stays in reach, so that one can scrub to where they belong."""
        if self._speech is None:
            self._speech = SpeechPage(self._parent, self._timeline, lambda: self._shelf.sound, self._ask_voice)
            self._speech.finished.connect(self._spoken)
            self._speech.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
            self._unfold()
        self._speech.show()
        self._speech.raise_()
        self._speech.activateWindow()

    def _spoken(self, _how: int) -> None:
        page, self._speech = self._speech, None
        if page is not None and page.notes:
            self._context.host.show_message(" ".join(page.notes))

    def edit_visemes(self) -> None:
        """Let it be changed what sounds look like, beside the face and the timeline."""
        if self._visemes is None:
            self._visemes = VisemePage(self._parent, self._timeline)
            self._visemes.finished.connect(self._edited)
            self._visemes.setAttribute(Qt.WidgetAttribute.WA_DeleteOnClose)
        self._visemes.show()
        self._visemes.raise_()
        self._visemes.activateWindow()

    def _edited(self, _how: int) -> None:
        self._visemes = None

    def _ask_voice(self) -> Path | None:
        start = folder(self._context) / f"voice{WAV}"
        path = self._context.host.ask_path(FileQuestion("Save voice", "WAV sound", WAV, start, writes=True))
        return None if path is None else with_suffix(path, WAV)

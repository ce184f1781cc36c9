"""What is said from the playhead on: words, where eSpeak NG knows how they sound, or the sounds themselves."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from PySide6.QtCore import QEvent
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import QDialog, QDialogButtonBox, QLabel, QPlainTextEdit, QTabBar, QVBoxLayout, QWidget

from app.authoring.importing import Imported, with_sound, with_spoken
from app.speech import espeak_program, sounds_of_text, spoken_sound
from app.timeline.timeline import Timeline
from facemodel.animation.editing.speech import laid_out, typed
from facemodel.animation.sound import Sound, voiced_span
from facemodel.errors import RisoriusError
from facemodel.io.audio import write_sound
from ui.theme.metrics import GRID
from ui.timeline.dialogs.aside import stand_aside
from ui.timeline.inspector.page import push_button
from ui.widgets.number_bar import NumberBar
from ui.widgets.number_scale import NumberScale
from ui.widgets.plain_label import PlainLabel

LENGTH = NumberScale(0.0, 20.0, 0.0, "s", bend=1.6)

SOUNDS = "Sounds apart by spaces, in ARPAbet or IPA; | or punctuation is a pause: HH AH0 L OW1 | M AY1 N EY1 M"
WORDS = "Words as they are written. Each sound lasts as long as its kind usually does, or all fit a length."
MISSING = "Words need eSpeak NG, which is not installed here. Install espeak-ng, or type the sounds."

AskPath = Callable[[], Path | None]


class SpeechPage(QDialog):
    """Asks what is said.

    Parameters
    ----------
    timeline : where it comes to
    sound : tells which sound plays along, if there is one: what is said can be made to fit it
    ask_path : asks where a voice is to be written
    """

    def __init__(
        self, parent: QWidget, timeline: Timeline, sound: Callable[[], Sound | None], ask_path: AskPath
    ) -> None:
        super().__init__(parent)
        self._timeline, self._sound, self._ask_path = timeline, sound, ask_path
        self.notes: tuple[str, ...] = ()
        self.setWindowTitle("Type speech")
        self.resize(60 * GRID, 36 * GRID)
        self.kind = QTabBar()
        self.kind.setObjectName("parts")
        self.kind.setDrawBase(False)
        self.kind.addTab("Words")
        self.kind.addTab("Sounds")
        self.hint = QLabel()
        self.hint.setWordWrap(True)
        self.hint.setProperty("role", "muted")
        self.text = QPlainTextEdit()
        self.text.setAccessibleName("What is said")
        self.length = NumberBar("Length (0: as long as it takes)", LENGTH)
        self.complaint = PlainLabel()
        self.complaint.setWordWrap(True)
        self.complaint.setProperty("role", "error")
        self.complaint.hide()
        self._lay_out()
        self.kind.currentChanged.connect(lambda _tab: self._follow())
        if espeak_program() is None:
            self.kind.setCurrentIndex(1)
        self._follow()

    def showEvent(self, event: QShowEvent) -> None:
        """Stand at the upper right, so that the face and the timeline are seen."""
        super().showEvent(event)
        stand_aside(self)

    def changeEvent(self, event: QEvent) -> None:
        """Offer to fit the sound where one has come meanwhile."""
        super().changeEvent(event)
        if event.type() == QEvent.Type.ActivationChange and hasattr(self, "fit"):
            self.fit.setVisible(self._sound() is not None)

    def say(self) -> None:
        """Let the face say it, in one step, and close."""
        self._try(self._spoken, "Type speech")

    def say_aloud(self) -> None:
        """Let a voice say it too, in a file that plays along."""
        path = self._ask_path()
        if path is not None:
            self._try(lambda: self._voiced(path), "Speak")

    def _try(self, make: Callable[[], Imported], label: str) -> None:
        try:
            found = make()
        except RisoriusError as error:
            self.complaint.setText(str(error))
            self.complaint.show()
            return
        self._timeline.document.edit(found.project, label)
        self.notes = found.notes
        self.accept()

    def _spoken(self) -> Imported:
        document, time = self._timeline.document, self._timeline.playhead.time
        length = self.length.value or None
        if self.kind.currentIndex() == 1:
            return with_spoken(document.project, laid_out(typed(self.text.toPlainText()), time, length))
        return with_spoken(document.project, *sounds_of_text(self.text.toPlainText(), time, length))

    def _voiced(self, path: Path) -> Imported:
        document, time = self._timeline.document, self._timeline.playhead.time
        sound = spoken_sound(self.text.toPlainText())
        begin, end = voiced_span(sound)
        phonemes, words = sounds_of_text(self.text.toPlainText(), time + begin, end - begin)
        write_sound(sound, path)
        home = None if document.path is None else document.path.parent
        found = with_spoken(document.project, phonemes, words)
        return Imported(with_sound(found.project, path, sound, home, time), found.notes)

    def _fit(self) -> None:
        sound = self._sound()
        if sound is not None:
            begin, end = voiced_span(sound)
            self.length.set_value(end - begin)

    def _follow(self) -> None:
        words = self.kind.currentIndex() == 0
        possible = not words or espeak_program() is not None
        self.hint.setText((WORDS if possible else MISSING) if words else SOUNDS)
        self.take.setEnabled(possible)
        self.voice.setVisible(words and possible)
        self.complaint.hide()

    def _lay_out(self) -> None:
        layout = QVBoxLayout(self)
        layout.setContentsMargins(3 * GRID, 2 * GRID, 3 * GRID, 2 * GRID)
        layout.setSpacing(GRID)
        for widget in (self.kind, self.hint):
            layout.addWidget(widget)
        layout.addWidget(self.text, 1)
        layout.addWidget(self.length)
        self.fit = push_button("Fit the sound that plays along", self._fit, "As long as somebody speaks in it")
        self.fit.setVisible(self._sound() is not None)
        layout.addWidget(self.fit)
        layout.addWidget(self.complaint)
        buttons = QDialogButtonBox(QDialogButtonBox.StandardButton.Cancel)
        self.voice = buttons.addButton("Say it aloud…", QDialogButtonBox.ButtonRole.ActionRole)
        self.voice.setToolTip("Write a voice of eSpeak NG into a WAV file, which plays along")
        self.voice.clicked.connect(lambda *_on: self.say_aloud())
        self.take = buttons.addButton("Say it", QDialogButtonBox.ButtonRole.AcceptRole)
        self.take.setDefault(True)
        buttons.accepted.connect(self.say)
        buttons.rejected.connect(self.reject)
        layout.addWidget(buttons)

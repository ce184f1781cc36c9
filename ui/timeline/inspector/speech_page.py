"""Fields about speech: one or several sounds, or all that is said."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from app.timeline.chosen import Chosen
from app.timeline.moving import Edited
from app.timeline.readings import Reading, start_of, with_start
from app.timeline.timeline import Timeline
from facemodel.animation.clip import Animation
from facemodel.animation.editing.speech import renamed_phoneme, with_bounds
from facemodel.animation.speech import VisemeTable
from facemodel.animation.visemes import mouth_table
from ui.timeline.inspector.field import FieldBar, TimeBar
from ui.timeline.inspector.marks_pages import NameLine
from ui.timeline.inspector.page import Page, push_button
from ui.widgets.number_scale import NumberScale

LENGTH = NumberScale(0.01, 1.0, 0.1, "s", bend=1.6)


class SoundPage(Page):
    """Sounds."""

    def __init__(self, timeline: Timeline) -> None:
        places = sorted(timeline.chosen.sounds)
        super().__init__(timeline, "Sound" if len(places) == 1 else f"{len(places)} sounds")
        self._place = places[0]
        if len(places) == 1:
            symbol = NameLine(timeline.animation.speech.phonemes[self._place].symbol, self._rename)
            symbol.setPlaceholderText("Symbol, such as AA, M or ʃ")
            self.add(symbol)
        self.add(TimeBar(timeline, "Start", start_of, with_start(timeline.document.project.units)))
        if len(places) == 1:
            self.add(FieldBar(timeline, "Length", LENGTH, self._length, self._with_length))
            self.viseme = self.caption("")
        self.refresh()

    def refresh(self) -> None:
        """Say which viseme it is."""
        super().refresh()
        sounds = self.timeline.animation.speech.phonemes
        if hasattr(self, "viseme") and self._place < len(sounds):
            speech = self.timeline.animation.speech
            found = VisemeTable(speech.visemes or mouth_table().visemes).find(sounds[self._place].symbol)
            self.viseme.setText(f"Viseme {found.name}" if found else "No viseme is known for it; the mouth rests")

    def _rename(self, symbol: str) -> None:
        if symbol:
            self.timeline.edit(renamed_phoneme(self.timeline.animation, self._place, symbol), "Change sound")

    def _length(self, animation: Animation, _chosen: Chosen) -> Reading | None:
        sounds = animation.speech.phonemes
        if self._place >= len(sounds):
            return None
        return Reading(sounds[self._place].end - sounds[self._place].start)

    def _with_length(self, animation: Animation, chosen: Chosen, seconds: float) -> Edited:
        start = animation.speech.phonemes[self._place].start
        return with_bounds(animation, self._place, end=start + seconds), chosen


class SpeechFields(Page):
    """All that is said.

    Parameters
    ----------
    type_speech, edit_visemes : open what edits text and visemes
    """

    def __init__(self, timeline: Timeline, type_speech: Callable[[], None], edit_visemes: Callable[[], None]) -> None:
        super().__init__(timeline, "Speech")
        strength = NumberScale(0.0, 1.5, 1.0)
        self.add(FieldBar(timeline, "Strength", strength, _strength, _with_strength))
        self.gap()
        self.add(push_button("Type speech…", type_speech, "Type words or sounds"))
        self.add(push_button("Visemes…", edit_visemes, "Change what sounds look like"))


def _strength(animation: Animation, _chosen: Chosen) -> Reading:
    return Reading(animation.speech.strength)


def _with_strength(animation: Animation, chosen: Chosen, strength: float) -> Edited:
    return replace(animation, speech=replace(animation.speech, strength=strength)), chosen

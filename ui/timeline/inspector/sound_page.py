"""Fields about the sound that plays along."""

from __future__ import annotations

from dataclasses import replace
from functools import partial

from app.timeline.chosen import Chosen
from app.timeline.moving import Edited
from app.timeline.readings import Reading
from app.timeline.sounds import SoundShelf, shortage
from app.timeline.timeline import Timeline
from facemodel.animation.clip import Animation
from ui.timeline.inspector.field import FieldBar
from ui.timeline.inspector.page import Page, push_button
from ui.widgets.number_scale import NumberScale

START = NumberScale(-10.0, 60.0, 0.0, "s")


class AudioPage(Page):
    """The sound.

    Parameters
    ----------
    shelf : where it is
    """

    def __init__(self, shelf: SoundShelf, timeline: Timeline) -> None:
        super().__init__(timeline, "Sound")
        self._shelf = shelf
        self.what = self.caption("")
        self.add(FieldBar(timeline, "Start", START, _start, _with_start))
        self.gap()
        self.add(push_button("Remove", self._remove, "Play in silence"))
        self.refresh()

    def refresh(self) -> None:
        """Say what it is."""
        super().refresh()
        heard = self._shelf.heard
        if heard is not None:
            channels = {1: "mono", 2: "stereo"}.get(heard.sound.samples.shape[1], "several channels")
            name = shortage(heard.path.name, heard.sound) or heard.path.name
            self.what.setText(f"{name}\n{heard.sound.duration:.2f} s · {heard.sound.rate:,} Hz · {channels}")
        else:
            self.what.setText(self._shelf.complaint or "Reading …")

    def _remove(self) -> None:
        self.timeline.edit(replace(self.timeline.animation, audio=None), "Remove sound")


def audio_page(shelf: SoundShelf) -> partial[AudioPage]:
    """Makes pages about the sound on a shelf."""
    return partial(AudioPage, shelf)


def _start(animation: Animation, _chosen: Chosen) -> Reading | None:
    return None if animation.audio is None else Reading(animation.audio.start)


def _with_start(animation: Animation, chosen: Chosen, seconds: float) -> Edited:
    if animation.audio is None:
        return animation, chosen
    return replace(animation, audio=replace(animation.audio, start=seconds)), chosen

"""The sound of an animation, read in the background whenever it is another one."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

from psygnal import Signal

from app.authoring.importing import sound_path
from app.document import Document
from app.jobs import Deliver, Failure, Job
from facemodel.animation.sound import Sound, Waveform, waveform
from facemodel.io.audio import read_sound
from facemodel.solve import Progress


@dataclass(frozen=True, eq=False)
class Heard:
    """A sound that was read, with the outline in which it is drawn."""

    path: Path
    sound: Sound
    outline: Waveform


class SoundShelf:
    """Keeps the sound of a document's animation.

    Parameters
    ----------
    document : whose animation has a sound
    deliver : brings what was read to the thread of the document; without it reading is waited for
    """

    changed = Signal()
    """Another sound was read, there is none any more, or it could not be read."""

    def __init__(self, document: Document, deliver: Deliver | None = None) -> None:
        self._document = document
        self._wanted: Path | None = None
        self.heard: Heard | None = None
        self.complaint = ""
        self.job: Job[Path, Heard] = Job(_read, deliver)
        self.job.finished.connect(self._take)
        self.job.failed.connect(self._fail)
        document.animation_changed.connect(self._follow)
        document.project_changed.connect(self._follow)
        document.saved_changed.connect(self._follow)
        self._follow()

    @property
    def sound(self) -> Sound | None:
        """The sound, once it was read."""
        return None if self.heard is None else self.heard.sound

    def close(self) -> None:
        """Read no more."""
        self.job.close()

    def _follow(self, *_what: object) -> None:
        audio, home = self._document.project.animation.audio, self._document.path
        wanted = None if audio is None else sound_path(audio, None if home is None else home.parent)
        if wanted == self._wanted:
            return
        self._wanted = wanted
        if self.heard is not None and (wanted is None or self.heard.path != wanted):
            self.heard = None
        self.complaint = ""
        self.changed.emit()
        if wanted is not None:
            self.job.request(wanted)

    def _take(self, heard: Heard, asked: Path) -> None:
        if asked == self._wanted:
            self.heard = heard
            self.changed.emit()

    def _fail(self, failure: Failure) -> None:
        self.complaint = failure.sentence
        self.changed.emit()


def shortage(name: str, sound: Sound) -> str:
    """What to say of a sound whose file is cut short; nothing of a whole one."""
    if not sound.missing:
        return ""
    there, promised = sound.duration, sound.duration + sound.missing
    return f"“{name}” is cut short: {there:.2f} of {promised:,.2f} s are there and play; save it again for the rest."


def _read(path: Path, progress: Progress) -> Heard:
    progress(f"Reading {path.name}", 0.0)
    sound = read_sound(path)
    progress(f"Reading {path.name}", 0.7)
    return Heard(path, sound, waveform(sound))

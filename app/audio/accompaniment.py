"""A sound that plays along with a playhead, which follows it: pictures are left out, the sound never is."""

from __future__ import annotations

import time

from psygnal import Signal

from app.audio.source import Source
from app.audio.speaker import AudioError, Open, Speaker, open_speaker
from app.document import Document
from app.playback.clock import Now
from app.playback.playhead import Playhead
from facemodel.animation.sound import Sound

PATIENCE = 1.0
"""Seconds after which pictures no longer wait for a loudspeaker that does not begin."""

ASTRAY = 0.3
"""Seconds between sound and playhead beyond which somebody has gone elsewhere while it played."""


class Accompaniment:
    """Plays the sound of an animation while its playhead plays.

    Parameters
    ----------
    document : whose animation has a sound
    playhead : that it plays along with
    speaker : opens the loudspeaker
    now : the real clock
    """

    failed = Signal(str)
    """(sentence) no sound can be played; told once, the animation plays on."""

    def __init__(
        self, document: Document, playhead: Playhead, speaker: Open = open_speaker, now: Now = time.perf_counter
    ) -> None:
        self._now, self._begun, self._waits = now, 0.0, False
        self._document, self._playhead, self._open = document, playhead, speaker
        self._sound: Sound | None = None
        self._source: Source | None = None
        self._speaker: Speaker | None = None
        self._told = False
        playhead.playing_changed.connect(self._follow)
        playhead.moved.connect(self._go_along)

    @property
    def sounding(self) -> bool:
        """Whether something is handed to the loudspeaker."""
        return self._speaker is not None

    @property
    def source(self) -> Source | None:
        """What is handed to the loudspeaker now."""
        return self._source

    def take(self, sound: Sound | None) -> None:
        """Play another sound from now on, or none."""
        self._sound = sound
        if self._playhead.playing:
            self._stop()
            self._start()

    def tick(self) -> bool:
        """Tell the playhead what is heard now; whether pictures may go on, which wait for the sound to begin.

        To be called before the playhead is asked for the frame that is due.
        """
        source, speaker = self._source, self._speaker
        if source is None or speaker is None:
            return True
        if source.handed >= speaker.waiting:
            if self._waits:
                self._waits = False
                self._playhead.go(self._playhead.time)
            self._playhead.hear(source.heard(speaker.waiting))
        elif self._waits and self._now() - self._begun > PATIENCE:
            self._waits = False
        return not self._waits

    def close(self) -> None:
        """Be silent for good."""
        self._stop()
        self._playhead.playing_changed.disconnect(self._follow)
        self._playhead.moved.disconnect(self._go_along)

    def _follow(self, playing: bool) -> None:
        self._start() if playing else self._stop()

    def _start(self) -> None:
        animation = self._document.project.animation
        if self._sound is None or animation.audio is None or animation.audio.muted:
            return
        span = (animation.start, animation.end)
        source = Source(self._sound, animation.audio.start, span, animation.loop, self._now)
        source.seek(self._playhead.time)
        try:
            self._speaker = self._open(source.rate, source.channels, source.read)
        except AudioError as error:
            if not self._told:
                self._told = True
                self.failed.emit(str(error))
            return
        self._source, self._waits, self._begun = source, True, self._now()

    def _stop(self) -> None:
        speaker, self._speaker, self._source = self._speaker, None, None
        if speaker is not None:
            speaker.close()

    def _go_along(self, seconds: float) -> None:
        """Somebody went elsewhere while it played."""
        source, speaker = self._source, self._speaker
        if source is None or speaker is None or self._waits:
            return
        off = abs(source.heard(speaker.waiting) - seconds)
        animation = self._document.project.animation
        length = animation.end - animation.start
        if min(off, abs(length - off) if animation.loop else off) > ASTRAY:
            source.seek(seconds)

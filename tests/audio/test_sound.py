"""The sound is the clock: pictures follow what was handed to the loudspeaker, over minutes and over loops."""

from collections.abc import Callable
from dataclasses import replace

import numpy as np
import pytest
from hypothesis import given
from hypothesis import strategies as st

from app.audio import Accompaniment, AudioError, open_speaker
from app.audio.source import Source
from app.document import Document
from app.playback import Playhead
from facemodel.animation.clip import Animation, Audio
from facemodel.animation.curve import Key, curve_of
from facemodel.animation.sound import Sound
from facemodel.animation.track import Track

RATE = 8000


def ramp(seconds: float, channels: int = 1) -> Sound:
    """Return a sound whose every sample says where it is."""
    count = round(seconds * RATE)
    return Sound(np.repeat(np.arange(1, count + 1, dtype=np.float32)[:, None], channels, axis=1), RATE)


class Room:
    """A real clock, and a loudspeaker in it that takes samples at a pace of its own."""

    def __init__(self, pace: float = 1.0, waiting: int = 1200, block: int = 400) -> None:
        self.now, self._pace, self._block = 50.0, pace, block
        self.waiting = waiting
        self.taken = 0
        self._owed = 0.0
        self._fill: Callable[[int], np.ndarray] | None = None

    def open(self, rate: int, channels: int, fill: Callable[[int], np.ndarray]) -> "Room":
        assert rate == RATE
        self._fill = fill
        self._hand(self.waiting)
        return self

    def close(self) -> None:
        self._fill = None

    def pass_time(self, seconds: float) -> None:
        """Let time pass in small steps, so that samples are asked for when they are wanted."""
        steps = max(round(seconds / 0.004), 1)
        for _ in range(steps):
            self.now += seconds / steps
            self._owed += seconds / steps * RATE * self._pace
            while self._owed >= self._block:
                self._owed -= self._block
                self._hand(self._block)

    @property
    def heard(self) -> float:
        """Seconds of sound that came out of the loudspeaker."""
        return (self.taken - self.waiting + self._owed) / RATE

    def _hand(self, count: int) -> None:
        if self._fill is not None:
            assert self._fill(count).shape[0] == count
            self.taken += count


def playing(document: Document, room: Room, seconds: float, loop: bool = False) -> tuple[Playhead, Accompaniment]:
    rise = Track("17", curve_of([Key(0, 0), Key(seconds, 1)]))
    animation = Animation((rise,), end=seconds, loop=loop, audio=Audio("voice.wav"))
    document.edit(replace(document.project, animation=animation), "Animate")
    playhead = Playhead(document, lambda: room.now)
    sound = Accompaniment(document, playhead, room.open, lambda: room.now)
    sound.take(ramp(seconds))
    playhead.play()
    return playhead, sound


def go_on(room: Room, playhead: Playhead, sound: Accompaniment, seconds: float) -> None:
    """Let a frame be asked for, as the window does."""
    room.pass_time(seconds)
    if sound.tick():
        playhead.tick()


@pytest.mark.parametrize("pace", [0.999, 1.0, 1.001])
def test_pictures_stay_within_a_frame_of_the_sound_for_five_minutes(document: Document, pace: float) -> None:
    room = Room(pace)
    playhead, sound = playing(document, room, 310.0)
    worst = 0.0
    for _ in range(300 * 30):
        go_on(room, playhead, sound, 1 / 30)
        # A frame is shown from its time on: in the middle it is half of its length late.
        worst = max(worst, abs(playhead.time + 0.5 / 30 - room.heard))
    assert room.heard > 295
    assert worst < 1 / 30


def test_a_slow_picture_is_left_out_and_the_sound_never_is(document: Document) -> None:
    room = Room()
    playhead, sound = playing(document, room, 60.0)
    for step in range(200):
        go_on(room, playhead, sound, 0.27 if step % 3 else 0.01)
    assert abs(playhead.time - room.heard) < 1 / 30
    assert playhead.dropped > 100


def test_a_loop_is_heard_without_a_gap(document: Document) -> None:
    room = Room()
    playhead, sound = playing(document, room, 1.0, loop=True)
    for _ in range(100):
        go_on(room, playhead, sound, 1 / 30)
    assert room.heard > 3
    off = abs(playhead.time - room.heard % 1.0)
    assert min(off, 1 - off) < 2 / 30


def test_pictures_wait_for_the_sound_to_begin(document: Document) -> None:
    room = Room()
    late = Room()

    def sluggish(rate: int, channels: int, fill: Callable[[int], np.ndarray]) -> Room:
        late.open(rate, channels, lambda count: fill(count))
        return late

    room.open = sluggish  # type: ignore[method-assign]
    late._hand = lambda count: None  # type: ignore[method-assign]
    playhead, sound = playing(document, room, 10.0)
    room.pass_time(0.5)
    assert not sound.tick()
    assert playhead.time == 0.0
    room.pass_time(0.6)
    assert sound.tick()


def test_scrubbing_while_it_plays_takes_the_sound_along(document: Document) -> None:
    room = Room()
    playhead, sound = playing(document, room, 60.0)
    for _ in range(30):
        go_on(room, playhead, sound, 1 / 30)
    playhead.go(30.0)
    for _ in range(30):
        go_on(room, playhead, sound, 1 / 30)
    assert sound.source is not None
    assert playhead.time == pytest.approx(31.0, abs=0.2)
    assert sound.source.heard(room.waiting) == pytest.approx(playhead.time, abs=0.05)


def test_a_muted_sound_and_a_still_playhead_hand_nothing_out(document: Document) -> None:
    room = Room()
    playhead, sound = playing(document, room, 10.0)
    assert sound.sounding
    playhead.pause()
    assert not sound.sounding
    muted = replace(document.project.animation.audio, muted=True)
    document.edit(replace(document.project, animation=replace(document.project.animation, audio=muted)), "Mute")
    playhead.play()
    assert not sound.sounding
    assert sound.tick()


def test_without_a_loudspeaker_it_is_said_once_and_played_in_silence(document: Document) -> None:
    def missing(*_: object) -> Room:
        raise AudioError("There is no loudspeaker.")

    room = Room()
    room.open = missing  # type: ignore[method-assign]
    rise = Track("17", curve_of([Key(0, 0), Key(1, 1)]))
    animation = Animation((rise,), end=2.0, audio=Audio("voice.wav"))
    document.edit(replace(document.project, animation=animation), "Animate")
    playhead = Playhead(document, lambda: room.now)
    sound = Accompaniment(document, playhead, missing, lambda: room.now)
    said: list[str] = []
    sound.failed.connect(said.append)
    sound.take(ramp(2.0))
    for _ in range(2):
        playhead.play()
        go_on(room, playhead, sound, 0.5)
        playhead.pause()
    assert said == ["There is no loudspeaker."]
    assert playhead.time > 0.4


@given(st.floats(-1, 1), st.floats(0, 1), st.floats(0.01, 2), st.booleans(), st.lists(st.integers(0, 3000), max_size=8))
def test_every_sample_is_that_of_its_time(begins, start, length, loops, counts) -> None:
    sound = ramp(1.0)
    source = Source(sound, begins, (start, start + length), loops)
    first, last = round(start * RATE), max(round((start + length) * RATE), 1)
    source.seek(start)
    at = first
    for count in counts:
        for sample in source.read(count)[:, 0].tolist():
            place = at - round(begins * RATE)
            silent = not 0 <= place < len(sound.samples) or at >= last
            assert sample == (0.0 if silent else place + 1)
            at += 1
            if loops and last > first and at >= last:
                at = first


def test_more_channels_than_loudspeakers_are_heard_from_both() -> None:
    source = Source(ramp(0.1, channels=6), 0.0, (0.0, 0.1), False)
    assert source.channels == 2
    assert source.read(3).tolist() == [[1, 1], [2, 2], [3, 3]]


def test_the_library_hands_samples_on() -> None:
    miniaudio = pytest.importorskip("miniaudio")
    source = Source(ramp(1.0), 0.0, (0.0, 1.0), True)
    speaker = open_speaker(RATE, source.channels, source.read, [miniaudio.Backend.NULL])
    try:
        while source.handed <= speaker.waiting:
            pass
        assert source.heard(speaker.waiting) >= 0.0
    finally:
        speaker.close()


def test_a_computer_without_the_library_says_what_to_do(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setitem(__import__("sys").modules, "miniaudio", None)
    with pytest.raises(AudioError, match=r"risorius\[audio\]"):
        open_speaker(RATE, 1, lambda count: np.zeros((count, 1), np.float32))

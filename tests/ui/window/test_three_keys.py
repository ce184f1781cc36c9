"""A newcomer makes three key expressions with a voice, as the walk-through says, and the face plays them."""

import numpy as np
import pytest
from PySide6.QtTest import QTest
from PySide6.QtWidgets import QFileDialog

from docs.first_face import Hand
from docs.three_keys import KEYS, walk
from facemodel.animation.evaluation import Evaluator
from facemodel.animation.sound import Sound
from facemodel.io.audio import write_sound
from ui.window.main_window import MainWindow

RATE = 8000
BEGINS, ENDS = 0.2, 1.6
"""Seconds of the sound between which somebody speaks."""


@pytest.fixture
def walked(open_window, document, tmp_path, monkeypatch) -> MainWindow:
    at = np.arange(2 * RATE) / RATE
    voice = np.where((at > BEGINS) & (at < ENDS), 0.5 * np.sin(2 * np.pi * 180 * at), 0.0)
    write_sound(Sound(voice.astype(np.float32)[:, None], RATE), tmp_path / "voice.wav")
    monkeypatch.setattr(QFileDialog, "getOpenFileName", lambda *_: (str(tmp_path / "voice.wav"), ""))
    window = open_window(document)
    window.resize(1440, 900)
    QTest.qWait(200)
    walk(Hand(window))
    return window


def test_three_keys_with_a_voice_are_made_played_and_taken_back(walked, document):
    animation = document.project.animation
    assert [each.time for each in animation.expressions] == pytest.approx([time for time, _ in KEYS], abs=1 / 30)
    keys_alone = Evaluator(animation, document.project.units).own(np.array([0.0, 1.2, 2.6]))
    channels = Evaluator(animation, document.project.units).channels
    raised, smile, doubt = (keys_alone[:, channels.index(name)] for name in ("1L", "12L", "17"))
    assert raised[0] > 0.5 > raised[1]
    assert smile[1] > 0.5 > smile[0]
    assert doubt[2] > 0.3 > doubt[1]
    assert animation.audio is not None
    assert animation.audio.start == pytest.approx(0.5, abs=1 / 30)
    assert [each.symbol for each in animation.speech.phonemes[:3]] == ["HH", "AH", "L"]
    assert animation.speech.phonemes[-1].end - animation.speech.phonemes[0].start == pytest.approx(1.4, abs=0.1)
    assert [event.key for event in animation.events] != []
    assert not walked.timeline.timeline.playhead.playing
    while document.history.done:
        document.undo()
    assert document.project.animation.tracks == ()
    assert document.project.animation.audio is None
    assert document.project.expression == {}

"""A piece of twenty seconds that shows what a face can do: the seven emotions in turn, a spoken line, blinks."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import replace

from facemodel.actions import ActionUnit
from facemodel.animation.clip import Animation, Marker
from facemodel.animation.editing.speech import laid_out, typed, with_phonemes
from facemodel.animation.idle import Idle
from facemodel.animation.library import find_expression, placed
from facemodel.animation.speech import Word

EMOTIONS = ("happiness", "sadness", "surprise", "fear", "anger", "disgust", "contempt")

LENGTH = 20.0
"""Seconds of the piece."""

EACH, FIRST = 2.1, 0.4
"""Seconds that an emotion takes, and when the first begins."""

SPOKEN_AT, SPOKEN_FOR = 15.6, 3.4
"""When the line begins, and how long it takes, seconds."""

TEXT = "Hello, my face is moved by muscles."
"""What a voice says."""

LINE = (
    ("Hello", "HH AH0 L OW1"),
    ("", "|"),
    ("my", "M AY1"),
    ("face", "F EY1 S"),
    ("is", "IH1 Z"),
    ("moved", "M UW1 V D"),
    ("by", "B AY1"),
    ("muscles", "M AH1 S AH0 L Z"),
)
"""The line, word by word with its sounds."""


def demo_animation(units: Sequence[ActionUnit], spoken: tuple[float, float] | None = None) -> Animation:
    """The piece, for a face with these action units.

    Parameters
    ----------
    spoken : from when to when a voice says the line, seconds after `SPOKEN_AT`; as it is typed if not given
    """
    animation = Animation(end=LENGTH, idle=Idle(seed=7, blinks=18.0))
    for number, name in enumerate(EMOTIONS):
        expression = find_expression(name)
        time = FIRST + number * EACH
        animation, _ = placed(animation, expression, time, units, duration=EACH)
        animation = replace(animation, markers=(*animation.markers, Marker(time, expression.title)))
    words = [typed(sounds)[0] for _, sounds in LINE]
    begin, end = spoken or (0.0, SPOKEN_FOR)
    phonemes = laid_out(words, SPOKEN_AT + begin, end - begin)
    named: list[Word] = []
    at = 0
    for (text, _), sounds in zip(LINE, words, strict=True):
        if text:
            named.append(Word(text, phonemes[at].start, phonemes[at + len(sounds) - 1].end))
        at += len(sounds)
    animation = with_phonemes(animation, phonemes, named)
    animation, _ = placed(animation, find_expression("brow flash"), SPOKEN_AT - 0.1, units)
    animation, _ = placed(animation, find_expression("nod"), SPOKEN_AT + end - 0.5, units)
    return replace(animation, markers=(*animation.markers, Marker(SPOKEN_AT, "Line")))

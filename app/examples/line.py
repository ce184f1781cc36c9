"""A spoken line: its sounds by hand, a voice and their times by eSpeak NG where it is installed."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from app.authoring.importing import with_sound, with_spoken
from app.speech import espeak_program, sounds_of_text, spoken_sound
from facemodel.animation.clip import Animation
from facemodel.animation.editing.speech import laid_out, typed
from facemodel.animation.idle import Idle
from facemodel.animation.library import find_expression, placed
from facemodel.animation.sound import Sound, voiced_span
from facemodel.animation.speech import Phoneme, Word
from facemodel.io.audio import write_sound
from facemodel.project import Project
from facemodel.projects import new_project

TEXT = "Please move the sliders, and watch my lips: they meet for every m, b and p."

TYPED = (
    "P L IY1 Z | M UW1 V | DH AH0 | S L AY1 D ER0 Z | AE1 N D | W AA1 CH | M AY1 | L IH1 P S | "
    "DH EY1 | M IY1 T | F AO1 R | EH1 V R IY0 | EH1 M | B IY1 | AE1 N D | P IY1"
)
"""What is said where nothing on the machine can tell the sounds of a text, in ARPAbet."""

BEGINS = 0.6
"""Seconds before the first sound."""

AFTER = 1.2
"""Seconds behind the last one."""


def line_project(folder: Path) -> Project:
    """A face that says a sentence, lives while it does, and raises its brows where it asks something.

    Raises
    ------
    RisoriusError
        If the voice cannot be made or written.
    """
    project = new_project()
    sound, phonemes, words = _spoken()
    ends = max(each.end for each in phonemes)
    animation = Animation(end=ends + AFTER, idle=Idle(seed=3))
    animation, _ = placed(animation, find_expression("brow flash"), BEGINS - 0.1, project.units)
    animation, _ = placed(animation, find_expression("nod"), ends - 0.4, project.units)
    made = with_spoken(replace(project, animation=animation), phonemes, words).project
    if sound is None:
        return made
    path = folder / "spoken-line.wav"
    write_sound(sound, path)
    return with_sound(made, path, sound, None, BEGINS)


def _spoken() -> tuple[Sound | None, tuple[Phoneme, ...], tuple[Word, ...]]:
    """A voice if there is one, and the sounds as long as it takes for them."""
    if espeak_program() is None:
        return None, laid_out(typed(TYPED), BEGINS), ()
    sound = spoken_sound(TEXT)
    begin, end = voiced_span(sound)
    return sound, *sounds_of_text(TEXT, BEGINS + begin, end - begin)

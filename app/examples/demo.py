"""The piece of twenty seconds, with a voice where there is one."""

from __future__ import annotations

from dataclasses import replace
from pathlib import Path

from app.authoring.importing import with_sound
from app.speech import espeak_program, spoken_sound
from facemodel.animation.demo import SPOKEN_AT, TEXT, demo_animation
from facemodel.animation.sound import voiced_span
from facemodel.faces import DEFAULT_FACE
from facemodel.io.audio import write_sound
from facemodel.project import Project
from facemodel.projects import new_project


def demo_project(voice: Path, face_key: str = DEFAULT_FACE, home: Path | None = None) -> Project:
    """The seven emotions in turn, a spoken line and blinks on a face.

    Parameters
    ----------
    voice : the WAV file into which eSpeak NG says the line; without it the piece is silent
    face_key : which individual
    home : folder of the project's file, if it has one

    Raises
    ------
    RisoriusError
        If the voice cannot be made or written.
    """
    project = new_project(face_key)
    if espeak_program() is None:
        return replace(project, animation=demo_animation(project.units))
    sound = spoken_sound(TEXT)
    write_sound(sound, voice)
    played = replace(project, animation=demo_animation(project.units, voiced_span(sound)))
    return with_sound(played, voice, sound, home, SPOKEN_AT)

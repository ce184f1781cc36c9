"""The sound of a film."""

from __future__ import annotations

from pathlib import Path

from app.authoring.importing import sound_path
from facemodel.animation.sound import Sound, stretch
from facemodel.animation.take import Take
from facemodel.io.audio import read_sound


def soundtrack(take: Take, folder: Path | None) -> Sound | None:
    """What is heard during a take; none where its animation has no sound, or a muted one.

    Parameters
    ----------
    take : the frames
    folder : of the project's file

    Raises
    ------
    ProjectError
        If the file of the sound is missing or damaged.
    """
    audio = take.project.animation.audio
    if audio is None or audio.muted:
        return None
    return stretch(read_sound(sound_path(audio, folder)), take.start - audio.start, take.duration)

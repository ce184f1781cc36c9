"""Captures, phonemes and sounds brought into a project."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from pathlib import Path

from facemodel.animation.capture import Capture
from facemodel.animation.clip import FASTEST, SLOWEST, Animation, Audio
from facemodel.animation.editing.speech import unknown_symbols, with_phonemes
from facemodel.animation.editing.tracks import track_for, with_tracks
from facemodel.animation.mapping import Mapping, default_mapping, mapped
from facemodel.animation.sound import Sound
from facemodel.animation.speech import Phoneme, Word
from facemodel.animation.track import Track
from facemodel.project import Project


@dataclass(frozen=True, eq=False)
class Imported:
    """What came of it.

    Attributes
    ----------
    project : with it
    notes : one sentence each for what was missing, bridged or found no place
    """

    project: Project
    notes: tuple[str, ...] = ()


def with_capture(
    project: Project, capture: Capture, mapping: Mapping | None = None, start: float | None = None
) -> Imported:
    """A project with a captured performance.

    It takes the place of what was captured before on the same channels; keys over it stay, layers go with what they
    bent.  A project in which nothing happened yet takes over its length and rate; another one is made long enough.

    Parameters
    ----------
    mapping : how its channels become those of the face; the shipped table of its kind if not given
    start : when it begins in the clip, seconds; as it was noted if not given
    """
    found = mapped(capture, mapping or default_mapping(capture.kind), project.units, start)
    animation = project.animation
    fresh = _fresh(animation)
    tracks = [_over(track_for(animation, track.channel), track) for track in found.tracks]
    made = with_tracks(animation, tracks)
    if tracks:
        begin = capture.start if start is None else start
        made = _long_enough(made, begin, begin + capture.duration, fresh)
    if tracks and fresh:
        made = replace(made, rate=min(max(capture.rate, SLOWEST), FASTEST))
    return Imported(replace(project, animation=made), (*capture.notes, *found.notes))


def _fresh(animation: Animation) -> bool:
    """Whether nothing happens yet, so that what comes decides how long the clip is."""
    return not animation.moves and animation.audio is None


def _over(standing: Track, track: Track) -> Track:
    """A track with another captured curve; a locked one stays as it is."""
    return standing if standing.locked else replace(standing, captured=track.captured, layers=())


def _long_enough(animation: Animation, begin: float, end: float, fresh: bool) -> Animation:
    """An animation that plays a stretch of time: only it if it is fresh, else that too."""
    if end <= begin:
        return animation
    if fresh:
        return replace(animation, start=begin, end=end)
    return replace(animation, start=min(animation.start, begin), end=max(animation.end, end))


def with_spoken(
    project: Project, phonemes: Sequence[Phoneme], words: Sequence[Word] = (), shift: float = 0.0
) -> Imported:
    """A project that says something, in place of what was said between its beginning and its end.

    Parameters
    ----------
    shift : seconds by which all of it is later
    """
    sounds = [replace(each, start=each.start + shift, end=each.end + shift) for each in phonemes]
    spoken = [replace(each, start=each.start + shift, end=each.end + shift) for each in words]
    fresh = _fresh(project.animation)
    made = with_phonemes(project.animation, sounds, spoken)
    if sounds:
        made = _long_enough(made, min(0.0, sounds[0].start) if fresh else sounds[0].start, sounds[-1].end, fresh)
    strange = unknown_symbols(made.speech)
    notes = (f"No viseme is known for {', '.join(strange)}; the mouth rests there.",) if strange else ()
    return Imported(replace(project, animation=made), notes)


def with_sound(project: Project, path: Path, sound: Sound, home: Path | None = None, start: float = 0.0) -> Project:
    """A project with a sound that plays along, long enough for it.

    Parameters
    ----------
    path : of the sound's file
    home : folder of the project's file, from which on the path is told if the sound lies below it
    start : when it begins in the clip, seconds
    """
    told = path.absolute()
    if home is not None and told.is_relative_to(home.absolute()):
        told = told.relative_to(home.absolute())
    fresh = _fresh(project.animation)
    made = replace(project.animation, audio=Audio(told.as_posix(), start))
    return replace(project, animation=_long_enough(made, start, start + sound.duration, fresh))


def sound_path(audio: Audio, home: Path | None) -> Path:
    """Where the file of a sound is, told from the folder of the project's file if it is not told from the root."""
    path = Path(audio.path)
    return path if path.is_absolute() or home is None else home / path

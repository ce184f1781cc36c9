"""Animation for scripts: keys, expressions, events, speech, captures and exports."""

from __future__ import annotations

import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from pathlib import Path

from app.authoring.importing import Imported, with_capture, with_sound, with_spoken
from app.authoring.recordings import capture_from
from app.errors import NumberError
from app.scripting.desk import ScriptDesk
from app.speech import sounds_of_text, spoken_sound
from facemodel.actions import find_emotion
from facemodel.animation.clip import Animation
from facemodel.animation.curve import Shape
from facemodel.animation.displacement import SPACING
from facemodel.animation.editing import bulk, dense, marks
from facemodel.animation.editing.events import moved_events, without_events
from facemodel.animation.editing.expressions import keyed, with_expression
from facemodel.animation.editing.selection import curve_of_row, rows, selected
from facemodel.animation.editing.speech import laid_out, typed
from facemodel.animation.evaluation import Evaluator, sampled
from facemodel.animation.idle import Idle
from facemodel.animation.library import dynamic, library, placed
from facemodel.animation.mapping import fields_of
from facemodel.animation.sound import voiced_span
from facemodel.animation.track import Track
from facemodel.errors import UnknownNameError
from facemodel.io.audio import read_sound, write_sound
from facemodel.io.speech import read_speech
from facemodel.io.weights.mapping_file import load_mapping
from facemodel.io.weights.writing import WEIGHT_EXPORTS, Animated, export_weights

PUBLIC = (
    "animation",
    "bake",
    "delete_events",
    "delete_keys",
    "drop",
    "export_weights",
    "frame_rate",
    "idle",
    "import_speech",
    "import_weights",
    "key",
    "key_expression",
    "keys",
    "library_names",
    "marker",
    "move_events",
    "move_keys",
    "play_range",
    "pose_at",
    "say",
    "simplify",
    "smooth_curve",
    "sound",
    "speak",
)
"""What scripts can call."""

LATEST = 86_400.0
"""Seconds, degrees or anything; a day, beyond which files hold no time."""


def checked_numbers(*values: float) -> None:
    """See that numbers are numbers, and such as a file can hold.

    Raises
    ------
    NumberError
        If one is not.
    """
    for value in values:
        if not (math.isfinite(value) and abs(value) <= LATEST):
            raise NumberError(f"{value:g} is not possible here; choose a number up to {LATEST:g}.")


class Animating:
    """What happens over time, as a script changes it.

    Parameters
    ----------
    desk : what the script works on
    """

    def __init__(self, desk: ScriptDesk) -> None:
        self._desk = desk

    def animation(self) -> Animation:
        """All that happens over time, a frozen value."""
        return self._desk.project.animation

    def pose_at(self, time: float) -> dict[str, float]:
        """What every animated channel does at a time, seconds: weights of fields, degrees and millimetres."""
        pose = Evaluator(self.animation(), self._desk.project.units).pose(time)
        return {**pose.weights, **pose.rigid}

    def key(self, name: str, time: float, value: float, shape: Shape | None = None, spacing: float = SPACING) -> None:
        """Let a unit, field, or motion of head or eyes show a value at a time; a captured curve is bent there.

        ``shape`` says how it goes on (``step``, ``linear``, ``smooth``, ``bezier``), ``spacing`` how far a captured
        curve changes around it, in seconds between the knots.
        """
        checked_numbers(time, value, spacing)
        shown = dict.fromkeys(self._channels(name), float(value))
        units = self._desk.project.units
        self._edit(lambda clip: keyed(clip, time, shown, units, spacing, shape), f"Key {name}")

    def keys(self, name: str) -> dict[str, tuple[tuple[float, float], ...]]:
        """Times and values of the keys of every channel that a name means."""
        found = {}
        for channel in self._channels(name):
            curve = curve_of_row(self.animation(), (channel, 0))
            found[channel] = tuple(zip(curve.times.tolist(), curve.values.tolist(), strict=True))
        return found

    def move_keys(self, seconds: float, start: float, end: float, name: str = "") -> None:
        """Move the keys between two times, of one name or of all, by seconds."""
        checked_numbers(seconds)
        chosen = self._chosen(start, end, name)
        units = self._desk.project.units
        self._edit(lambda clip: bulk.moved_keys(clip, chosen, seconds, units=units)[0], "Move keys")

    def delete_keys(self, start: float, end: float, name: str = "") -> None:
        """Delete the keys between two times, of one name or of all."""
        chosen = self._chosen(start, end, name)
        self._edit(lambda clip: bulk.deleted_keys(clip, chosen), "Delete keys")

    def key_expression(
        self, time: float, shows: str | Mapping[str, float], name: str = "", strength: float = 1.0
    ) -> None:
        """Make a whole expression a key: a named one, or weights by any name."""
        checked_numbers(time, strength)
        project = self._desk.project
        weights = find_emotion(shows, project.emotions).weights if isinstance(shows, str) else shows
        shown = {field: strength * weight for each, weight in weights.items() for field in self._channels(each)}
        called = name or (shows if isinstance(shows, str) else "")
        self._edit(lambda clip: with_expression(clip, time, shown, called, project.units), f"Key expression {called}")

    def library_names(self) -> tuple[str, ...]:
        """Names of the dynamic expressions that `drop` knows, beside the named expressions of the project."""
        return tuple(each.name for each in library())

    def drop(self, name: str, time: float, strength: float = 1.0, duration: float | None = None) -> str:
        """Place a dynamic expression (an emotion, ``blink``, ``nod``, …) at a time; returns the name of its group."""
        checked_numbers(time, strength, duration or 0.0)
        project = self._desk.project
        known = {each.name: each for each in library()}
        found = known.get(name.strip().lower()) or dynamic(find_emotion(name, project.emotions), project.units)
        made, group = placed(project.animation, found, time, project.units, strength, duration)
        self._edit(lambda _: made, f"Place {found.title}")
        return group

    def move_events(self, group: str, seconds: float) -> None:
        """Move the events of a group by seconds; with none, an error."""
        chosen = [event.key for event in self.animation().events if event.group == group]
        if not chosen:
            known = ", ".join(sorted({event.group for event in self.animation().events})) or "none yet"
            raise UnknownNameError(f"There is no group of events “{group}”; there are {known}.")
        self._edit(lambda clip: moved_events(clip, chosen, seconds), f"Move {group}")

    def delete_events(self, group: str) -> None:
        """Delete the events of a group."""
        chosen = [event.key for event in self.animation().events if event.group == group]
        self._edit(lambda clip: without_events(clip, chosen), f"Delete {group}")

    def say(self, sounds: str, time: float = 0.0, length: float | None = None) -> tuple[str, ...]:
        """Speak sounds typed in ARPAbet or IPA, apart by spaces, pauses as ``|``; returns notes."""
        phonemes = laid_out(typed(sounds), time, length)
        return self._take(with_spoken(self._desk.project, phonemes), "Type speech")

    def speak(
        self, text: str, time: float = 0.0, length: float | None = None, voice: str = "en-us", sound: str = ""
    ) -> tuple[str, ...]:
        """Speak a text, where eSpeak NG is installed; returns notes.

        With the name of a WAV file for ``sound`` a voice is written into it and plays along.
        """
        begin = 0.0
        if sound:
            heard = spoken_sound(text, voice)
            write_sound(heard, Path(sound))
            begin, end = voiced_span(heard)
            length = end - begin
        phonemes, words = sounds_of_text(text, time + begin, length, voice)
        notes = self._take(with_spoken(self._desk.project, phonemes, words), "Speak")
        if sound:
            self.sound(sound, time)
        return notes

    def import_speech(self, path: str, time: float = 0.0, rate: float | None = None) -> tuple[str, ...]:
        """Phonemes from a file of Rhubarb, Papagayo, Praat or the Montreal aligner; returns notes."""
        spoken = read_speech(Path(path), rate)
        found = with_spoken(self._desk.project, spoken.phonemes, spoken.words, time)
        return self._take(Imported(found.project, (*spoken.notes, *found.notes)), "Import speech")

    def import_weights(
        self,
        path: str,
        time: float | None = None,
        rate: float | None = None,
        table: str = "",
        neutral: float | None = None,
    ) -> tuple[str, ...]:
        """A capture from a file, through the shipped table of its kind or one from a file; returns notes.

        Landmarks become weights by the fields of this face, which was at rest ``neutral`` seconds after their start.
        """
        checked_numbers(*(each for each in (time, neutral) if each is not None))
        project = self._desk.project
        capture = capture_from(Path(path), project, lambda: self._desk.solution().basis, rate, neutral)
        mapping = load_mapping(Path(table)) if table else None
        return self._take(with_capture(project, capture, mapping, time), f"Import {Path(path).name}")

    def export_weights(self, path: str, kind: str = "weights", rate: float | None = None) -> None:
        """Write all weights, frame by frame: ``weights``, ``arkit``, ``live-link`` or ``fap``."""
        project = self._desk.project
        clip = sampled(project.animation, project.units, rate)
        needs = kind in WEIGHT_EXPORTS and WEIGHT_EXPORTS[kind].needs_basis
        basis = self._desk.solution().basis if needs else None
        export_weights(Animated(clip, project.units, project.face, basis, Path(path).stem), Path(path), kind)

    def sound(self, path: str, time: float = 0.0) -> None:
        """Let a WAV file play along."""
        home = self._desk.document.path
        heard = read_sound(Path(path))
        folder = None if home is None else home.parent
        self._desk.edit(lambda project: with_sound(project, Path(path), heard, folder, time), "Sound")

    def idle(self, seed: int = 1, blinks: float = 15.0, saccades: float = 1.0, breathing: float = 1.0) -> None:
        """Let the face live by itself; with all at 0 it is still."""
        life = Idle(int(seed), float(blinks), float(saccades), float(breathing))
        still = not (blinks or saccades or breathing)
        self._edit(lambda clip: replace(clip, idle=None if still else life), "Idle life")

    def marker(self, time: float, name: str = "") -> None:
        """Mark a moment."""
        checked_numbers(time)
        self._edit(lambda clip: marks.with_marker(clip, time, name), "Marker")

    def play_range(self, start: float, end: float, loop: bool | None = None) -> None:
        """What is played and exported, seconds."""
        checked_numbers(start, end)
        self._edit(
            lambda clip: replace(marks.played(clip, start, end), loop=clip.loop if loop is None else loop), "Range"
        )

    def frame_rate(self, rate: float) -> None:
        """Frames per second, 12 to 120."""
        checked_numbers(rate)
        self._edit(lambda clip: marks.with_rate(clip, rate), "Frame rate")

    def bake(self, name: str = "", rate: float | None = None) -> None:
        """Make samples of curves, layers and keys, of one name or of all."""
        own = rate or self.animation().rate
        self._each(name, lambda track: dense.baked_to_samples(track, own), "Bake")

    def simplify(self, tolerance: float, name: str = "") -> None:
        """Make as few keys of curves as stay within a tolerance, of one name or of all."""
        self._each(name, lambda track: dense.simplified(track, tolerance), "Simplify")

    def smooth_curve(self, seconds: float, name: str = "") -> None:
        """Smooth curves by a Gaussian of so many seconds, of one name or of all."""
        self._each(name, lambda track: dense.smoothed(track, seconds), "Smooth")

    def _channels(self, name: str) -> tuple[str, ...]:
        found = fields_of(name, self._desk.project.units)
        if not found:
            raise UnknownNameError(
                f"There is nothing called “{name}” to animate; name a unit, or head.yaw and the like."
            )
        return found

    def _chosen(self, start: float, end: float, name: str) -> Mapping[tuple[str, int], tuple[int, ...]]:
        among = None if not name else [row for row in rows(self.animation()) if row[0] in self._channels(name)]
        return selected(self.animation(), start, end, among)

    def _each(self, name: str, change: Callable[[Track], Track], label: str) -> None:
        chosen: Sequence[str] = self._channels(name) if name else [track.channel for track in self.animation().tracks]
        self._edit(lambda clip: dense.each_track(clip, chosen, change), f"{label} {name}".rstrip())

    def _edit(self, change: Callable[[Animation], Animation], label: str) -> None:
        self._desk.edit(lambda project: replace(project, animation=change(project.animation)), label)

    def _take(self, found: Imported, label: str) -> tuple[str, ...]:
        self._desk.edit(lambda _: found.project, label)
        return found.notes

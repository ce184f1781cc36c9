"""What comes from files into the timeline, and what leaves it: captures, phonemes, sounds, weights, the demo."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import partial
from pathlib import Path
from typing import Any, Protocol

from app.actions.action import Action
from app.actions.context import Context, FileQuestion
from app.actions.paths import folder, with_suffix
from app.authoring.importing import with_sound, with_spoken
from app.authoring.recordings import capture_from, solved_basis
from app.jobs import Deliver, Failure, Job
from app.timeline.sounds import shortage
from app.timeline.timeline import Timeline
from facemodel.animation.capture import Capture
from facemodel.animation.evaluation import sampled
from facemodel.animation.sound import Sound
from facemodel.basis import Basis
from facemodel.errors import RisoriusError
from facemodel.io.audio import read_sound
from facemodel.io.speech.reading import READABLE as SPEECH
from facemodel.io.speech.reading import read_speech
from facemodel.io.speech.spoken import Spoken
from facemodel.io.weights import RECORDINGS
from facemodel.io.weights.writing import WEIGHT_EXPORTS, Animated, export_weights
from facemodel.project import Project
from facemodel.solve import Progress

Deed = Callable[[Context], None]

IMPORT = ("File", "Import")

SOUND = (".wav", ".wave")
"""Suffixes of sounds."""


Again = Callable[[float, Callable[[Capture], None]], None]
"""Reads a capture again, for a face that was at rest at another moment (seconds), and gives it away."""


class Asks(Protocol):
    """What exchange asks of the window."""

    def map_capture(self, capture: Capture, path: Path, again: Again) -> None:
        """Show how the channels of a capture become those of the face, and take it in when that is settled."""

    def type_speech(self) -> None:
        """Let words or sounds be typed."""

    def edit_visemes(self) -> None:
        """Let it be changed what sounds look like."""


@dataclass(frozen=True, eq=False)
class Errand:
    """Something to do with a file away from the window.

    Attributes
    ----------
    what : for people, such as ``Reading take.csv``
    work : does it
    then : is given what came of it, in the thread of the document
    """

    what: str
    work: Callable[[Progress], Any]
    then: Callable[[Any], None]


class Exchange:
    """Reads and writes files of a timeline in the background.

    Parameters
    ----------
    timeline : what is worked on
    context : services of the window
    asks : its dialogs
    deliver : brings what was read to the thread of the document; without it is waited for
    """

    def __init__(self, timeline: Timeline, context: Context, asks: Asks, deliver: Deliver | None = None) -> None:
        self._timeline, self._context, self.asks = timeline, context, asks
        self.job: Job[Errand, Any] = Job(_do, deliver)
        self.job.started.connect(lambda errand: context.host.show_message(f"{errand.what} …"))
        self.job.finished.connect(lambda found, errand: errand.then(found))
        self.job.failed.connect(self._fail)

    @property
    def openers(self) -> Mapping[str, Callable[[Path], None]]:
        """What reads files without asking for one, by their endings."""
        return {
            **dict.fromkeys(SPEECH, self.read_speech),
            **dict.fromkeys(RECORDINGS, self.read_capture),
            **dict.fromkeys(SOUND, self.read_sound),
        }

    def import_capture(self) -> None:
        """Ask for a file with weights or landmarks over time, read it, and show how it becomes weights of this face."""
        path = self._asked("Import weights over time", "Weights over time", RECORDINGS)
        if path is not None:
            self.read_capture(path)

    def read_capture(self, path: Path) -> None:
        """Read a file with weights or landmarks over time, and show how it becomes weights of this face."""
        self._read(path, None, lambda capture: self.asks.map_capture(capture, path, partial(self._read, path)))

    def import_speech(self) -> None:
        """Ask for a file with phonemes, and say them from the playhead on."""
        path = self._asked("Import phonemes", "Phonemes over time", SPEECH)
        if path is not None:
            self.read_speech(path)

    def read_speech(self, path: Path) -> None:
        """Read a file with phonemes, and say them from the playhead on."""
        rate = self._timeline.rate
        self._begin(f"Reading {path.name}", lambda _: read_speech(path, rate), self._say)

    def import_sound(self) -> None:
        """Ask for a sound that plays along."""
        path = self._asked("Import sound", "WAV sound", SOUND)
        if path is not None:
            self.read_sound(path)

    def read_sound(self, path: Path) -> None:
        """Let a sound play along."""
        self._begin(f"Reading {path.name}", lambda _: read_sound(path), lambda sound: self._play_along(path, sound))

    def export(self, kind: str) -> None:
        """Ask for a file and write weights over time into it."""
        export, document = WEIGHT_EXPORTS[kind], self._timeline.document
        name = document.path.stem if document.path else document.project.face.key
        start = folder(self._context) / f"{name}{export.suffix}"
        question = FileQuestion(f"Export {export.title}", export.title, export.suffix, start, writes=True)
        path = self._context.host.ask_path(question)
        if path is None:
            return
        document.commit()
        project, basis = document.project, self._basis()
        target = with_suffix(path, export.suffix)

        def write(_: Progress) -> Path:
            clip = sampled(project.animation, project.units)
            export_weights(Animated(clip, project.units, project.face, basis, target.stem), target, kind)
            return target

        self._begin(f"Writing {target.name}", write, self._written)

    def close(self) -> None:
        """Read and write no more."""
        self.job.close()

    def _asked(self, title: str, kind: str, suffixes: tuple[str, ...]) -> Path | None:
        start = folder(self._context)
        return self._context.host.ask_path(FileQuestion(title, kind, suffixes[0], start, False, suffixes[1:]))

    def _basis(self) -> Basis | None:
        """The fields of the face as it is now; none while it is not solved."""
        document = self._timeline.document
        return None if document.solution is None or document.stale else document.solution.basis

    def _read(self, path: Path, rest: float | None, then: Callable[[Capture], None]) -> None:
        project, standing = self._timeline.document.project, self._basis()

        def read(progress: Progress) -> Capture:
            basis = partial(_fields, standing, project, progress)
            return capture_from(path, project, basis, neutral=rest, progress=progress)

        self._begin(f"Reading {path.name}", read, then)

    def _begin(self, what: str, work: Callable[[Progress], Any], then: Callable[[Any], None]) -> None:
        self.job.request(Errand(what, work, then))

    def _say(self, spoken: Spoken) -> None:
        document = self._timeline.document
        found = with_spoken(document.project, spoken.phonemes, spoken.words, self._timeline.playhead.time)
        document.edit(found.project, "Import phonemes")
        self._note((*spoken.notes, *found.notes), f"{len(spoken.phonemes)} sounds are said from here on.")

    def _play_along(self, path: Path, sound: Sound) -> None:
        document = self._timeline.document
        home = None if document.path is None else document.path.parent
        document.edit(with_sound(document.project, path, sound, home, self._timeline.playhead.time), "Import sound")
        self._note((), shortage(path.name, sound) or f"{path.name} plays along from here on.")

    def _written(self, path: Path) -> None:
        self._context.host.show_message(f"Exported {path.name}")

    def _note(self, notes: tuple[str, ...], otherwise: str) -> None:
        self._context.host.show_message(" ".join(notes) or otherwise)

    def _fail(self, failure: Failure) -> None:
        self._context.host.show_error(failure.sentence)


def _fields(standing: Basis | None, project: Project, progress: Progress) -> Basis:
    """The fields that stand, or those of the project solved."""
    return standing or solved_basis(project, progress)


def _do(errand: Errand, progress: Progress) -> Any:
    progress(errand.what, 0.0)
    try:
        return errand.work(progress)
    except RecursionError as error:
        raise RisoriusError("The file is nested too deeply to be read.") from error


def exchange_actions(exchange: Callable[[], Exchange], timeline: Timeline) -> tuple[Action, ...]:
    """The actions of exchange, which is asked for when one is done."""
    return (*_importing(exchange), *_exporting(exchange, timeline), *_asking(exchange))


def _importing(exchange: Callable[[], Exchange]) -> tuple[Action, ...]:
    entries: tuple[tuple[str, str, str, Deed], ...] = (
        ("timeline.import", "Weights over time…", "OpenFace, Live Link Face, ARKit, MediaPipe, MPEG-4 or plain tables",
         lambda _: exchange().import_capture()),
        ("timeline.import-speech", "Phonemes…", "Rhubarb, Papagayo, Praat or the Montreal Forced Aligner, from here on",
         lambda _: exchange().import_speech()),
        ("timeline.import-sound", "Sound…", "A WAV file that plays along from the playhead on",
         lambda _: exchange().import_sound()),
    )  # fmt: skip
    return tuple(Action(key, title, run, menu=IMPORT, group=2, hint=hint) for key, title, hint, run in entries)


def _exporting(exchange: Callable[[], Exchange], timeline: Timeline) -> tuple[Action, ...]:
    def moves(_context: Context) -> bool:
        return timeline.animation.moves

    def export(kind: str) -> Deed:
        return lambda _context: exchange().export(kind)

    # The page of File > Export offers them among all that an animation can become; here they are for the palette.
    return tuple(
        Action(
            f"timeline.export.{kind}",
            f"Export {table.title} over time ({table.suffix})…",
            export(kind),
            hint=f"Write {table.holds}",
            enabled=moves,
        )
        for kind, table in WEIGHT_EXPORTS.items()
    )


def _asking(exchange: Callable[[], Exchange]) -> tuple[Action, ...]:
    return (
        Action(
            "timeline.type-speech",
            "Type speech…",
            lambda _context: exchange().asks.type_speech(),
            menu=("Animation", "Add"),
            group=5,
            hint="Words or sounds that are said from the playhead on",
        ),
        Action(
            "timeline.visemes",
            "Visemes…",
            lambda _context: exchange().asks.edit_visemes(),
            menu=("Animation",),
            group=5,
            hint="Change what the sounds of speech look like",
        ),
    )

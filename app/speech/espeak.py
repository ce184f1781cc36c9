"""eSpeak NG, where it is installed: the sounds of a text, and a voice that says it."""

from __future__ import annotations

import re
import shutil
import subprocess
import tempfile
from collections.abc import Sequence
from pathlib import Path

from facemodel.animation.editing.speech import PAUSE, laid_out
from facemodel.animation.sound import Sound
from facemodel.animation.speech import Phoneme, Word
from facemodel.errors import RisoriusError
from facemodel.io.audio import read_sound

PROGRAMS = ("espeak-ng", "espeak")
VOICE = re.compile(r"[A-Za-z0-9+_-]{1,40}")
PATIENCE = 30.0
"""Seconds; a page of text takes a tenth of one."""

LONGEST_TEXT = 20_000
"""Characters; twenty minutes of speech."""

INSTALL = "install eSpeak NG (espeak-ng), type the sounds, or import them from an aligner"


class SpeechError(RisoriusError):
    """A text cannot be turned into sounds."""


def espeak_program() -> str | None:
    """Where the program is; none if it is not installed."""
    return next((found for name in PROGRAMS if (found := shutil.which(name))), None)


def sounds_of_text(
    text: str, start: float = 0.0, length: float | None = None, voice: str = "en-us"
) -> tuple[tuple[Phoneme, ...], tuple[Word, ...]]:
    """The sounds of a text and its words, each sound as long as its kind usually takes.

    Parameters
    ----------
    text : what is said
    start : of the first sound, seconds
    length : of all together, if a recording says how long it is
    voice : of eSpeak NG, which decides the language

    Raises
    ------
    SpeechError
        If eSpeak NG is not installed, does not know the voice, or finds nothing to say.
    """
    ipa = _run(text, voice, ["-q", "--ipa", "--sep=_"]).decode("utf-8", "replace")
    words = _words(ipa)
    if not words:
        raise SpeechError(f"There is nothing to say in “{text.strip()[:40]}”; type some words.")
    sounds = laid_out(words, start, length)
    return sounds, _spoken_words(words, sounds, _written(text))


def spoken_sound(text: str, voice: str = "en-us") -> Sound:
    """A voice that says a text; to be recorded over.

    Raises
    ------
    SpeechError
        As `sounds_of_text`.
    """
    with tempfile.TemporaryDirectory() as folder:
        path = Path(folder) / "spoken.wav"
        _run(text, voice, ["-w", str(path)])
        if not path.exists():
            raise SpeechError(f"There is nothing to say in “{text.strip()[:40]}”; type some words.")
        return read_sound(path)


def _run(text: str, voice: str, options: Sequence[str]) -> bytes:
    """What the program prints; the text goes in by its input, so that no text is ever taken for an option."""
    program = espeak_program()
    if program is None:
        raise SpeechError(f"The sounds of a text are not known here; {INSTALL}.")
    if not VOICE.fullmatch(voice):
        raise SpeechError(f"“{voice[:40]}” cannot be a voice of eSpeak NG; choose one such as en-us or en-gb.")
    if len(text) > LONGEST_TEXT:
        raise SpeechError(f"The text has {len(text):,} characters; say at most {LONGEST_TEXT:,} at once.")
    command = [program, "-v", voice, *options, "--stdin"]
    try:
        done = subprocess.run(command, input=text.encode(), capture_output=True, timeout=PATIENCE, check=False)
    except subprocess.TimeoutExpired as error:
        raise SpeechError(f"eSpeak NG did not answer within {PATIENCE:g} seconds; try a shorter text.") from error
    except OSError as error:
        raise SpeechError(f"eSpeak NG cannot be started ({error.strerror}); {INSTALL}.") from error
    if done.returncode:
        said = done.stderr.decode("utf-8", "replace").strip().splitlines()
        raise SpeechError(f"eSpeak NG refused the text: {said[-1] if said else 'it did not say why'}.")
    return done.stdout


def _words(ipa: str) -> list[tuple[str, ...]]:
    """Sounds word by word; a line is a clause, behind which there is a pause."""
    words: list[tuple[str, ...]] = []
    for line in filter(None, map(str.strip, ipa.splitlines())):
        spoken = [tuple(filter(None, word.split("_"))) for word in line.split()]
        words += [word for word in spoken if word]
        words.append((PAUSE,))
    return words[:-1]


def _written(text: str) -> list[str]:
    return re.findall(r"[\w'’]+", text)


def _spoken_words(
    words: Sequence[Sequence[str]], sounds: Sequence[Phoneme], written: Sequence[str]
) -> tuple[Word, ...]:
    """Words over their sounds, as they are written if there are as many, else none: eSpeak joins some."""
    spans: list[tuple[float, float]] = []
    at = 0
    for word in words:
        if word != (PAUSE,):
            spans.append((sounds[at].start, sounds[at + len(word) - 1].end))
        at += len(word)
    if len(spans) != len(written):
        return ()
    return tuple(Word(text, start, end) for text, (start, end) in zip(written, spans, strict=True))

"""Sounds from WAV files."""

from __future__ import annotations

import struct
import warnings
from collections.abc import Callable
from io import BytesIO
from pathlib import Path
from typing import Any

import numpy as np
from numpy.typing import NDArray
from scipy.io import wavfile

from facemodel.animation.sound import Sound
from facemodel.errors import ProjectError
from facemodel.io.damage import DamageError, naming
from facemodel.io.disk import read_file, replacing

LARGEST_FILE = 1 << 30
"""Bytes; an hour and a half of stereo."""

SLOWEST, FASTEST = 4000, 384_000
"""Samples per second of recordings of voices."""

MOST_CHANNELS = 32

FORMAT = 14
"""Bytes at the beginning of the format of a WAV file that say how it is sampled."""

AS_WAV = "save it as a WAV file of 16-bit PCM"

SCALES: dict[str, tuple[float, float]] = {"u1": (128.0, 128.0), "i2": (0.0, 2.0**15), "i4": (0.0, 2.0**31)}
"""By type of sample: what silence is, and what full is above it."""

BROKEN = (ValueError, TypeError, EOFError, LookupError, ArithmeticError, NameError, MemoryError, struct.error)
"""What the reader raises for files that are no whole WAV."""


UNKNOWN = (0, 0xFFFF_FFFF)
"""Bytes of sound that a file says it holds whose writer did not know yet, and which goes on to its end."""


def read_sound(path: Path) -> Sound:
    """A sound from a WAV file of integers or floats; of one that is cut short, what is there.

    Raises
    ------
    ProjectError
        If there is no such file, it is no WAV, broken, or of a rate or number of channels that no recording has.
    """
    if path.suffix.lower() not in (".wav", ".wave"):
        raise ProjectError(f"“{path}” cannot be read as sound: only WAV files are; {AS_WAV}.")
    data = read_file(path, LARGEST_FILE)
    with naming(path, "read"):
        return sound_of(data)


def sound_of(data: bytes) -> Sound:
    """The sound in the bytes of a WAV file.

    Raises
    ------
    DamageError
        If they are something else.
    """
    if data[:4] not in (b"RIFF", b"RIFX", b"RF64") or data[8:12] != b"WAVE":
        raise DamageError("the file", "is no WAV file", AS_WAV)
    whole_frames, missing = _cut_short(data)
    rate, samples = _read(whole_frames)
    if not len(samples):
        raise DamageError("the file", "holds no sound", "record again")
    if not SLOWEST <= rate <= FASTEST:
        raise DamageError("the file", f"says {rate:,} samples a second, which no recording has", AS_WAV)
    kind = samples.dtype.str.lstrip("<>|=")
    if kind.startswith("f"):
        whole = np.clip(np.nan_to_num(samples.astype(np.float32)), -1.0, 1.0)
    elif kind in SCALES:
        silent, full = SCALES[kind]
        whole = ((samples.astype(np.float64) - silent) / full).astype(np.float32)
    else:
        raise DamageError("the file", f"holds samples of the type {samples.dtype}", AS_WAV)
    shaped = whole.reshape(len(whole), -1)
    if shaped.shape[1] > MOST_CHANNELS:
        raise DamageError("the file", f"has {shaped.shape[1]} channels and at most {MOST_CHANNELS} are read", AS_WAV)
    return Sound(shaped, int(rate), missing)


def _cut_short(data: bytes) -> tuple[bytes, float]:
    """The file without a last frame that is not whole, and how many seconds it lacks of what it says it holds."""
    order, at, frame, per_second = ">" if data[:4] == b"RIFX" else "<", 12, 1, 0
    while at + 8 <= len(data):
        name, size = struct.unpack_from(f"{order}4sI", data, at)
        at += 8
        there = len(data) - at
        if name == b"fmt " and there >= FORMAT:
            per_second, frame = struct.unpack_from(f"{order}IH", data, at + 8)
        if name == b"data" and size > there and size not in UNKNOWN and frame and per_second:
            return data[: at + there - there % frame], (size - there) / per_second
        at += size + size % 2
    return data, 0.0


def _read(data: bytes) -> tuple[int, NDArray[Any]]:
    read: Callable[..., tuple[int, NDArray[Any]]] = wavfile.read
    with warnings.catch_warnings():
        warnings.simplefilter("ignore", wavfile.WavFileWarning)
        try:
            return read(BytesIO(data))
        except BROKEN as error:
            raise DamageError("the file", "is cut short or no WAV file that can be read", AS_WAV) from error


def write_sound(sound: Sound, path: Path) -> None:
    """Write a sound as a WAV file of 16-bit PCM.

    Raises
    ------
    ProjectError
        If it cannot be written; a previous file stays.
    """
    stream = BytesIO()
    wavfile.write(stream, sound.rate, np.rint(np.clip(sound.samples, -1, 1) * 32767).astype(np.int16))
    with replacing(path) as out:
        out.write(stream.getvalue())

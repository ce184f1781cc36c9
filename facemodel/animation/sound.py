"""A sound, and the outline in which it is drawn."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from scipy.signal import resample_poly

from fem.types import Float32Array

FINEST = 64
"""Samples under one pair of peaks in the finest level; below that the samples themselves are drawn."""

AUDIBLE = 0.03
"""Of the loudest sample: below it a recording is taken as silent; 30 dB under a voice lies the noise of a room."""


@dataclass(frozen=True, eq=False)
class Sound:
    """Samples of a recording.

    Attributes
    ----------
    samples : (N, channels) float32, -1 to 1
    rate : samples per second
    missing : seconds that should follow and that its file, which is cut short, does not hold
    """

    samples: Float32Array
    rate: int
    missing: float = 0.0

    @property
    def duration(self) -> float:
        """Seconds."""
        return len(self.samples) / self.rate


@dataclass(frozen=True, eq=False)
class Waveform:
    """The lowest and highest sample of ever longer stretches of a sound, so that any view of it is quickly drawn.

    Attributes
    ----------
    rate : samples per second
    samples : (N,) float32, all channels in one
    levels : (n, 2) lowest and highest of every `FINEST` samples, then of twice as many, and so on
    """

    rate: int
    samples: Float32Array
    levels: tuple[Float32Array, ...]

    @property
    def duration(self) -> float:
        """Seconds."""
        return len(self.samples) / self.rate

    def peaks(self, start: float, end: float, columns: int) -> Float32Array:
        """The lowest and highest sample (columns, 2) of even stretches from one time to another, seconds.

        Where there is no sound it is silent.
        """
        found = np.zeros((columns, 2), dtype=np.float32)
        if columns <= 0 or end <= start or not len(self.samples):
            return found
        bounds = (np.linspace(start, end, columns + 1) * self.rate).astype(np.int64)
        width = max(int(bounds[1] - bounds[0]), 1)
        level = int(np.floor(np.log2(max(width / FINEST, 0.5))))
        if level < 0 or not self.levels:
            lows = highs = self.samples
            step = 1
        else:
            chosen = self.levels[min(level, len(self.levels) - 1)]
            lows, highs = chosen[:, 0], chosen[:, 1]
            step = FINEST << min(level, len(self.levels) - 1)
        first, last = bounds[:-1] // step, np.maximum(-(-bounds[1:] // step), bounds[:-1] // step + 1)
        inside = (last > 0) & (first < len(lows))
        first, last = np.clip(first, 0, len(lows) - 1), np.clip(last, 1, len(lows))
        for column in np.flatnonzero(inside).tolist():
            part = slice(int(first[column]), int(last[column]))
            found[column] = lows[part].min(), highs[part].max()
        return found


def waveform(sound: Sound) -> Waveform:
    """The outline of a sound; its levels together hold a thirtieth of its samples."""
    mono = sound.samples.mean(axis=1, dtype=np.float32) if len(sound.samples) else np.zeros(0, np.float32)
    levels: list[Float32Array] = []
    lows = highs = mono
    step = FINEST
    while len(lows) > 1:
        lows, highs = _halved(lows, step, np.minimum), _halved(highs, step, np.maximum)
        levels.append(np.stack([lows, highs], axis=1))
        step = 2
    return Waveform(sound.rate, mono, tuple(levels))


def _halved(values: Float32Array, step: int, which: np.ufunc) -> Float32Array:
    """The least or greatest of every so many values; the last stretch may be shorter."""
    return np.asarray(which.reduceat(values, np.arange(0, len(values), step)))


def voiced_span(sound: Sound) -> tuple[float, float]:
    """From when to when somebody speaks, seconds; all of it if it is silent throughout."""
    loud = np.abs(sound.samples).max(axis=1, initial=0.0)
    heard = np.flatnonzero(loud > AUDIBLE * loud.max(initial=0.0))
    if not len(heard):
        return 0.0, sound.duration
    return float(heard[0]) / sound.rate, float(heard[-1] + 1) / sound.rate


def stretch(sound: Sound, start: float, duration: float) -> Sound:
    """What is heard from a time on for a duration, seconds; silence before the begin of a sound and behind its end."""
    first, count = round(start * sound.rate), round(duration * sound.rate)
    heard = np.zeros((count, sound.samples.shape[1]), dtype=np.float32)
    low, high = max(first, 0), min(first + count, len(sound.samples))
    if low < high:
        heard[low - first : high - first] = sound.samples[low:high]
    return Sound(heard, sound.rate)


def resampled(sound: Sound, rate: int) -> Sound:
    """The same sound with another number of samples per second."""
    if rate == sound.rate or not len(sound.samples):
        return Sound(sound.samples, rate)
    common = int(np.gcd(rate, sound.rate))
    made = resample_poly(sound.samples, rate // common, sound.rate // common, axis=0)
    return Sound(np.clip(made, -1.0, 1.0).astype(np.float32), rate)

"""The loudspeaker: the one place that knows the library by which it is reached."""

from __future__ import annotations

from collections.abc import Callable, Generator
from typing import Protocol

from facemodel.errors import RisoriusError
from fem.types import Float32Array

BUFFER, BUFFERS = 50, 3
"""Milliseconds that are handed to the loudspeaker at once, and how many such pieces wait: a picture may take as long as
two of them before there is a gap in the sound."""

Fill = Callable[[int], Float32Array]
"""Gives the next samples (count, channels)."""


class AudioError(RisoriusError):
    """No sound can be played."""


class Speaker(Protocol):
    """A loudspeaker that plays.

    Attributes
    ----------
    waiting : samples that were handed over and are not heard yet, just after it has asked for some
    """

    waiting: int

    def close(self) -> None:
        """Be silent for good."""


Open = Callable[[int, int, Fill], Speaker]
"""Begins to play, at so many samples a second, through so many channels, what a function gives."""


class _Speaker:
    def __init__(self, rate: int, channels: int, fill: Fill, backends: list[object] | None) -> None:
        import miniaudio

        self.waiting = rate * BUFFER * BUFFERS // 1000
        self._device = miniaudio.PlaybackDevice(
            output_format=miniaudio.SampleFormat.FLOAT32,
            nchannels=channels,
            sample_rate=rate,
            buffersize_msec=BUFFER,
            callback_periods=BUFFERS,
            backends=backends,
            app_name="Risorius",
        )
        samples = _samples(fill)
        next(samples)
        self._device.start(samples)

    def close(self) -> None:
        """Be silent for good."""
        self._device.close()


def _samples(fill: Fill) -> Generator[Float32Array, int, None]:
    """What the library asks for, buffer by buffer."""
    count = yield fill(0)
    while True:
        count = yield fill(count)


def open_speaker(rate: int, channels: int, fill: Fill, backends: list[object] | None = None) -> Speaker:
    """Begin to play.

    Parameters
    ----------
    rate : samples per second; the system takes care of what the hardware wants
    channels : one or two
    fill : gives samples; it is called in a thread of the library's own
    backends : of the library; those that it finds if not given

    Raises
    ------
    AudioError
        If the library is not installed, or there is no loudspeaker.
    """
    try:
        import miniaudio
    except ImportError as error:
        raise AudioError(
            "The sound is not heard, because the package “miniaudio” is missing; pip install 'risorius[audio]' adds it."
        ) from error
    try:
        return _Speaker(rate, channels, fill, backends)
    except miniaudio.MiniaudioError as error:
        raise AudioError("The sound is not heard, because this computer says it has no loudspeaker.") from error

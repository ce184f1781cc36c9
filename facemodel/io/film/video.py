"""Videos, encoded by FFmpeg's libraries by way of PyAV, which is loaded when the first one is made."""

from __future__ import annotations

import errno
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass, field
from fractions import Fraction
from pathlib import Path
from typing import TYPE_CHECKING, cast

import numpy as np

from facemodel.animation.sound import Sound
from facemodel.errors import ProjectError
from facemodel.io.film.reel import Picture, Reel

if TYPE_CHECKING:
    from av import AudioFrame
    from av.audio.stream import AudioStream
    from av.container import OutputContainer
    from av.video.stream import VideoStream

BT709 = 1
"""Code of the colours of high definition in all of FFmpeg's tables; players assume them for videos of this size."""

SOUND_RATE = 48_000
"""Samples per second; Opus knows no other, and every player has it."""

TELEVISION = Fraction(1000, 1001)
"""The rates of colour television over the whole numbers that they are near to: 29.97 means 30000/1001."""

NEAR_RATE = 0.005
"""Frames per second within which a rate is one of television."""

FINEST_FRACTION = 1000
"""Largest denominator of any other rate."""


@dataclass(frozen=True)
class Codecs:
    """How a video is encoded.

    Attributes
    ----------
    container : name of the file format
    picture, sound : names of the encoders
    options : of the picture's encoder; the quality is such that skin shows no blocks
    layout : options of the file format
    """

    container: str
    picture: str
    sound: str
    options: Mapping[str, str]
    layout: Mapping[str, str] = field(default_factory=dict)


MP4 = Codecs("mp4", "libx264", "aac", {"crf": "17", "preset": "medium", "profile": "high"}, {"movflags": "+faststart"})
WEBM = Codecs(
    "webm", "libvpx-vp9", "libopus", {"crf": "24", "b": "0", "deadline": "good", "cpu-used": "4", "row-mt": "1"}
)


@contextmanager
def video(fresh: Path, path: Path, reel: Reel, codecs: Codecs) -> Iterator[VideoWriter]:
    """Writes a video; it is whole when the context ends without an error.

    Parameters
    ----------
    fresh : the file to write
    path : what the file will be called, for errors
    reel, codecs : what it is made of, and how

    Raises
    ------
    ProjectError
        If PyAV is not installed, or cannot encode this.
    OSError
        If the file cannot be written.
    """
    try:
        import av
    except ImportError as error:
        raise ProjectError(
            f"“{path}” cannot be filmed: the library that encodes videos is missing ({error}); install it with "
            "“pip install av”, or let the name end in .png for numbered pictures."
        ) from error
    if any(side % 2 for side in reel.size):
        width, height = (side + side % 2 for side in reel.size)
        raise ProjectError(f"“{path}” cannot be filmed: videos have even sides; choose {width}x{height}.")
    try:
        with av.open(str(fresh), "w", format=codecs.container, container_options=dict(codecs.layout)) as container:
            writer = VideoWriter(container, reel, codecs)
            yield writer
            writer.finish()
    except av.FFmpegError as error:
        if isinstance(error, OSError) or error.errno in errno.errorcode:
            raise OSError(error.errno, error.strerror) from error
        raise ProjectError(
            f"“{path}” cannot be filmed: the encoder says “{error}”; choose another size or format."
        ) from error


def exact_rate(rate: float) -> Fraction:
    """Frames per second as a fraction, which is what video files hold."""
    television = round(rate / TELEVISION) * TELEVISION
    if rate != round(rate) and abs(rate - television) < NEAR_RATE:
        return television
    return Fraction(rate).limit_denominator(FINEST_FRACTION)


class VideoWriter:
    """Encodes pictures, and the sound that belongs to them."""

    def __init__(self, container: OutputContainer, reel: Reel, codecs: Codecs) -> None:
        self._container = container
        self._rate = exact_rate(reel.rate)
        self._count = 0
        if reel.title:
            container.metadata["title"] = reel.title
        made = container.add_stream(codecs.picture, rate=self._rate, options=dict(codecs.options))
        self._pictures = cast("VideoStream", made)
        self._pictures.width, self._pictures.height = reel.size
        self._pictures.pix_fmt = "yuv420p"
        context = self._pictures.codec_context
        context.color_primaries = context.color_trc = context.colorspace = BT709
        context.time_base = 1 / self._rate
        self._track = None if reel.sound is None else SoundTrack(container, reel.sound, codecs.sound)

    def add(self, picture: Picture) -> None:
        """Take the next picture, with the sound up to its end."""
        import av

        frame = av.VideoFrame.from_ndarray(np.ascontiguousarray(picture), format="rgb24")
        frame = frame.reformat(format="yuv420p", dst_colorspace="ITU709", dst_color_range="MPEG")
        frame.pts, frame.time_base = self._count, 1 / self._rate
        self._container.mux(self._pictures.encode(frame))
        self._count += 1
        if self._track is not None:
            self._track.until(float(self._count / self._rate))

    def finish(self) -> None:
        """Encode what is still waiting."""
        self._container.mux(self._pictures.encode(None))
        if self._track is not None:
            self._track.finish()


class SoundTrack:
    """Encodes sound in step with the pictures, so that a player finds both side by side in the file."""

    def __init__(self, container: OutputContainer, sound: Sound, codec: str) -> None:
        import av

        self._container = container
        self._sound = sound
        self._done = 0
        self._layout = "mono" if sound.samples.shape[1] == 1 else "stereo"
        self._stream = cast("AudioStream", container.add_stream(codec, rate=SOUND_RATE, layout=self._layout))
        self._resampler = av.AudioResampler(self._stream.format, self._layout, SOUND_RATE)

    def until(self, time: float) -> None:
        """Encode up to a time, seconds."""
        import av

        end = min(round(time * self._sound.rate), len(self._sound.samples))
        if end <= self._done:
            return
        part = np.ascontiguousarray(self._sound.samples[self._done : end, :2].T)
        frame = av.AudioFrame.from_ndarray(part, format="fltp", layout=self._layout)
        frame.sample_rate, frame.pts, frame.time_base = self._sound.rate, self._done, Fraction(1, self._sound.rate)
        self._done = end
        self._encode(self._resampler.resample(frame))

    def finish(self) -> None:
        """Encode what is still waiting."""
        self._encode(self._resampler.resample(None))
        self._container.mux(self._stream.encode(None))

    def _encode(self, frames: list[AudioFrame]) -> None:
        for frame in frames:
            self._container.mux(self._stream.encode(frame))

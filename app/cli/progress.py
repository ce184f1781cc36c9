"""Progress on a terminal: a bar on one line, or plain lines where the output is kept in a file."""

from __future__ import annotations

import shutil
import time
from typing import TextIO

WIDTH = 24
"""Characters of the bar."""
FRAME = 0.05
"""Seconds between two drawings of the bar."""


class ProgressLine:
    """Shows what `facemodel.solve.Progress` is told.

    Parameters
    ----------
    stream : where to; a bar that redraws itself if it is a terminal, else one line for each phase
    """

    def __init__(self, stream: TextIO) -> None:
        self._stream = stream
        self._bar = stream.isatty()
        self._phase = ""
        self._drawn_at = 0.0
        self._drawn = False

    def __call__(self, text: str, share: float) -> None:
        """Show the text and the share that is done."""
        if self._bar:
            self._draw(text, share)
        elif (phase := text.split(",")[0]) != self._phase:
            self._phase = phase
            print(phase, file=self._stream, flush=True)

    def clear(self) -> None:
        """Take the bar away, so that something else can be said on its line."""
        if self._drawn:
            print("\r\x1b[K", end="", file=self._stream, flush=True)
            self._drawn = False

    def _draw(self, text: str, share: float) -> None:
        now = time.monotonic()
        if share < 1 and now - self._drawn_at < FRAME:
            return
        self._drawn_at, self._drawn = now, True
        full = round(WIDTH * min(max(share, 0.0), 1.0))
        bar = "█" * full + "░" * (WIDTH - full)
        if not _writes(self._stream, bar):
            bar = "#" * full + "." * (WIDTH - full)
        line = f"{bar} {share:4.0%}  {text}"
        columns = shutil.get_terminal_size().columns
        print(f"\r{line[: columns - 1]}\x1b[K", end="", file=self._stream, flush=True)


def _writes(stream: TextIO, text: str) -> bool:
    try:
        text.encode(stream.encoding or "ascii")
    except UnicodeEncodeError:
        return False
    return True

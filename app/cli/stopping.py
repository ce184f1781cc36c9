"""Ctrl+C as a request: what is under way ends at its next step and keeps what it has."""

from __future__ import annotations

import signal
from collections.abc import Callable
from types import FrameType, TracebackType
from typing import Any

from facemodel.solution import Cancelled, Progress


class Stopping:
    """Progress that raises `Cancelled` once when Ctrl+C was pressed; pressed again before that it ends all at once.

    Parameters
    ----------
    progress : what is told of everything first
    """

    def __init__(self, progress: Progress) -> None:
        self._progress = progress
        self._asked = False
        self._before: Callable[[int, FrameType | None], Any] | int | None = None

    def __enter__(self) -> Progress:
        self._before = signal.signal(signal.SIGINT, self._pressed)
        return self._told

    def __exit__(
        self, kind: type[BaseException] | None, error: BaseException | None, trace: TracebackType | None
    ) -> None:
        signal.signal(signal.SIGINT, self._before)

    def _pressed(self, _number: int, _frame: FrameType | None) -> None:
        if self._asked:
            raise KeyboardInterrupt
        self._asked = True

    def _told(self, text: str, share: float) -> None:
        self._progress(text, share)
        if self._asked:
            self._asked = False
            raise Cancelled

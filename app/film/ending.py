"""Work that is told to end removes what it has half written."""

from __future__ import annotations

import signal
from collections.abc import Iterator
from contextlib import contextmanager


@contextmanager
def told_to_end() -> Iterator[None]:
    """Take the signal with which systems end programs as Ctrl+C, so that the work is unwound and not cut off.

    Only the main thread may ask for this.

    Raises
    ------
    KeyboardInterrupt
        Where the work is, when the signal comes.
    """
    before = signal.signal(signal.SIGTERM, signal.default_int_handler)
    try:
        yield
    finally:
        signal.signal(signal.SIGTERM, before)

"""A file that is locked for as long as a process lives, however it ends."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import BinaryIO


class SessionLock:
    """Holds the lock on a file.

    Parameters
    ----------
    path : the file; made if there is none

    Raises
    ------
    BlockingIOError
        If another process, or this one, holds it already.
    OSError
        If the file cannot be made.
    """

    def __init__(self, path: Path) -> None:
        self.path = path
        self._stream = open(path, "ab")  # noqa: SIM115 - open for as long as the lock is held
        try:
            _lock(self._stream)
        except OSError as error:
            self._stream.close()
            raise BlockingIOError(str(error)) from error

    def release(self, *, remove: bool = True) -> None:
        """Let the lock go, and remove the file."""
        self._stream.close()
        if remove:
            self.path.unlink(missing_ok=True)


def is_locked(path: Path) -> bool:
    """Whether a living process holds the lock on a file."""
    if not path.exists():
        return False
    try:
        SessionLock(path).release(remove=False)
    except BlockingIOError:
        return True
    return False


if sys.platform == "win32":
    import msvcrt

    def _lock(stream: BinaryIO) -> None:
        stream.seek(0)
        msvcrt.locking(stream.fileno(), msvcrt.LK_NBLCK, 1)

else:
    import fcntl

    def _lock(stream: BinaryIO) -> None:
        fcntl.flock(stream, fcntl.LOCK_EX | fcntl.LOCK_NB)

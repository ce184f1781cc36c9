"""What is wrong with a file, said in one sentence that names the file, the place and the remedy."""

from __future__ import annotations

import errno
from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from pathlib import Path

from facemodel.errors import ProjectError

RESTORE = "open a backup or an earlier copy instead"
TAKE_BACK = "take the last change back and save again"

REMEDIES: Mapping[int, str] = {
    errno.ENOSPC: "the disk is full; free some space or choose another disk",
    errno.EDQUOT: "your disk quota is used up; free some space or choose another disk",
    errno.EFBIG: "the file would be larger than this system allows; choose another disk or raise the limit",
    errno.EACCES: "permission is denied; change the permissions or choose another folder",
    errno.EPERM: "permission is denied; change the permissions or choose another folder",
    errno.EROFS: "the disk is read-only; choose another disk",
    errno.ENOENT: "there is no such file or folder; check the spelling",
    errno.ENOTDIR: "a part of its path is a file, not a folder; check the spelling",
    errno.ENAMETOOLONG: "the name is too long; choose a shorter one",
    errno.ELOOP: "its links lead round in a circle; choose another place",
    errno.EIO: "the disk reports an error; choose another disk",
}
"""What to say for each error of the operating system that a user can do something about."""


class DamageError(Exception):
    """A member of a file is not what it should be; raised by readers that do not know the file's path.

    Parameters
    ----------
    where : the member and the place in it, for example ``project.json, muscles[3].kappa``
    what : what is wrong with it, continuing the sentence, for example ``is not a finite number``
    remedy : what to do about it
    """

    def __init__(self, where: str, what: str, remedy: str = RESTORE) -> None:
        super().__init__(f"{where} {what}")
        self.where = where
        self.what = what
        self.remedy = remedy


def disk_sentence(path: Path, failed: str, error: OSError | ValueError) -> str:
    """What to tell a user when the operating system refuses, for example with ``failed="saved"``."""
    code = error.errno if isinstance(error, OSError) else None
    reason = REMEDIES.get(code or 0) or f"the system says “{getattr(error, 'strerror', None) or error}”"
    return f"“{path}” cannot be {failed}: {reason}."


@contextmanager
def naming(path: Path, failed: str, remedy: str = "") -> Iterator[None]:
    """Turn a `DamageError` into a `ProjectError` that names the file, and another remedy where one is given."""
    try:
        yield
    except DamageError as damage:
        raise ProjectError(
            f"“{path}” cannot be {failed}: {damage.where} {damage.what}; {remedy or damage.remedy}."
        ) from damage

"""Read and replace whole files safely: a reader is never surprised, a failed write leaves the old file."""

from __future__ import annotations

import errno
import os
import secrets
import shutil
import stat
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import BinaryIO

from facemodel.errors import ProjectError
from facemodel.io.damage import disk_sentence

UNSYNCABLE = {errno.EINVAL, errno.ENOTSUP, errno.EACCES, errno.EBADF}
"""Errors of file systems that cannot flush a folder; the file itself has been flushed by then."""


def read_file(path: Path, limit: int) -> bytes:
    """All bytes of a regular file of at most ``limit`` bytes.

    Raises
    ------
    ProjectError
        If it is missing, not a regular file (reading a pipe could wait for ever), unreadable or larger.
    """
    try:
        status = path.stat()
        if not stat.S_ISREG(status.st_mode):
            raise ProjectError(f"“{path}” cannot be opened: it is {_kind(status)}; choose a file.")
        if status.st_size > limit:
            raise ProjectError(
                f"“{path}” cannot be opened: it has {status.st_size / 2**20:.0f} MiB and at most "
                f"{limit / 2**20:.0f} MiB are read; choose a Risorius file."
            )
        return path.read_bytes()
    except (OSError, ValueError) as error:
        raise ProjectError(disk_sentence(path, "opened", error)) from error


@contextmanager
def replacing(path: Path) -> Iterator[BinaryIO]:
    """A stream whose bytes become the file at ``path`` only when all of them are on the disk; see `replacing_file`."""
    with replacing_file(path) as fresh, open(fresh, "xb") as stream:
        yield stream


@contextmanager
def replacing_file(path: Path) -> Iterator[Path]:
    """The name of a new file, to be written, that becomes the file at ``path`` only when it is whole on the disk.

    It lies in the same folder and ends as ``path`` does.  Once written it is flushed to the disk and takes the name.
    A link is followed, so that it goes on pointing at the file.  On failure the new file is removed and the previous
    one stays as it was.

    Raises
    ------
    ProjectError
        If the folder is missing or not writable, the name belongs to a folder or device, or the disk is full.
    """
    target = checked_target(path)
    fresh = target.with_name(f".risorius-{secrets.token_hex(8)}{target.suffix}")
    try:
        yield fresh
        flush(fresh)
        if target.exists():
            shutil.copymode(target, fresh)
        os.replace(fresh, target)
    except OSError as error:
        fresh.unlink(missing_ok=True)
        raise ProjectError(disk_sentence(path, "saved", error)) from error
    except BaseException:
        fresh.unlink(missing_ok=True)
        raise
    sync_folder(target.parent)


def flush(path: Path) -> None:
    """Have all bytes of a file written to the disk."""
    with open(path, "r+b") as stream:
        os.fsync(stream.fileno())


def checked_target(path: Path) -> Path:
    """The file that is meant by a path, links followed, if a file can be written there as far as can be known.

    Raises
    ------
    ProjectError
        If the folder is missing, or the name belongs to a folder, a device or a write-protected file.
    """
    try:
        target = Path(os.path.realpath(path))
        if target.is_symlink():
            raise OSError(errno.ELOOP, os.strerror(errno.ELOOP))
        if not target.parent.is_dir():
            raise ProjectError(
                f"“{path}” cannot be saved: there is no folder “{target.parent}”; create it or choose another."
            )
        status = target.stat() if target.exists() else None
        writable = os.access(target if status else target.parent, os.W_OK)
    except (OSError, ValueError) as error:
        raise ProjectError(disk_sentence(path, "saved", error)) from error
    if status is not None and not stat.S_ISREG(status.st_mode):
        raise ProjectError(f"“{path}” cannot be saved: it is {_kind(status)}; choose another name.")
    if status is not None and not writable:
        raise ProjectError(
            f"“{path}” cannot be saved: the file is write-protected; choose another name or allow writing."
        )
    if not writable:
        raise ProjectError(disk_sentence(path, "saved", OSError(errno.EACCES, os.strerror(errno.EACCES))))
    return target


def _kind(status: os.stat_result) -> str:
    return "a folder" if stat.S_ISDIR(status.st_mode) else "a device or a pipe"


def sync_folder(folder: Path) -> None:
    """Flush the folder, so that the new name survives a power cut; Windows has no such call."""
    if os.name == "nt":
        return
    try:
        handle = os.open(folder, os.O_RDONLY)
        try:
            os.fsync(handle)
        finally:
            os.close(handle)
    except OSError as error:
        if error.errno not in UNSYNCABLE:
            raise ProjectError(disk_sentence(folder, "flushed", error)) from error

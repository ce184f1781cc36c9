"""Numbered files that replace an earlier sequence of the same name, all of them or none."""

from __future__ import annotations

import os
import re
import secrets
import shutil
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

from facemodel.errors import ProjectError
from facemodel.io.damage import disk_sentence
from facemodel.io.disk import checked_target, flush, sync_folder

FEWEST_DIGITS = 4
"""As most programs write frame numbers; longer sequences take more."""


def numbered(path: Path, number: int, count: int) -> Path:
    """The name of one file of a sequence of ``count``: ``smile.0007.png`` for ``smile.png``."""
    digits = max(FEWEST_DIGITS, len(str(count)))
    return path.with_name(f"{path.stem}.{number:0{digits}}{path.suffix}")


@contextmanager
def replacing_sequence(path: Path, count: int) -> Iterator[Callable[[int], Path]]:
    """Names by number, from 1 to ``count``, of new files to be written, which become the sequence when all are whole.

    They are written into a hidden folder beside their places, flushed to the disk, and then take their names.  Of an
    earlier, longer sequence of the same name what goes beyond the new one is removed, so that two takes are never
    mixed.  On failure the hidden folder is removed and an earlier sequence stays as it was.

    Raises
    ------
    ProjectError
        If the folder is missing or not writable, a name belongs to a folder or device, or the disk is full.
    """
    places = [checked_target(numbered(path, number, count)) for number in range(1, count + 1)]
    folder = places[0].parent
    fresh = folder / f".risorius-{secrets.token_hex(8)}"
    try:
        fresh.mkdir()
        yield lambda number: fresh / places[number - 1].name
        for place in places:
            flush(fresh / place.name)
        for place in places:
            os.replace(fresh / place.name, place)
        for surplus in _members(path, folder):
            if surplus not in places:
                surplus.unlink()
    except OSError as error:
        raise ProjectError(disk_sentence(path, "saved", error)) from error
    finally:
        shutil.rmtree(fresh, ignore_errors=True)
    sync_folder(folder)


def _members(path: Path, folder: Path) -> list[Path]:
    """Files that look like frames of a sequence of this name."""
    frame = re.compile(rf"{re.escape(path.stem)}\.\d{{{FEWEST_DIGITS},}}{re.escape(path.suffix)}")
    return [each for each in folder.iterdir() if frame.fullmatch(each.name) and each.is_file()]

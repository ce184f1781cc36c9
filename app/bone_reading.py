"""Read a skull in a process of its own: the window goes on, it can be stopped, and a file that breaks the reader breaks
nothing else.

What works on meshes below Python holds the interpreter for seconds on end, so that a thread would not do.
"""

from __future__ import annotations

from multiprocessing import get_context
from multiprocessing.connection import Connection
from pathlib import Path

from app.jobs import Job
from facemodel.errors import ProjectError, RisoriusError
from facemodel.skull.mending import Bone
from facemodel.solution import Progress, silent

PATIENCE = 0.05
"""Seconds between two looks at whether the reading was stopped."""

BoneJob = Job[Path, Bone]
"""Reads skulls."""


def read_apart(path: Path, progress: Progress = silent) -> Bone:
    """A mesh that can be a skull, see `facemodel.io.bone_file.read_bone`.

    Raises
    ------
    ProjectError
        If the file cannot be read.
    Cancelled
        If the progress callback raised it.
    """
    context = get_context("spawn")
    ours, theirs = context.Pipe(duplex=False)
    worker = context.Process(target=_read, args=(path, theirs), daemon=True)
    worker.start()
    theirs.close()
    try:
        return _awaited(path, ours, progress)
    finally:
        worker.terminate()
        worker.join()
        worker.close()
        ours.close()


def _awaited(path: Path, ours: Connection, progress: Progress) -> Bone:
    told = ("Reading the file", 0.0)
    while True:
        progress(*told)
        if not ours.poll(PATIENCE):
            continue
        try:
            said = ours.recv()
        except EOFError as error:
            raise ProjectError(
                f"“{path}” cannot be opened: reading it broke off, perhaps for want of memory; reduce its mesh first."
            ) from error
        if isinstance(said, Bone):
            return said
        if isinstance(said, str):
            raise ProjectError(said)
        told = said


def _read(path: Path, theirs: Connection) -> None:
    """In the other process: send steps as they are taken, then the bone, or the sentence of what is wrong."""
    # Here and not above: the window need not know the reader of meshes, which takes a while to load.
    from facemodel.io.bone_file import read_bone

    try:
        theirs.send(read_bone(path, lambda text, share: theirs.send((text, share))))
    except RisoriusError as error:
        theirs.send(str(error))

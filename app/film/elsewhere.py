"""Export in a process of its own: the editor stays free, and its graphics memory and interpreter belong to it alone.

The process is told the order as one line of JSON on its input, and says how far it is as lines of JSON on its output.
When its input is closed it stops and tidies up, which also happens when the editor is killed.
"""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Iterator
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path
from tempfile import TemporaryFile, mkstemp
from typing import IO

import app
from app.film.film import FilmError
from app.film.order import Order
from facemodel.cache import cached_solution, keep_solution
from facemodel.io.project_file import save_project
from facemodel.project import Project
from facemodel.solution import Progress, Solution, silent

WORKER = "ui.headless.worker"
"""The module that the process runs.  It draws, which nothing here knows how to do: it is named, not imported."""

PATIENCE = 20.0
"""Seconds that a process has to tidy up after it was told to stop; drawing one picture of the largest takes a few."""


@dataclass(frozen=True, eq=False)
class Errand:
    """An order with all that it takes to fulfil it, a snapshot of what is open.

    Attributes
    ----------
    order : what is wanted
    project : what is exported
    solved : its solution without what is sculpted on it
    folder : of the project's file, from which the path of its sound counts; none if it has no file
    """

    order: Order
    project: Project
    solved: Solution
    folder: Path | None = None


def run_errand(errand: Errand, progress: Progress = silent) -> str:
    """Have an order fulfilled by another process, and wait for it.

    Parameters
    ----------
    errand : what is to be done
    progress : told about every frame; what it raises stops the process

    Returns
    -------
    What was made, for people.

    Raises
    ------
    RisoriusError
        If it cannot be done; what was there before stays.
    """
    progress("Getting ready", 0.0)
    if cached_solution(errand.project) is None:
        # Without room in the cache the process solves once more.
        keep_solution(errand.project, errand.solved)
    with _snapshot(errand.project) as snapshot, TemporaryFile() as complaints:
        told = {"project": str(snapshot), "folder": str(errand.folder or ""), "order": errand.order.as_json()}
        with _process(complaints) as process:
            assert process.stdin is not None
            assert process.stdout is not None
            process.stdin.write(json.dumps(told) + "\n")
            process.stdin.flush()
            answer = _answer(process.stdout, progress)
        if answer is None:
            raise FilmError(_end_of(process.returncode, complaints))
    return answer


@contextmanager
def _snapshot(project: Project) -> Iterator[Path]:
    """A file of a project for the process, which removes it when it has read it: the editor may be gone by then."""
    handle, name = mkstemp(prefix="risorius-", suffix=".risorius")
    os.close(handle)
    try:
        save_project(project, Path(name))
        yield Path(name)
    finally:
        Path(name).unlink(missing_ok=True)


def _answer(output: IO[str], progress: Progress) -> str | None:
    """What the process says in the end; nothing if it ends without a word."""
    for line in output:
        said = json.loads(line)
        if "failed" in said:
            raise FilmError(str(said["failed"]))
        if "done" in said:
            return str(said["done"])
        progress(str(said["text"]), float(said["share"]))
    return None


@contextmanager
def _process(complaints: IO[bytes]) -> Iterator[subprocess.Popen[str]]:
    """The process, which is told to stop when the context ends."""
    process = subprocess.Popen(
        [sys.executable, "-m", WORKER],
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        stderr=complaints,
        text=True,
        encoding="utf-8",
        env={**os.environ, "PYTHONIOENCODING": "utf-8"},
        cwd=Path(app.__file__).resolve().parent.parent,
        creationflags=getattr(subprocess, "CREATE_NO_WINDOW", 0),
    )
    try:
        yield process
    finally:
        assert process.stdin is not None
        assert process.stdout is not None
        process.stdin.close()
        try:
            process.wait(PATIENCE)
        except subprocess.TimeoutExpired:
            process.kill()
            process.wait()
        process.stdout.close()


def _end_of(status: int, complaints: IO[bytes]) -> str:
    """What to tell people about a process that ended by itself."""
    complaints.seek(0)
    lines = complaints.read().decode("utf-8", "replace").strip().splitlines()
    last = lines[-1].strip() if lines else f"status {status}"
    return f"The export ended before it was done ({last}); try once more, smaller or shorter if it happens again."

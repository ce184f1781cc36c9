"""The process that exports for the editor; see `app.film.elsewhere`, which starts it and tells it what to do."""

from __future__ import annotations

import json
import os
import sys
from functools import partial
from pathlib import Path
from threading import Event, Thread
from typing import IO, Any

from app.film.ending import told_to_end
from app.film.order import fulfil, order_of
from facemodel.cache import solve_cached
from facemodel.errors import RisoriusError
from facemodel.io.project_file import load_project
from facemodel.project import Project
from facemodel.sculpting.corrected import Corrector
from facemodel.solution import Cancelled, Progress, Solution
from ui.launch import frames


def main(orders: IO[str], answers: IO[str]) -> int:
    """Fulfil one order; the status is zero if it was done."""
    told = json.loads(orders.readline())
    stopped = Event()
    Thread(target=_wait_for_the_end, args=(orders.fileno(), stopped), daemon=True).start()

    def say(**words: Any) -> None:
        print(json.dumps(words), file=answers, flush=True)

    def progress(text: str, share: float) -> None:
        if stopped.is_set():
            raise Cancelled
        say(text=text, share=share)

    try:
        snapshot = Path(told["project"])
        project = load_project(snapshot)
        snapshot.unlink()
        folder = Path(told["folder"]) if told["folder"] else None
        solve = partial(_solved, project, lambda text, _share: progress(text, 0.0))
        say(done=fulfil(order_of(told["order"]), project, solve, frames, folder, progress))
    except RisoriusError as error:
        say(failed=str(error))
        return 1
    except (Cancelled, KeyboardInterrupt, BrokenPipeError):
        return 1
    return 0


def _solved(project: Project, progress: Progress) -> Solution:
    return Corrector()(solve_cached(project, progress), project)


def _wait_for_the_end(pipe: int, stopped: Event) -> None:
    """Wait until nobody wants the work any more: the other end of the pipe is closed, or gone.

    It is read without Python's buffers, whose lock nobody may hold when the interpreter ends.
    """
    while os.read(pipe, 1):
        pass
    stopped.set()


if __name__ == "__main__":
    with told_to_end():
        sys.exit(main(sys.stdin, sys.stdout))

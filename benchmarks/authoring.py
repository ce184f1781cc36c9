"""What the hand waits for while it paints, lays fibres and undoes, in the window itself; and what the journal costs.

Frames are drawn at once and not when the window finds time, so that what is compared is work and no waiting.
"""

from __future__ import annotations

import os
import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from dataclasses import replace
from pathlib import Path

import numpy as np

from benchmarks.authoring_window import AuthoringWindow, authoring_window
from benchmarks.figure import Figure, Unmeasured, alone, compared, interleaved
from facemodel.project import Project, Settings
from facemodel.projects import new_project

DENSITY = 4
"""Segments per edge of an element that are drawn: fifty thousand points."""

MOVES, STROKES, RELEASES, COMMANDS = 40, 5, 7, 60
BRUSH_LIMIT = 1.5

TICK = 0.0005
"""Seconds between two looks at the clock while a journal is written beside."""


def figures() -> Iterator[Figure]:
    """Work in a window of its own on the default face."""
    if sys.platform == "linux" and not (os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY")):
        raise Unmeasured("there is no display; run it by .ci/with-display.")
    project = replace(new_project(), settings=Settings(density=DENSITY))
    with authoring_window(project) as window:
        yield from _brush_figures(window)
        yield from _fibre_figures(window)
    yield from _journal_figures(project)


def _brush_figures(window: AuthoringWindow) -> Iterator[Figure]:
    points = len(window.main.viewport.scene.figure.posed.points)
    window.begin_painting()
    window.press(*window.path(0))
    turn = iter(range(1, 10_000))
    taken = interleaved({"move": lambda: window.move(*window.path(next(turn))), "again": window.draw}, MOVES)
    window.release(*window.path(next(turn)))
    window.wait_for_fields()
    what = f"brush move to drawn frame, {points:,} points"
    yield compared(what, taken["move"], "the same picture drawn again", taken["again"], BRUSH_LIMIT)
    strokes, undos, backs = [], [], []
    for number in range(STROKES):
        window.press(*window.path(40 * number))
        for step in range(12):
            window.move(*window.path(40 * number + 3 * step))
        strokes.append(_seconds(lambda number=number: window.release_and_wait(*window.path(40 * number + 36))))
        undos.append(_seconds(window.undo))
        backs.append(_seconds(window.wait_for_fields))
    yield alone("end of a stroke to new fields", np.array(strokes))
    yield alone("undo of a stroke to the drawn frame", np.array(undos))
    yield alone("and until its fields are solved again", np.array(backs))


def _fibre_figures(window: AuthoringWindow) -> Iterator[Figure]:
    window.begin_laying("zygomaticus_major_L")
    places = window.attachment()
    moves, releases, redraws, solves = [], [], [], []
    for number in range(RELEASES):
        window.press(*places)
        way = np.array([1.0, -0.6]) * (1 if number % 2 == 0 else -1)
        for step in range(1, 7):
            at = tuple(np.array(places) + 3.0 * step * way)
            moves.append(_seconds(lambda at=at: window.move(*at)))
            redraws.append(_seconds(window.draw))
        places = at
        releases.append(_seconds(lambda places=places: window.release_and_wait(*places)))
        solves.append(window.seconds_of_solver)
        places = window.attachment()
    what = "end of a fibre dragged to drawn frame, influence and forces with it"
    yield compared(what, np.array(moves), "the same picture drawn again", np.array(redraws))
    work = window.work
    did = f"{work.columns} columns solved, {'factorised anew' if work.factorised else 'no new factorisation'}"
    yield alone(f"release of a fibre to new fields, drawn ({did})", np.array(releases))
    yield alone("of which the solver took", np.array(solves))


def _journal_figures(project: Project) -> Iterator[Figure]:
    """Commands with a journal beside them, against commands without one."""
    from app.autosave import Autosave
    from app.document import Document
    from app.journal import Journal, Note

    with tempfile.TemporaryDirectory() as folder:
        bare, kept = Document(project), Document(project)
        autosave = Autosave(kept, lambda call: call(), Path(folder))
        count = iter(range(100_000))

        def act(document: Document) -> None:
            number = next(count)
            muscle = replace(document.project.muscles[0], width=5.0 + number % 40)
            document.edit(replace(document.project, muscles=(muscle, *document.project.muscles[1:])), "Change")

        taken = interleaved({"kept": lambda: act(kept), "bare": lambda: act(bare)}, COMMANDS)
        autosave.close()
        journal = Journal(Path(folder))
        note = Note(name="bench", when=time.time())
        writes = np.array([_seconds(lambda: journal.write(project, note)) for _ in range(3)])
        stall = _longest_stall(lambda: journal.write(project, note))
        journal.clear()
    yield compared("command with the journal beside it", taken["kept"], "the command alone", taken["bare"])
    over = np.median(taken["kept"] - taken["bare"])
    yield alone("journal overhead per command, in the window’s thread", np.array([max(over, 0.0)]))
    yield alone("the journal written once, in a thread of its own", writes)
    yield alone("longest that the window’s thread stands still meanwhile", np.array([stall]))


def _longest_stall(work: Callable[[], object]) -> float:
    """Seconds that this thread is kept waiting at most while some work is done in another."""
    from threading import Thread

    other = Thread(target=work)
    other.start()
    longest, last = 0.0, time.perf_counter()
    while other.is_alive():
        time.sleep(TICK)
        now = time.perf_counter()
        longest, last = max(longest, now - last - TICK), now
    return longest


def _seconds(act: Callable[[], object]) -> float:
    start = time.perf_counter()
    act()
    return time.perf_counter() - start

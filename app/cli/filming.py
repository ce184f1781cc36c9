"""Films on the command line."""

from __future__ import annotations

import sys
from argparse import Namespace
from collections.abc import Sequence
from pathlib import Path

from app.cli.commands import solved
from app.cli.progress import ProgressLine
from app.cli.screen import Screen
from app.film import Film, FilmError, shoot
from facemodel.animation.timecode import read_time
from facemodel.project import Project


def film(project: Project, asked: Namespace, screen: Screen, folder: Path) -> str:
    """Film a project into ``asked.out``; what was made, in words.

    Parameters
    ----------
    project : what is played
    asked : the film
    screen : what draws
    folder : from which the path of its sound counts
    """
    wanted = Film(
        asked.size,
        asked.fps,
        asked_span(asked.range, asked.fps or project.animation.rate),
        asked.view,
        asked.close,
        asked.turntable,
        asked.antialias,
        asked.audio,
        asked.backdrop,
    )
    take = wanted.take(project)
    solution = solved(project, asked.basis)
    line = ProgressLine(sys.stderr)
    try:
        shoot(take, solution, wanted, asked.out, screen.frames, folder, line)
    finally:
        line.clear()
    return f"{len(take):,} frames, {take.duration:.1f} s"


def asked_span(texts: Sequence[str] | None, rate: float) -> tuple[float, float] | None:
    """The times that are meant by two texts; none without them.

    Raises
    ------
    FilmError
        If one of them is no time.
    """
    if texts is None:
        return None
    times = [read_time(text, rate, "seconds") for text in texts]
    for text, time in zip(texts, times, strict=True):
        if time is None:
            raise FilmError(f"“{text}” is no time; write seconds such as 2.5, frames such as 42f, or 00:00:02:12.")
    start, end = (time or 0.0 for time in times)
    return start, end

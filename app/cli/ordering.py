"""What is ordered on the command line: films, models, meshes and weights of an animation."""

from __future__ import annotations

import sys
from argparse import Namespace
from collections.abc import Sequence
from pathlib import Path

from app.cli.commands import solved
from app.cli.progress import ProgressLine
from app.cli.screen import Screen
from app.film import Film, FilmError
from app.film.ending import told_to_end
from app.film.order import Order, fulfil, kind_of
from facemodel.animation.timecode import read_time
from facemodel.io.export import Asked
from facemodel.project import Project


def export_animation(project: Project, asked: Namespace, screen: Screen, folder: Path) -> str:
    """Export the animation of a project into ``asked.out``; what was made, in words.

    Parameters
    ----------
    project : what is played
    asked : the options
    screen : what draws films
    folder : from which the path of the sound counts
    """
    order = asked_order(project, asked)
    line = ProgressLine(sys.stderr)
    try:
        with told_to_end():
            return fulfil(order, project, lambda: solved(project, asked.basis), screen.frames, folder, line)
    finally:
        line.clear()


def asked_order(project: Project, asked: Namespace) -> Order:
    """What the options ask for."""
    span = asked_span(asked.range, asked.fps or project.animation.rate)
    film = Film(
        asked.size,
        asked.fps,
        span,
        asked.view,
        asked.close,
        asked.turntable,
        asked.antialias,
        asked.audio,
        asked.backdrop,
    )
    wanted = Asked(True, asked.fps, span, asked.shapes, asked.most)
    return Order(asked.out, asked.format or kind_of(asked.out).key, film, wanted)


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

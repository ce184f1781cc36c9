"""Make a film: draw frame by frame, encode, and put the file in its place when all of it is there."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from pathlib import Path

from app.film.film import Film
from app.film.soundtrack import soundtrack
from facemodel.animation.take import Take
from facemodel.io.film import film_format_of, filming
from facemodel.io.film.reel import Picture, Reel
from facemodel.solution import Progress, Solution, silent

Draw = Callable[[Take, Solution, Film], Iterator[Picture]]
"""Draws the frames of a take one after the other."""


def shoot(
    take: Take,
    solution: Solution,
    film: Film,
    path: Path,
    draw: Draw,
    folder: Path | None = None,
    progress: Progress = silent,
) -> None:
    """Make a film in the format of the file's suffix, whole or not at all.

    Parameters
    ----------
    take : its frames, as `Film.take` gives them
    solution : displacement fields of the take's project
    film : what it is to be like
    path : the file to write
    draw : draws the frames
    folder : of the project's file, from which the path of its sound counts
    progress : told before every frame; what it raises ends the film, and leaves the file that there was

    Raises
    ------
    RisoriusError
        If the sound cannot be read or the film not be written; a previous file stays as it was.
    """
    heard = film.audible and film_format_of(path).sounds
    sound = soundtrack(take, folder) if heard else None
    reel = Reel(film.size, take.rate, len(take), sound, take.project.face.title)
    with filming(path, reel) as writer:
        for number, picture in enumerate(draw(take, solution, film)):
            progress(f"Filming, frame {number + 1} of {len(take)}", number / len(take))
            writer.add(picture)
        progress("Finishing the film", 1.0)

"""Options of the commands about what happens over time."""

from __future__ import annotations

from argparse import ArgumentParser, BooleanOptionalAction
from pathlib import Path
from typing import get_args

from app.cli.options import of_basis, of_expression, of_face, of_project, of_view
from app.cli.values import count, rate, seconds, size
from app.film.film import ANTIALIAS
from facemodel.io.export import EXPORTS
from facemodel.io.export.asked import Shaping
from facemodel.io.weights.writing import WEIGHT_EXPORTS

BACKDROPS = ("dark", "light")


def of_animate(made: ArgumentParser) -> None:
    """``risorius animate``."""
    of_project(made)
    made.add_argument("out", metavar="OUT", type=Path, help="the file to write; its suffix says what it is")
    made.add_argument(
        "--capture", metavar="FILE", type=Path, action="append", default=[], help="a recording to bring in; repeatable"
    )
    made.add_argument("--table", metavar="FILE", type=Path, help="how its channels become action units")
    made.add_argument(
        "--speech", metavar="FILE", type=Path, action="append", default=[], help="phonemes to bring in; repeatable"
    )
    made.add_argument("--rate", metavar="RATE", type=rate, help="frames per second of what is brought in")
    made.add_argument(
        "--neutral",
        metavar="SECONDS",
        type=seconds,
        help="when a face known by landmarks was at rest (calmest at start)",
    )
    _of_weights(made)
    of_frames(made)
    _of_shapes(made)
    _of_film(made, close=False)
    of_basis(made)


def of_demo(made: ArgumentParser) -> None:
    """``risorius demo``."""
    made.add_argument("out", metavar="OUT", nargs="?", type=Path, help="the file to write; without it, the piece opens")
    of_face(made)
    _of_weights(made)
    of_frames(made)
    _of_shapes(made)
    _of_film(made, close=True)
    of_basis(made)


def of_export(made: ArgumentParser) -> None:
    """``risorius export``."""
    of_project(made)
    made.add_argument("out", metavar="OUT", type=Path, help=f"the file to write: {', '.join(EXPORTS)}")
    of_expression(made)
    of_basis(made)
    made.add_argument("--still", action="store_true", help="without the animation of the project")
    made.add_argument("--sequence", action="store_true", help="one numbered .obj or .ply for every frame")
    of_frames(made)
    _of_shapes(made)


def of_frames(made: ArgumentParser) -> None:
    """Which frames."""
    made.add_argument("--fps", metavar="RATE", type=rate, help="frames per second (those of the project)")
    made.add_argument(
        "--range",
        metavar=("FROM", "TO"),
        nargs=2,
        help="seconds, frames such as 42f or timecode (all that the animation plays)",
    )


def _of_weights(made: ArgumentParser) -> None:
    made.add_argument("--format", choices=tuple(WEIGHT_EXPORTS), help="of weights (the first that the suffix allows)")


def _of_shapes(made: ArgumentParser) -> None:
    made.add_argument(
        "--shapes",
        choices=get_args(Shaping),
        default="units",
        help="of an animated model: its action units and what corrects them, or a few shapes made for the clip (units)",
    )
    made.add_argument("--most", metavar="N", type=count, help="shapes at most; viewers on phones take 8")


def _of_film(made: ArgumentParser, close: bool) -> None:
    film = made.add_argument_group("films")
    film.add_argument("--size", metavar="WIDTHxHEIGHT", type=size, default=(1280, 720), help="in pixels (1280x720)")
    of_view(film)  # type: ignore[arg-type]
    film.add_argument("--close", action=BooleanOptionalAction, default=close, help="the face without crown and neck")
    film.add_argument(
        "--turntable", metavar="TURNS", type=float, nargs="?", const=1.0, default=0.0, help="turn the head round (once)"
    )
    film.add_argument("--antialias", choices=tuple(ANTIALIAS), default="fine", help="how pixels are smoothed (fine)")
    film.add_argument("--audio", action=BooleanOptionalAction, default=True, help="with or without its sound (with)")
    film.add_argument("--backdrop", choices=BACKDROPS, default="dark", help="behind the head (dark)")

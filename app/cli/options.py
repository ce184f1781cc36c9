"""Options that several commands share, and those of the commands about a face at rest."""

from __future__ import annotations

from argparse import ArgumentParser
from pathlib import Path

from app.cli.values import OVERLAYS, overlays, size, weight
from app.view_state import VIEW_TITLES
from facemodel.faces import face_keys


def of_project(made: ArgumentParser) -> None:
    """The file that is worked on."""
    made.add_argument("project", metavar="PROJECT", type=Path, help="a .risorius file")


def of_face(made: ArgumentParser) -> None:
    """Which individual."""
    made.add_argument("--face", metavar="NAME", help=f"which face: {', '.join(face_keys())} (the first if not given)")


def of_expression(made: ArgumentParser) -> None:
    """What the face does."""
    made.add_argument(
        "--au", metavar="NAME=WEIGHT", type=weight, action="append", default=[], help="an action unit; repeatable"
    )
    made.add_argument(
        "--emotion", metavar="NAME=WEIGHT", type=weight, action="append", default=[], help="an emotion; repeatable"
    )


def of_basis(made: ArgumentParser) -> None:
    """Which displacement fields."""
    made.add_argument(
        "--basis",
        choices=("solved", "sculpted"),
        default="solved",
        help="displacement fields solved with finite elements, or sculpted by hand for the default face (solved)",
    )


def of_view(made: ArgumentParser) -> None:
    """Where one looks from."""
    made.add_argument("--view", choices=tuple(VIEW_TITLES), default="front", help="where to look from (front)")


def of_new(made: ArgumentParser) -> None:
    """``risorius new``."""
    made.add_argument("out", metavar="OUT.risorius", type=Path, help="the file to write")
    of_face(made)
    made.add_argument("--replace", action="store_true", help="write over a file that exists")


def of_info(made: ArgumentParser) -> None:
    """``risorius info``."""
    of_project(made)
    made.add_argument("--json", action="store_true", help="print the figures as JSON")


def of_render(made: ArgumentParser) -> None:
    """``risorius render``."""
    of_project(made)
    made.add_argument("out", metavar="OUT.png", type=Path, help="the picture to write")
    of_expression(made)
    of_basis(made)
    of_view(made)
    made.add_argument("--size", metavar="WIDTHxHEIGHT", type=size, default=(1280, 960), help="in pixels (1280x960)")
    made.add_argument(
        "--show",
        metavar="LIST",
        type=overlays,
        default=frozenset(),
        help=f"what to draw with the skin, separated by commas: {', '.join(OVERLAYS)}",
    )
    made.add_argument(
        "--linear",
        action="store_true",
        help="draw the pure linear sum of the fields: no arc of the jaw, nothing that lids and lips meet",
    )


def of_gallery(made: ArgumentParser) -> None:
    """``risorius gallery``."""
    of_project(made)
    made.add_argument("out", metavar="OUT.png", type=Path, help="the picture to write")
    of_basis(made)


def of_calibrate(made: ArgumentParser) -> None:
    """``risorius calibrate``."""
    made.add_argument(
        "measured", metavar="MEASURED", type=Path, help="an .npz of measured expressions, or a .risorius project"
    )
    made.add_argument("--report-only", action="store_true", help="adjust nothing; measure the anatomy that ships")
    made.add_argument(
        "--hold-out", action="store_true", help="cross-check what was learned on expressions it was not learned from"
    )
    made.add_argument("--learn", metavar="ANATOMY.json", type=Path, help="write the recipe of anatomy that was learned")
    made.add_argument("-o", "--out", metavar="REPORT.json", type=Path, help="write the figures as JSON, too")


def of_edit(made: ArgumentParser) -> None:
    """``risorius edit``."""
    made.add_argument("project", metavar="PROJECT", nargs="?", type=Path, help="a .risorius file to open")

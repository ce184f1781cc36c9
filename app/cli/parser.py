"""The grammar of the command line and its help."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace, RawDescriptionHelpFormatter
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import NoReturn

from app.cli.values import OVERLAYS, overlays, rate, size, weight
from app.view_state import VIEW_TITLES
from facemodel.faces import face_keys
from facemodel.io.weights.writing import WEIGHT_EXPORTS

DESCRIPTION = """\
A desktop editor for facial expression: muscles and skin solved with finite elements, mixed in real time.
Without a command it opens the editor."""

EXAMPLES = """\
examples:
  risorius                                       open the editor on the default face
  risorius new smile.risorius                    begin a project
  risorius render smile.risorius smile.png --emotion happiness=1
  risorius export smile.risorius smile.glb       the head with morph targets"""

WEIGHTS = """\
--au takes a FACS number or name, for both sides or one: 12, 12L, AU12, “lip corner puller R”.
Several emotions mix by the larger weight; --au then overrides what they say.
With neither, the expression saved in the project is shown.
"""

FORMATS = """\
formats:
  .glb   the whole head at rest with one morph target per action unit, in metres
  .npz   neutral and posed (N, 3), triangles (T, 3), names (M,) and fields (M, N, 3), in millimetres
  .obj   the head with the expression, in millimetres
  .ply   the same as one coloured mesh

"""


ANIMATED = """\
--capture takes a recording of OpenFace, Live Link Face, ARKit, MediaPipe or MPEG-4, or a table of weights.
--speech takes phonemes of Rhubarb, Papagayo, Praat or the Montreal Forced Aligner.
Both are brought into what is written; the project itself stays as it is.

formats:
  .risorius  the project with its animation
  .csv       weights, frame by frame: --format weights, arkit or live-link
  .fap       MPEG-4 face animation parameters, in units of this face

"""


@dataclass(frozen=True)
class Command:
    """One command.

    Attributes
    ----------
    name, summary : the word and what it does
    arguments : adds its arguments to its parser
    examples : what may follow ``risorius name``
    more : help that stands before the examples
    """

    name: str
    summary: str
    arguments: Callable[[ArgumentParser], None]
    examples: tuple[str, ...]
    more: str = ""

    @property
    def epilog(self) -> str:
        """What stands below the options."""
        lines = [f"  risorius {self.name} {example}".rstrip() for example in self.examples]
        return "\n".join([self.more, "examples:", *lines])


class Parser(ArgumentParser):
    """Says in one sentence what is wrong."""

    def error(self, message: str) -> NoReturn:
        """Print the sentence and end with status 2."""
        self.exit(2, f"risorius: {message.removesuffix('.')}; see “{self.prog} --help”.\n")


def parser(commands: Mapping[str, Callable[[Namespace], int]]) -> ArgumentParser:
    """The parser; the namespace it returns holds the chosen one of ``commands`` as ``run``.

    Parameters
    ----------
    commands : what to call for each command, by its name
    """
    whole = Parser(
        prog="risorius", description=DESCRIPTION, epilog=EXAMPLES, formatter_class=RawDescriptionHelpFormatter
    )
    whole.set_defaults(run=commands["edit"], project=None)
    sub = whole.add_subparsers(title="commands", metavar="COMMAND", parser_class=Parser)
    for command in COMMANDS:
        made = sub.add_parser(
            command.name,
            help=command.summary,
            description=command.summary[0].upper() + command.summary[1:] + ".",
            epilog=command.epilog,
            formatter_class=RawDescriptionHelpFormatter,
        )
        made.set_defaults(run=commands[command.name])
        command.arguments(made)
    return whole


def _project(made: ArgumentParser) -> None:
    made.add_argument("project", metavar="PROJECT", type=Path, help="a .risorius file")


def _new(made: ArgumentParser) -> None:
    made.add_argument("out", metavar="OUT.risorius", type=Path, help="the file to write")
    made.add_argument("--face", metavar="NAME", help=f"which face: {', '.join(face_keys())} (the first if not given)")
    made.add_argument("--replace", action="store_true", help="write over a file that exists")


def _info(made: ArgumentParser) -> None:
    _project(made)
    made.add_argument("--json", action="store_true", help="print the figures as JSON")


def _expression(made: ArgumentParser) -> None:
    made.add_argument(
        "--au", metavar="NAME=WEIGHT", type=weight, action="append", default=[], help="an action unit; repeatable"
    )
    made.add_argument(
        "--emotion", metavar="NAME=WEIGHT", type=weight, action="append", default=[], help="an emotion; repeatable"
    )


def _basis(made: ArgumentParser) -> None:
    made.add_argument(
        "--basis",
        choices=("solved", "sculpted"),
        default="solved",
        help="displacement fields solved with finite elements, or sculpted by hand for the default face (solved)",
    )


def _render(made: ArgumentParser) -> None:
    _project(made)
    made.add_argument("out", metavar="OUT.png", type=Path, help="the picture to write")
    _expression(made)
    _basis(made)
    made.add_argument("--view", choices=tuple(VIEW_TITLES), default="front", help="where to look from (front)")
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


def _export(made: ArgumentParser) -> None:
    _project(made)
    made.add_argument("out", metavar="OUT", type=Path, help="the file to write: .glb, .npz, .obj or .ply")
    _expression(made)
    _basis(made)


def _written(made: ArgumentParser) -> None:
    made.add_argument("--format", choices=tuple(WEIGHT_EXPORTS), help="of weights (the first that the suffix allows)")
    made.add_argument("--fps", metavar="RATE", type=rate, help="frames per second (those of the project)")


def _animate(made: ArgumentParser) -> None:
    _project(made)
    made.add_argument("out", metavar="OUT", type=Path, help="the file to write: .risorius, .csv or .fap")
    made.add_argument(
        "--capture", metavar="FILE", type=Path, action="append", default=[], help="a recording to bring in; repeatable"
    )
    made.add_argument("--table", metavar="FILE", type=Path, help="how its channels become action units")
    made.add_argument(
        "--speech", metavar="FILE", type=Path, action="append", default=[], help="phonemes to bring in; repeatable"
    )
    made.add_argument("--rate", metavar="RATE", type=rate, help="frames per second of what is brought in")
    _written(made)


def _demo(made: ArgumentParser) -> None:
    made.add_argument("out", metavar="OUT", type=Path, help="the file to write: .risorius, .csv or .fap")
    made.add_argument("--face", metavar="NAME", help=f"which face: {', '.join(face_keys())} (the first if not given)")
    _written(made)


def _gallery(made: ArgumentParser) -> None:
    _project(made)
    made.add_argument("out", metavar="OUT.png", type=Path, help="the picture to write")
    _basis(made)


def _edit(made: ArgumentParser) -> None:
    made.add_argument("project", metavar="PROJECT", nargs="?", type=Path, help="a .risorius file to open")


COMMANDS = (
    Command(
        "new", "begin a project on one of the faces that ship", _new, ("smile.risorius", "old.risorius --face dayo")
    ),
    Command("solve", "solve all action units and keep the result for later commands", _project, ("smile.risorius",)),
    Command("info", "show the figures of a project", _info, ("smile.risorius", "smile.risorius --json")),
    Command(
        "render",
        "draw an expression into a PNG picture, without a window",
        _render,
        (
            "smile.risorius smile.png --au 12=0.8 --au 1L=0.5",
            "smile.risorius fear.png --emotion fear=1 --view three-quarter --size 1920x1080",
            "smile.risorius muscles.png --show skull,muscles",
            "smile.risorius look.png --au 61=0.5 --au 53=0.3",
        ),
        WEIGHTS,
    ),
    Command(
        "export",
        "write the face for other programs, in the format of the file's suffix",
        _export,
        ("smile.risorius smile.glb", "smile.risorius fields.npz", "smile.risorius fear.obj --emotion fear=1"),
        FORMATS + WEIGHTS,
    ),
    Command(
        "animate",
        "bring captures and speech into a project, and write what happens over time",
        _animate,
        (
            "smile.risorius played.risorius --capture take.csv",
            "smile.risorius weights.csv --capture take.csv --format live-link",
            "smile.risorius spoken.risorius --speech line.TextGrid",
            "smile.risorius face.fap --fps 25",
        ),
        ANIMATED,
    ),
    Command(
        "demo",
        "write a piece of twenty seconds: seven emotions, a spoken line, blinks",
        _demo,
        ("demo.risorius", "demo.csv --format arkit"),
    ),
    Command(
        "gallery",
        "draw all action units and emotions on one sheet",
        _gallery,
        ("smile.risorius sheet.png", "smile.risorius by-hand.png --basis sculpted"),
    ),
    Command("edit", "open the editor", _edit, ("", "smile.risorius")),
)
"""Everything that the command line can do."""

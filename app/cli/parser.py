"""The grammar of the command line and its help."""

from __future__ import annotations

from argparse import ArgumentParser, Namespace, RawDescriptionHelpFormatter
from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import NoReturn

from app.cli.animation_options import of_animate, of_demo, of_export
from app.cli.options import of_calibrate, of_edit, of_gallery, of_info, of_new, of_project, of_render

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
  .glb   the whole head in metres: one morph target per action unit, or those of its animation, which it plays
  .usdc  the same as USD with blend shapes and a skeleton; .usda is the same as text
  .npz   neutral and posed (N, 3), triangles (T, 3), names (M,) and fields (M, N, 3), in millimetres
  .obj   the head with the expression, in millimetres
  .ply   the same as one coloured mesh

"""

MEASURED = """\
MEASURED.npz holds, for a face of any mesh:
  neutral (N, 3)       its vertices in millimetres
  triangles (T, 3)     vertex indices, counter-clockwise seen from outside
  landmarks68 (68,)    vertices of the 68-point scheme, in its order
  names (K,)           of the expressions, as ARKit has them: mouthSmile_L, browInnerUp, ...
  deltas (K, N, 3)     how each of them moves the vertices, in millimetres
Other arrays are ignored.  The head lent to it is the default one; its muscles are carried over by the landmarks.
Of a project, the solved fields are compared with the units that an artist sculpted on the default head, and nothing
is adjusted.

Without --report-only the recipe of the anatomy is adjusted to the measured face: widths, kappa, ends of fibres along
bone and skin, mixtures of muscles and the stiffness of regions, each within anatomical bounds and none per vertex.
That takes a few minutes; Ctrl+C ends it and keeps what was learned by then.  --hold-out takes about four times as
long: it learns from the measured expressions and tells on those sculpted on the default head, the other way round,
and leaves a third of the measured action units out in turns.

Figures are area-weighted over the whole skin.  Each solved field is scaled by the one factor, not below zero, that
brings it nearest to the measured one; the cosine needs none.  The direction error is the mean angle between both
where the skin moves at least half as far as it does anywhere.

"""


ANIMATED = """\
--capture takes a recording of OpenFace, Live Link Face, ARKit, MediaPipe or MPEG-4, or a table of weights.
--speech takes phonemes of Rhubarb, Papagayo, Praat or the Montreal Forced Aligner.
Both are brought into what is written; the project itself stays as it is.

formats:
  .mp4       a film, H.264 and AAC, which everything plays
  .webm      a film, VP9 and Opus, for the web
  .png       one picture per frame, OUT.0001.png and so on, without sound
  .glb       a glTF model with morph targets and animated weights, .usdc and .usda the same as USD
  .obj       one mesh per frame, OUT.0001.obj and so on; .ply the same with colours
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


COMMANDS = (
    Command(
        "new", "begin a project on one of the faces that ship", of_new, ("smile.risorius", "old.risorius --face dayo")
    ),
    Command("solve", "solve all action units and keep the result for later commands", of_project, ("smile.risorius",)),
    Command("info", "show the figures of a project", of_info, ("smile.risorius", "smile.risorius --json")),
    Command(
        "render",
        "draw an expression into a PNG picture, without a window",
        of_render,
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
        of_export,
        (
            "smile.risorius smile.glb",
            "smile.risorius phone.glb --shapes clip --most 8",
            "smile.risorius fear.obj --emotion fear=1",
            "smile.risorius frames.ply --sequence --fps 24 --range 0 2.5",
        ),
        FORMATS + WEIGHTS,
    ),
    Command(
        "animate",
        "film the animation of a project, or write it otherwise, with captures and speech brought in",
        of_animate,
        (
            "smile.risorius smile.mp4",
            "smile.risorius smile.webm --size 1920x1080 --fps 60 --view three-quarter --antialias finest",
            "smile.risorius still.mp4 --turntable --range 0 6",
            "smile.risorius phone.glb --shapes clip --most 8",
            "smile.risorius played.risorius --capture take.csv",
            "smile.risorius weights.csv --capture take.csv --format live-link",
            "smile.risorius spoken.risorius --speech line.TextGrid",
            "smile.risorius face.fap --fps 25",
        ),
        ANIMATED,
    ),
    Command(
        "demo",
        "open or film a piece of twenty seconds: seven emotions, a spoken line, blinks",
        of_demo,
        ("", "demo.mp4 --size 1920x1080", "demo.risorius", "demo.csv --format arkit"),
    ),
    Command(
        "gallery",
        "draw all action units and emotions on one sheet",
        of_gallery,
        ("smile.risorius sheet.png", "smile.risorius by-hand.png --basis sculpted"),
    ),
    Command(
        "calibrate",
        "compare the solved fields with measured expressions",
        of_calibrate,
        ("measured.npz --report-only", "measured.npz -o report.json", "measured.npz --hold-out", "smile.risorius"),
        MEASURED,
    ),
    Command("edit", "open the editor", of_edit, ("", "smile.risorius")),
)
"""Everything that the command line can do."""

"""Run one command; whatever goes wrong becomes one sentence and an exit status."""

from __future__ import annotations

import os
import sys
from argparse import Namespace
from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path

from app.cli import animating, commands
from app.cli.calibrate import calibrate
from app.cli.export import export
from app.cli.parser import parser
from app.cli.screen import Screen
from facemodel.errors import RisoriusError
from facemodel.solve import Cancelled

FAILED = 1
INTERRUPTED = 130
"""128 and the number of SIGINT, as shells count."""

PROJECT_SUFFIX = ".risorius"


def main(arguments: Sequence[str], screen: Screen) -> int:
    """Run a command and return its exit status: 0, 1 for a failure, 2 for a call that makes no sense.

    Parameters
    ----------
    arguments : the words after ``risorius``; a project alone is opened in the editor
    screen : what draws
    """
    words = list(arguments)
    if len(words) == 1 and Path(words[0]).suffix == PROJECT_SUFFIX:
        words = ["edit", *words]
    known: dict[str, Callable[[Namespace], int]] = {
        "new": commands.new,
        "solve": commands.solve,
        "info": commands.info,
        "render": partial(commands.render, screen=screen),
        "export": export,
        "animate": partial(animating.animate, screen=screen),
        "demo": partial(animating.demo, screen=screen),
        "gallery": partial(commands.gallery, screen=screen),
        "calibrate": calibrate,
        "edit": partial(commands.edit, screen=screen),
    }
    try:
        asked = parser(known).parse_args(words)
    except SystemExit as end:
        return int(end.code or 0)
    try:
        status = int(asked.run(asked))
        sys.stdout.flush()
        return status
    except RisoriusError as error:
        return _fail(str(error))
    except MemoryError:
        return _fail("There is not enough memory for this; close other programs or lower the density.")
    except (KeyboardInterrupt, Cancelled):
        print("risorius: stopped", file=sys.stderr)
        return INTERRUPTED
    except BrokenPipeError:
        # Whoever read the output has enough; Python must not try to flush it again when it ends.
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())
        return FAILED


def _fail(sentence: str) -> int:
    print(f"risorius: {' '.join(sentence.split())}", file=sys.stderr)
    return FAILED

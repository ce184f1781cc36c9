"""Entry point: joins the command line with what draws.

Qt and VTK take seconds to load and need system libraries that a server may lack, so this module imports neither: each
function imports what it runs, which is the one place in the house where an import stands inside a function.
"""

from __future__ import annotations

import ctypes
import os
import sys
from collections.abc import Iterator, Sequence, Set
from io import TextIOWrapper
from pathlib import Path

from app.cli import Screen
from app.cli import main as run_command
from app.film import Film
from app.view_state import ViewName
from facemodel.actions import Expression
from facemodel.animation.take import Take
from facemodel.errors import RisoriusError
from facemodel.io.film.reel import Picture
from facemodel.project import Project
from facemodel.solve import Solution

LIBRARIES = "libgl1 libegl1 libglib2.0-0 libdbus-1-3 libfontconfig1 libxkbcommon-x11-0 libxcb-cursor0"


class ScreenError(RisoriusError):
    """There is nothing to draw on, or a library for drawing is missing."""


def main(arguments: Sequence[str] | None = None) -> int:
    """Run the command line and return its exit status."""
    for stream in (sys.stdout, sys.stderr):
        if isinstance(stream, TextIOWrapper):
            stream.reconfigure(errors="replace")  # an old code page must not turn a sentence into a crash
    screen = Screen(render=render, gallery=gallery, edit=edit, frames=frames, displays=display_answers)
    return run_command(sys.argv[1:] if arguments is None else arguments, screen)


def render(
    project: Project,
    solution: Solution,
    expression: Expression,
    path: Path,
    view: ViewName,
    size: tuple[int, int],
    show: Set[str],
    linear: bool = False,
) -> None:
    """Draw one picture, see `ui.headless.render_to_file`."""
    try:
        from ui.headless import render_to_file
    except ImportError as error:
        raise missing_library(error) from error
    render_to_file(project, solution, expression, path, view, size, show, linear=linear)


def gallery(project: Project, solution: Solution, path: Path) -> None:
    """Draw the sheet of all action units and emotions, see `ui.headless.gallery_to_file`."""
    try:
        from ui.headless import gallery_to_file
    except ImportError as error:
        raise missing_library(error) from error
    gallery_to_file(project, solution, path)


def frames(take: Take, solution: Solution, film: Film) -> Iterator[Picture]:
    """Draw the frames of a film, see `ui.headless.film_frames`."""
    try:
        from ui.headless import film_frames
    except ImportError as error:
        raise missing_library(error) from error
    return film_frames(take, solution, film)


def edit(path: Path | None, project: Project | None = None) -> int:
    """Open the editor, see `ui.window.main.run`."""
    if not display_answers():
        raise ScreenError(
            "There is no display for the editor; start it on a desktop, or use the commands that need none "
            "(risorius --help)."
        )
    try:
        from ui.window.main import run
    except ImportError as error:
        raise missing_library(error) from error
    return run(path, project)


def display_answers() -> bool:
    """Whether Qt will find a display; it ends the whole program when it finds none."""
    if not sys.platform.startswith("linux") or os.environ.get("QT_QPA_PLATFORM"):
        return True
    wayland = os.environ.get("WAYLAND_DISPLAY")
    if wayland and Path(os.environ.get("XDG_RUNTIME_DIR", "/"), wayland).exists():
        return True
    if not os.environ.get("DISPLAY"):
        return False
    try:
        xlib = ctypes.CDLL("libX11.so.6")
    except OSError:
        return False
    xlib.XOpenDisplay.restype = ctypes.c_void_p
    xlib.XCloseDisplay.argtypes = [ctypes.c_void_p]
    display = xlib.XOpenDisplay(None)
    if display:
        xlib.XCloseDisplay(display)
    return bool(display)


def missing_library(error: ImportError) -> ScreenError:
    """What to tell a user when Qt or VTK cannot be loaded."""
    return ScreenError(
        f"Drawing is not possible here, a library is missing ({error}); "
        f"on Debian and Ubuntu install {LIBRARIES}, elsewhere reinstall Risorius."
    )


if __name__ == "__main__":
    sys.exit(main())

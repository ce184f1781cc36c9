"""One expression as a picture."""

from __future__ import annotations

from collections.abc import Set
from pathlib import Path

from PIL import Image

from app.view_state import ViewState
from facemodel.actions import Expression
from facemodel.errors import UnknownNameError
from facemodel.io.disk import checked_target, replacing
from facemodel.project import Project
from facemodel.solve import Solution
from ui.headless.stage import stage
from ui.viewport.camera import DIRECTIONS
from ui.viewport.surface import ByteArray

SHOWN = ("skull", "muscles", "forces", "supports", "wireframe", "influence")
"""What can be drawn with the skin."""
SIZE = (1280, 960)
LARGEST = 8192
"""Pixels per side; twice that is what graphics drivers take at most."""


def render_image(
    project: Project,
    solution: Solution,
    expression: Expression,
    view: str = "front",
    size: tuple[int, int] = SIZE,
    show: Set[str] = frozenset(),
    muscle: str = "",
    theme: str = "dark",
    linear: bool = False,
) -> ByteArray:
    """Draw an expression.

    Parameters
    ----------
    project, solution : the face and its displacement fields
    expression : weights by field name
    view : ``front``, ``left``, ``right``, ``three-quarter`` or ``top``
    size : width and height in pixels
    show : any of `SHOWN`
    muscle : key of the muscle whose influence is shown
    theme : ``dark`` or ``light`` backdrop
    linear : draw the pure linear sum of the fields

    Returns
    -------
    (height, width, 3) uint8, the first row on top

    Raises
    ------
    UnknownNameError
        If there is no such view, or nothing of that name can be shown.
    ValueError
        If the size is not within 1 and `LARGEST`.
    """
    _check(view, size, show)
    with stage(size, theme) as made:
        made.scene.apply(ViewState(view=view, muscle=muscle, linear=linear, **dict.fromkeys(show, True)))
        made.scene.show(project, solution)
        made.scene.pose(expression)
        made.scene.look_from(view)
        return made.picture()


def render_to_file(
    project: Project,
    solution: Solution,
    expression: Expression,
    path: Path,
    view: str = "front",
    size: tuple[int, int] = SIZE,
    show: Set[str] = frozenset(),
    muscle: str = "",
    theme: str = "dark",
    linear: bool = False,
) -> None:
    """Draw an expression into a PNG file; the parameters are those of `render_image`.

    Raises
    ------
    ProjectError
        If the file cannot be written.
    UnknownNameError
        If there is no such view, or nothing of that name can be shown.
    """
    checked_target(path)
    write_png(render_image(project, solution, expression, view, size, show, muscle, theme, linear), path)


def write_png(image: ByteArray, path: Path) -> None:
    """Write a picture (h, w, 3) uint8; a failed write leaves the old file.

    Raises
    ------
    ProjectError
        If the file cannot be written.
    """
    with replacing(path) as stream:
        Image.fromarray(image).save(stream, format="PNG", optimize=False)


def _check(view: str, size: tuple[int, int], show: Set[str]) -> None:
    if view not in DIRECTIONS:
        raise UnknownNameError(f"There is no view “{view}”; choose one of {', '.join(DIRECTIONS)}.")
    unknown = sorted(set(show) - set(SHOWN))
    if unknown:
        raise UnknownNameError(f"“{unknown[0]}” cannot be shown; choose from {', '.join(SHOWN)}.")
    if not all(1 <= side <= LARGEST for side in size):
        raise ValueError(f"A picture of {size[0]} x {size[1]} pixels cannot be drawn; each side is 1 to {LARGEST}.")

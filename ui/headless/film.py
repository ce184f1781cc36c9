"""The frames of a film, drawn without a window."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from app.film.film import Antialias, Film, FilmError
from facemodel.animation.take import Take
from facemodel.solve import Solution
from ui.headless.picture import LARGEST
from ui.headless.stage import Stage, stage
from ui.viewport.camera import DIRECTIONS, face_frame, look_along, zoom
from ui.viewport.surface import ByteArray

FINER: Mapping[Antialias, int] = {"off": 1, "fine": 2, "finest": 3}
"""How many times as wide and high every pixel is drawn before it is averaged.

Samples at the edges of surfaces, which single pictures have besides, cost software GL more than that and show less.
"""

NEARER = 1.2
"""A film of the face alone comes nearer than the whole face allows, until the edge of the neck is out of it; not where
it is higher than wide, and the cheeks would go first."""

LARGEST_DRAWN = 2 * LARGEST
"""Pixels per side that graphics drivers draw at most."""


def film_frames(take: Take, solution: Solution, film: Film) -> Iterator[ByteArray]:
    """Draw the frames of a take one after the other, (height, width, 3) uint8, first row on top.

    Raises
    ------
    FilmError
        If the driver cannot draw pictures as large as that.
    """
    finer = FINER[film.antialias]
    if max(film.size) * finer > LARGEST_DRAWN:
        width, height = film.size
        raise FilmError(
            f"A film of {width}x{height} pixels with antialiasing “{film.antialias}” is too large to be drawn; "
            f"choose a side of at most {LARGEST_DRAWN // finer} pixels, or less antialiasing."
        )
    with stage(film.size, film.theme, samples=0, finer=finer) as made:
        made.scene.show(take.project, solution)
        _look(made, take, film)
        for frame in range(len(take)):
            _pose(made, take, frame)
            yield made.picture()
            if film.turns:
                # The head is seen to turn to its left: the camera goes round it to the right.
                made.scene.turn(-360.0 * film.turns / len(take))


def _pose(made: Stage, take: Take, frame: int) -> None:
    if made.scene.figure is not None:
        made.scene.figure.posed.turned = take.rigid(frame)
    made.scene.pose(take.expression(frame))


def _look(made: Stage, take: Take, film: Film) -> None:
    if not film.close:
        made.scene.look_from(film.view)
        return
    width, height = film.size
    camera = made.scene.renderer.GetActiveCamera()
    look_along(camera, face_frame(take.project.face), *DIRECTIONS[film.view], width / height)
    if width >= height:
        zoom(camera, NEARER)

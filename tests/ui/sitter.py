"""Who sits for the pictures: the default face, solved once for all tests."""

from functools import cache

import numpy as np

from facemodel.actions import expand
from facemodel.cache import solve_cached
from facemodel.project import Project
from facemodel.projects import new_project
from facemodel.solve import Solution
from ui.headless.stage import Stage
from ui.viewport.surface import ByteArray

SIZE = (360, 420)
SMILE = {"12": 1.0, "6": 0.6}
OPEN = {"27": 1.0}


@cache
def sitter() -> tuple[Project, Solution]:
    project = new_project()
    return project, solve_cached(project)


@cache
def studio() -> Stage:
    """A stage on which the sitter is shown; a test that changes what is shown puts it back."""
    stage = Stage(SIZE, samples=0)
    stage.scene.show(*sitter())
    return stage


def weights(**by_name: float) -> dict[str, float]:
    """Weights by field; ``au12=1`` is action unit 12 on both sides."""
    project, _ = sitter()
    return expand({name.removeprefix("au"): weight for name, weight in by_name.items()}, project.units)


def pixel_of(place: np.ndarray) -> tuple[int, int]:
    """Row and column of the studio's picture where a place of the head is seen."""
    renderer = studio().scene.renderer
    renderer.SetWorldPoint(*place, 1.0)
    renderer.WorldToDisplay()
    x, y, _ = renderer.GetDisplayPoint()
    finer = renderer.GetSize()[1] / SIZE[1]
    return round(SIZE[1] - y / finer), round(x / finer)


def around(picture: ByteArray, place: np.ndarray, reach: int) -> np.ndarray:
    """The pixels of a picture about a place of the head, as floats 0..1."""
    row, column = pixel_of(place)
    return picture[row - reach : row + reach + 1, column - reach : column + reach + 1] / 255.0

"""What a film is made of, whatever its format."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Protocol

import numpy as np
from numpy.typing import NDArray

from facemodel.animation.sound import Sound

Picture = NDArray[np.uint8]
"""(height, width, 3), sRGB, first row on top."""


@dataclass(frozen=True, eq=False)
class Reel:
    """A film before its pictures.

    Attributes
    ----------
    size : width and height in pixels
    rate : pictures per second
    frames : how many pictures there will be
    sound : from the first picture on; none for a silent film
    title : written into the file
    """

    size: tuple[int, int]
    rate: float
    frames: int
    sound: Sound | None = None
    title: str = ""


class FilmWriter(Protocol):
    """Takes pictures."""

    def add(self, picture: Picture) -> None:
        """Take the next picture."""

"""A film as numbered PNG files, for programs that cut and composite."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from PIL import Image

from facemodel.io.film.reel import Picture

EFFORT = 3
"""Compression of PNG, 0 to 9; more takes longer than drawing the picture and saves little."""


class PictureWriter:
    """Writes pictures.

    Parameters
    ----------
    place : where the picture of a number, from 1, is to be written
    """

    def __init__(self, place: Callable[[int], Path]) -> None:
        self._place = place
        self._count = 0

    def add(self, picture: Picture) -> None:
        """Take the next picture."""
        self._count += 1
        Image.fromarray(picture).save(self._place(self._count), format="PNG", compress_level=EFFORT)

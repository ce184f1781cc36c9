"""What a film is to be like."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass
from typing import Literal

from app.view_state import ViewName
from facemodel.animation.take import Take, take
from facemodel.errors import RisoriusError
from facemodel.project import Project

Antialias = Literal["off", "fine", "finest"]
Theme = Literal["dark", "light"]

ANTIALIAS: Mapping[Antialias, str] = {
    "off": "Off, quickest",
    "fine": "Fine, 4 samples",
    "finest": "Finest, 9 samples",
}
"""How the pixels of a film are smoothed, in words."""


class FilmError(RisoriusError):
    """A film cannot be made as it was asked for."""


@dataclass(frozen=True)
class Film:
    """A film before it is made.

    Attributes
    ----------
    size : width and height in pixels
    rate : frames per second; the animation's own if not given
    span : from when to when, seconds of the clip; what is played if not given
    view : where one looks from
    close : show the face alone, without crown and neck
    turns : how often the head turns round in the film, as on a turntable; below zero the other way
    antialias : how pixels are smoothed
    audible : with the sound of the animation
    theme : of the backdrop
    """

    size: tuple[int, int] = (1280, 720)
    rate: float | None = None
    span: tuple[float, float] | None = None
    view: ViewName = "front"
    close: bool = False
    turns: float = 0.0
    antialias: Antialias = "fine"
    audible: bool = True
    theme: Theme = "dark"

    def take(self, project: Project) -> Take:
        """The frames of a project that it shows; the end of the span is where the last frame ends.

        Raises
        ------
        RisoriusError
            If there is nothing to see, or too much.
        """
        animation = project.animation
        start, end = self.span or (animation.start, animation.end)
        if not animation.moves and not self.turns:
            raise FilmError(
                "Nothing moves in this project: it has no keys, events or speech; animate it, or film a turntable."
            )
        if not end > start:
            raise FilmError(f"A film from {start:g} s to {end:g} s has no frame; let it end after its begin.")
        rate = self.rate or animation.rate
        return take(project, rate, (start, max(start, end - 1.0 / rate)))


DEFAULT_FILM = Film()

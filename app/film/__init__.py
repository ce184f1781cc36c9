"""Films of an animation, and other exports of it: what is asked for, and how it is made; what draws is handed in."""

from app.film.film import ANTIALIAS, DEFAULT_FILM, Antialias, Film, FilmError
from app.film.shoot import Draw, shoot

__all__ = ["ANTIALIAS", "DEFAULT_FILM", "Antialias", "Draw", "Film", "FilmError", "shoot"]

"""Films: pictures one after the other become a video with sound, or numbered PNG files."""

from __future__ import annotations

from facemodel.io.film.formats import FILMS, FilmFormat, film_format_of, filming
from facemodel.io.film.reel import FilmWriter, Picture, Reel

__all__ = ["FILMS", "FilmFormat", "FilmWriter", "Picture", "Reel", "film_format_of", "filming"]

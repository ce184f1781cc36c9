"""The formats of films, by the suffix of the file."""

from __future__ import annotations

from collections.abc import Iterator, Mapping
from contextlib import contextmanager
from dataclasses import dataclass
from pathlib import Path

from facemodel.errors import ProjectError
from facemodel.io.disk import replacing_file
from facemodel.io.film.pictures import PictureWriter
from facemodel.io.film.reel import FilmWriter, Reel
from facemodel.io.film.video import MP4, WEBM, Codecs, video
from facemodel.io.sequence import replacing_sequence


@dataclass(frozen=True)
class FilmFormat:
    """A format.

    Attributes
    ----------
    title : what people call it
    holds : what ends up in the file
    codecs : of a video; none for numbered pictures
    """

    title: str
    holds: str
    codecs: Codecs | None

    @property
    def sounds(self) -> bool:
        """Whether it holds sound."""
        return self.codecs is not None


FILMS: Mapping[str, FilmFormat] = {
    ".mp4": FilmFormat("MP4 video", "H.264 and AAC, which everything plays", MP4),
    ".webm": FilmFormat("WebM video", "VP9 and Opus, free of patents, for the web", WEBM),
    ".png": FilmFormat("PNG pictures", "one numbered picture per frame, without sound", None),
}
"""By suffix."""


def film_format_of(path: Path) -> FilmFormat:
    """The format that a file's name asks for.

    Raises
    ------
    ProjectError
        If there is none for its suffix.
    """
    found = FILMS.get(path.suffix.lower())
    if found is None:
        *most, last = FILMS
        raise ProjectError(
            f"“{path}” cannot be filmed: its name does not end in a known format; let it end in "
            f"{', '.join(most)} or {last}."
        )
    return found


@contextmanager
def filming(path: Path, reel: Reel) -> Iterator[FilmWriter]:
    """Takes pictures one by one; the film is at ``path`` when all are taken, and not before.

    Raises
    ------
    ProjectError
        If the suffix is unknown, the file cannot be written or no library is there that can encode it; a previous
        film stays as it was.
    """
    chosen = film_format_of(path)
    if chosen.codecs is None:
        with replacing_sequence(path, reel.frames) as place:
            yield PictureWriter(place)
    else:
        with replacing_file(path) as fresh, video(fresh, path, reel, chosen.codecs) as writer:
            yield writer

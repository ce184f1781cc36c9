"""Exports of the animation for scripts: what the export page does, waited for."""

from __future__ import annotations

from collections.abc import Collection, Mapping
from dataclasses import fields
from pathlib import Path
from typing import Any, get_args

from app.film.elsewhere import Errand, run_errand
from app.film.film import ANTIALIAS, Film, Theme
from app.film.order import KINDS, Order, kind_of
from app.scripting.desk import ScriptDesk
from app.view_state import VIEW_TITLES
from facemodel.errors import FaceError, UnknownNameError
from facemodel.io.export import Asked
from facemodel.io.export.asked import Shaping

CHOICES: Mapping[str, Collection[str]] = {
    "view": tuple(VIEW_TITLES),
    "antialias": tuple(ANTIALIAS),
    "theme": get_args(Theme),
    "shaping": get_args(Shaping),
}
"""Words of which one is chosen."""


class Exporting:
    """Writes what is played.

    Parameters
    ----------
    desk : what the script works on
    """

    def __init__(self, desk: ScriptDesk) -> None:
        self._desk = desk

    def export_animation(self, path: str, kind: str = "", **asked: Any) -> str:
        """Film the animation, or write it as a model, meshes or weights, and say what was made.

        The file's suffix says what it is, or ``kind``, such as ``live-link``.  Settings are ``rate`` and ``span``, for
        films ``size``, ``view``, ``close``, ``turns``, ``antialias``, ``audible`` and ``theme``, for models ``shaping``
        and ``most``.  A relative path counts from where the program was started.
        """
        if not self._desk.solved_as_it_is:
            raise FaceError("The face has to be solved anew first; let this script end, and export in the next one.")
        out = Path(path).expanduser().absolute()
        if kind:
            _one_of("kind", kind, KINDS)
        known = {each.name for each in (*fields(Film), *fields(Asked))} - {"animated"}
        for name, value in asked.items():
            _one_of("setting", name, sorted(known))
            if name in CHOICES:
                _one_of(name, value, CHOICES[name])
        film, model = Film(**_of(Film, asked)), Asked(**_of(Asked, asked))
        home = self._desk.document.path
        folder = None if home is None else home.absolute().parent
        order = Order(out, kind or kind_of(out).key, film, model)
        return run_errand(Errand(order, self._desk.project, self._desk.solved(), folder))


def _of(made: type, asked: Mapping[str, Any]) -> dict[str, Any]:
    """The settings that a value has."""
    own = {each.name for each in fields(made)}
    return {name: value for name, value in asked.items() if name in own}


def _one_of(what: str, word: object, known: Collection[str]) -> None:
    """See that a word is known.

    Raises
    ------
    UnknownNameError
        If it is not.
    """
    if word not in known:
        raise UnknownNameError(f"There is no {what} “{word}”; choose one of {', '.join(known)}.")

"""An animation that is to be exported: into which file, and how."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import asdict, dataclass, fields
from pathlib import Path
from typing import Any

from app.film.film import Film
from app.film.shoot import Draw, shoot
from facemodel.io.export import EXPORTS, Asked, export_of, export_project, export_sequence
from facemodel.io.film import FILMS
from facemodel.project import Project
from facemodel.solution import Progress, Solution, silent


@dataclass(frozen=True)
class OrderKind:
    """A format in which an animation can be ordered.

    Attributes
    ----------
    suffix : of the file
    title : what people call it
    holds : what ends up in it
    """

    suffix: str
    title: str
    holds: str

    @property
    def films(self) -> bool:
        """Whether it is pictures."""
        return self.suffix in FILMS

    @property
    def shapes(self) -> bool:
        """Whether it is a model with shapes."""
        return not self.films and EXPORTS[self.suffix].animates


KINDS: Mapping[str, OrderKind] = {
    kind.suffix: kind
    for kind in (
        *(OrderKind(suffix, film.title, film.holds) for suffix, film in FILMS.items()),
        OrderKind(".glb", "glTF model", "morph targets with animated weights; head, jaw and eyes as nodes"),
        OrderKind(".usdc", "USD model", "blend shapes on a skeleton of head, jaw and eyes, with their animation"),
        OrderKind(".usda", "USD model as text", "the same as text that people can read"),
        OrderKind(".obj", "OBJ meshes", "one numbered file per frame"),
        OrderKind(".ply", "PLY meshes", "one numbered file per frame, with colours"),
    )
}
"""By suffix, in the order in which they are offered."""


@dataclass(frozen=True)
class Order:
    """What somebody wants.

    Attributes
    ----------
    out : the file to write; its suffix is one of `KINDS`
    film : how it is filmed, if it is a film
    asked : how it is written, if it is a model or meshes
    """

    out: Path
    film: Film
    asked: Asked

    def as_json(self) -> dict[str, Any]:
        """The order for another process."""
        return {"out": str(self.out), "film": asdict(self.film), "asked": asdict(self.asked)}


def order_of(data: Mapping[str, Any]) -> Order:
    """The order that `Order.as_json` told."""
    film, asked = (_tuples(data[name]) for name in ("film", "asked"))
    known = {field.name for field in fields(Film)}, {field.name for field in fields(Asked)}
    assert set(film) == known[0]
    assert set(asked) == known[1]
    return Order(Path(data["out"]), Film(**film), Asked(**asked))


def _tuples(data: Mapping[str, Any]) -> dict[str, Any]:
    """JSON knows no tuples, and lists cannot be compared with them."""
    return {name: tuple(value) if isinstance(value, list) else value for name, value in data.items()}


def fulfil(
    order: Order,
    project: Project,
    solution: Solution,
    draw: Draw,
    folder: Path | None = None,
    progress: Progress = silent,
) -> str:
    """Do what was ordered, whole or not at all.

    Parameters
    ----------
    order : what is wanted
    project, solution : what is exported
    draw : draws the frames of a film
    folder : of the project's file, from which the path of its sound counts
    progress : told about every frame; may raise `facemodel.solution.Cancelled`

    Returns
    -------
    What was made, for people.

    Raises
    ------
    RisoriusError
        If it cannot be done; what was there before stays.
    """
    if order.out.suffix.lower() in FILMS:
        take = order.film.take(project)
        shoot(take, solution, order.film, order.out, draw, folder, progress)
        return f"{len(take):,} frames, {take.duration:.1f} s"
    if export_of(order.out).animates:
        return export_project(project, solution, order.out, order.asked, progress)
    return f"{export_sequence(project, solution, order.out, order.asked, progress):,} numbered files"

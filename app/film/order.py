"""An animation that is to be exported: into which file, and how."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import asdict, dataclass, fields
from pathlib import Path
from typing import Any

from app.film.film import Film, FilmError
from app.film.shoot import Draw, shoot
from facemodel.animation.take import Take
from facemodel.io.export import EXPORTS, Asked, export_project, export_sequence
from facemodel.io.film import FILMS
from facemodel.io.weights.writing import WEIGHT_EXPORTS, Animated, export_weights
from facemodel.project import Project
from facemodel.solution import Progress, Solution, silent


@dataclass(frozen=True)
class OrderKind:
    """A format in which an animation can be ordered.

    Attributes
    ----------
    key : its name: a suffix, or that of weights
    suffix : of the file
    title : what people call it
    holds : what ends up in it
    """

    key: str
    suffix: str
    title: str
    holds: str

    @property
    def group(self) -> tuple[bool, bool, bool]:
        """Equal for those that people will look for in one place: films, models, meshes, weights."""
        return self.films, self.shapes, self.numbered and not self.films

    @property
    def films(self) -> bool:
        """Whether it is pictures."""
        return self.key in FILMS

    @property
    def shapes(self) -> bool:
        """Whether it is a model with shapes."""
        return self.key in EXPORTS and EXPORTS[self.key].animates

    @property
    def numbered(self) -> bool:
        """Whether it is one file for each frame."""
        if self.films:
            return FILMS[self.key].codecs is None
        return self.key in EXPORTS and not EXPORTS[self.key].animates


KINDS: Mapping[str, OrderKind] = {
    kind.key: kind
    for kind in (
        *(OrderKind(suffix, suffix, film.title, film.holds) for suffix, film in FILMS.items()),
        OrderKind(".glb", ".glb", "glTF model", "morph targets with animated weights; head, jaw and eyes as nodes"),
        OrderKind(
            ".usdc", ".usdc", "USD model", "blend shapes on a skeleton of head, jaw and eyes, with their animation"
        ),
        OrderKind(".usda", ".usda", "USD model as text", "the same as text that people can read"),
        OrderKind(".obj", ".obj", "OBJ meshes", "one numbered file per frame"),
        OrderKind(".ply", ".ply", "PLY meshes", "one numbered file per frame, with colours"),
        *(OrderKind(key, each.suffix, each.title, each.holds) for key, each in WEIGHT_EXPORTS.items()),
    )
}
"""By name, in the order in which they are offered."""


def kind_of(path: Path) -> OrderKind:
    """The first format whose files have the suffix of this one.

    Raises
    ------
    FilmError
        If there is none.
    """
    found = next((kind for kind in KINDS.values() if kind.suffix == path.suffix.lower()), None)
    if found is None:
        known = ", ".join(dict.fromkeys(kind.suffix for kind in KINDS.values()))
        raise FilmError(f"“{path}” cannot be written: animations are exported to {known} files.")
    return found


@dataclass(frozen=True)
class Order:
    """What somebody wants.

    Attributes
    ----------
    out : the file to write
    kind : its format, one of `KINDS`
    film : how it is filmed, if it is a film
    asked : how it is written, if it is a model, meshes or weights
    """

    out: Path
    kind: str
    film: Film
    asked: Asked

    def as_json(self) -> dict[str, Any]:
        """The order for another process."""
        return {"out": str(self.out), "kind": self.kind, "film": asdict(self.film), "asked": asdict(self.asked)}


def order_of(data: Mapping[str, Any]) -> Order:
    """The order that `Order.as_json` told."""
    film, asked = (_tuples(data[name]) for name in ("film", "asked"))
    known = {field.name for field in fields(Film)}, {field.name for field in fields(Asked)}
    assert set(film) == known[0]
    assert set(asked) == known[1]
    return Order(Path(data["out"]), str(data["kind"]), Film(**film), Asked(**asked))


def _tuples(data: Mapping[str, Any]) -> dict[str, Any]:
    """JSON knows no tuples, and lists cannot be compared with them."""
    return {name: tuple(value) if isinstance(value, list) else value for name, value in data.items()}


def fulfil(
    order: Order,
    project: Project,
    solve: Callable[[], Solution],
    draw: Draw,
    folder: Path | None = None,
    progress: Progress = silent,
) -> str:
    """Do what was ordered, whole or not at all.

    Parameters
    ----------
    order : what is wanted
    project : what is exported
    solve : gives its solution; not asked where there is nothing to export, nor for what needs none
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
    kind = KINDS[order.kind]
    if kind.films:
        take = order.film.take(project)
        shoot(take, solve(), order.film, order.out, draw, folder, progress)
        return f"{counted(len(take), 'frame')}, {take.duration:.2f} s"
    clip = order.asked.take(project)
    if clip is None:
        raise FilmError(
            f"“{order.out}” cannot be written: nothing moves in this project; it has no keys, events or speech."
        )
    if kind.key in WEIGHT_EXPORTS:
        return _weights(order, clip, solve)
    if kind.shapes:
        return export_project(project, solve(), order.out, order.asked, progress)
    return counted(export_sequence(project, solve(), order.out, order.asked, progress), "numbered file")


def _weights(order: Order, clip: Take, solve: Callable[[], Solution]) -> str:
    """Write the weights frame by frame."""
    chosen, project = WEIGHT_EXPORTS[order.kind], clip.project
    basis = solve().basis if chosen.needs_basis else None
    animated = Animated(clip.sampled, project.units, project.face, basis, order.out.stem)
    export_weights(animated, order.out, order.kind)
    return f"{counted(len(clip), 'frame')} at {clip.rate:g} a second, {chosen.holds}"


def counted(number: int, thing: str) -> str:
    """So many of a thing, in words."""
    return f"{number:,} {thing}{'' if number == 1 else 's'}"

"""The formats of models, by the suffix of the file."""

from __future__ import annotations

from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import BinaryIO, Protocol

from facemodel.errors import ProjectError
from facemodel.io.export.asked import AS_IT_IS, Asked
from facemodel.io.export.glb import write_glb
from facemodel.io.export.npz import write_npz
from facemodel.io.export.obj import write_obj, write_obj_pieces
from facemodel.io.export.pieces import Piece
from facemodel.io.export.ply import write_ply, write_ply_pieces
from facemodel.io.export.usd import write_usda, write_usdc
from facemodel.project import Project
from facemodel.solution import Progress, silent
from facemodel.solve import Solution

Pieces = Callable[[str, Iterable[Piece], BinaryIO], None]
"""Writes the pieces of one posed face, under a title."""


class Write(Protocol):
    """Writes a project to a stream."""

    def __call__(
        self,
        project: Project,
        solution: Solution,
        stream: BinaryIO,
        asked: Asked = AS_IT_IS,
        progress: Progress = silent,
    ) -> str:
        """Write it, and say what was written beside what the format always holds; empty if nothing."""


@dataclass(frozen=True)
class Export:
    """A format.

    Attributes
    ----------
    title : what people call it
    holds : what ends up in the file of a still face
    write : writes a project to a stream
    animates : whether one file holds an animation
    frame : writes one frame of a sequence; none where a sequence makes no sense
    """

    title: str
    holds: str
    write: Write
    animates: bool = False
    frame: Pieces | None = None


def _plain(write: Callable[[Project, Solution, BinaryIO], None]) -> Write:
    """A format that holds one moment, of which nothing else can be asked."""

    def written(
        project: Project,
        solution: Solution,
        stream: BinaryIO,
        asked: Asked = AS_IT_IS,
        progress: Progress = silent,
    ) -> str:
        write(project, solution, stream)
        return ""

    return written


EXPORTS: Mapping[str, Export] = {
    ".glb": Export(
        "glTF binary", "the whole head at rest with one morph target per action unit, in metres", write_glb, True
    ),
    ".usdc": Export(
        "USD binary", "the whole head at rest with one blend shape per action unit, in metres", write_usdc, True
    ),
    ".usda": Export("USD text", "the same as text that people can read", write_usda, True),
    ".npz": Export("NumPy arrays", "the neutral skin and every displacement field, in millimetres", _plain(write_npz)),
    ".obj": Export(
        "Wavefront OBJ", "the head with its expression, in millimetres", _plain(write_obj), frame=write_obj_pieces
    ),
    ".ply": Export(
        "Binary PLY",
        "the head with its expression as one coloured mesh, in millimetres",
        _plain(write_ply),
        frame=write_ply_pieces,
    ),
}
"""By suffix."""


def export_of(path: Path) -> Export:
    """The format that a file's name asks for.

    Raises
    ------
    ProjectError
        If there is none for its suffix.
    """
    found = EXPORTS.get(path.suffix.lower())
    if found is None:
        *most, last = EXPORTS
        raise ProjectError(
            f"“{path}” cannot be exported: its name does not end in a known format; "
            f"let it end in {', '.join(most)} or {last}."
        )
    return found

"""Exports: a solved project in the formats of other programs."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from pathlib import Path
from typing import BinaryIO

from facemodel.errors import ProjectError
from facemodel.io.disk import replacing
from facemodel.io.export.glb import write_glb
from facemodel.io.export.npz import write_npz
from facemodel.io.export.obj import write_obj
from facemodel.io.export.ply import write_ply
from facemodel.project import Project
from facemodel.solve import Solution

__all__ = ["EXPORTS", "Export", "export_of", "export_project"]


@dataclass(frozen=True)
class Export:
    """A format.

    Attributes
    ----------
    title : what people call it
    holds : what ends up in the file
    write : writes it to a stream
    """

    title: str
    holds: str
    write: Callable[[Project, Solution, BinaryIO], None]


EXPORTS: Mapping[str, Export] = {
    ".glb": Export("glTF binary", "the whole head with one morph target per action unit, in metres", write_glb),
    ".npz": Export(
        "NumPy arrays", "the skin at rest and posed, and every displacement field, in millimetres", write_npz
    ),
    ".obj": Export("Wavefront OBJ", "the head with its expression, in millimetres", write_obj),
    ".ply": Export("Binary PLY", "the head with its expression as one coloured mesh, in millimetres", write_ply),
}
"""The formats by the suffix of the file."""


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


def export_project(project: Project, solution: Solution, path: Path) -> None:
    """Write a solved project in the format of the file's suffix, whole or not at all.

    Raises
    ------
    ProjectError
        If the suffix is unknown or the file cannot be written; a previous file stays as it was.
    """
    chosen = export_of(path)
    with replacing(path) as stream:
        chosen.write(project, solution, stream)

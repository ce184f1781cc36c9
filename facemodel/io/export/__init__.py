"""Exports: a solved project in the formats of other programs."""

from __future__ import annotations

from pathlib import Path

from facemodel.io.disk import replacing
from facemodel.io.export.asked import AS_IT_IS, Asked
from facemodel.io.export.formats import EXPORTS, Export, export_of
from facemodel.io.export.sequence import export_sequence
from facemodel.project import Project
from facemodel.solution import Progress, silent
from facemodel.solve import Solution

__all__ = ["AS_IT_IS", "EXPORTS", "Asked", "Export", "export_of", "export_project", "export_sequence"]


def export_project(
    project: Project, solution: Solution, path: Path, asked: Asked = AS_IT_IS, progress: Progress = silent
) -> str:
    """Write a solved project in the format of the file's suffix, whole or not at all.

    Returns
    -------
    What was written, for people.

    Raises
    ------
    ProjectError
        If the suffix is unknown or the file cannot be written; a previous file stays as it was.
    """
    chosen = export_of(path)
    with replacing(path) as stream:
        said = chosen.write(project, solution, stream, asked, progress)
    return said or chosen.holds

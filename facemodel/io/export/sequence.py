"""An animation as one numbered file for each frame, for programs that read meshes and nothing else."""

from __future__ import annotations

from pathlib import Path

from facemodel.errors import ProjectError
from facemodel.io.export.asked import AS_IT_IS, Asked
from facemodel.io.export.formats import EXPORTS, export_of
from facemodel.io.export.pieces import posed_pieces
from facemodel.io.sequence import replacing_sequence
from facemodel.kinematics import rig_of
from facemodel.project import Project
from facemodel.solution import Progress, silent
from facemodel.solve import Solution
from facemodel.superposition import Superposition


def export_sequence(
    project: Project, solution: Solution, path: Path, asked: Asked = AS_IT_IS, progress: Progress = silent
) -> int:
    """Write every frame of a project's animation, ``smile.0001.obj`` and so on for ``smile.obj``; all or none.

    Returns
    -------
    How many files were written.

    Raises
    ------
    ProjectError
        If the format has no frames, nothing moves, or a file cannot be written; an earlier sequence stays as it was.
    """
    write = export_of(path).frame
    if write is None:
        able = " or ".join(suffix for suffix, each in EXPORTS.items() if each.frame is not None)
        raise ProjectError(
            f"“{path}” cannot be written as a sequence: one file of this format holds all frames; leave the sequence "
            f"out, or let the name end in {able}."
        )
    take = asked.take(project)
    if take is None:
        raise ProjectError(f"“{path}” cannot be written as a sequence: nothing moves in this project; animate it.")
    pose = Superposition(project.face, solution.basis, rig_of(project.units))
    with replacing_sequence(path, len(take)) as place:
        for frame in range(len(take)):
            progress(f"Writing frames, {frame + 1} of {len(take)}", frame / len(take))
            pose.turned = take.rigid(frame)
            pose.pose(take.expression(frame))
            with open(place(frame + 1), "xb") as stream:
                write(project.face.title, posed_pieces(pose), stream)
    return len(take)

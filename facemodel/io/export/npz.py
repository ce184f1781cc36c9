"""NumPy's own archive: the neutral skin and every displacement field, for whoever computes with them."""

from __future__ import annotations

from typing import BinaryIO

import numpy as np

from facemodel.io.export.pieces import pieces
from facemodel.io.export.targets import target_field, targets
from facemodel.project import Project
from facemodel.solve import Solution


def write_npz(project: Project, solution: Solution, stream: BinaryIO) -> None:
    """Write ``neutral`` (N, 3) float32, ``triangles`` (T, 3) int32, ``names`` (M,) and ``fields`` (M, N, 3) float32.

    Lengths are millimetres.  The N points are the whole drawn skin; a paired action unit has three fields, for
    example ``12``, ``12L`` and ``12R``.  ``posed`` (N, 3) float32 is the skin with the project's expression as it is
    seen: the weighted sum of the fields, with the arc of the jaw, with what lids and lips give way, and as the head is
    held.
    """
    display = solution.basis.display
    shapes = targets(project.units, solution.basis)
    fields = np.empty((len(shapes), len(display.points), 3), dtype=np.float32)
    for row, shape in enumerate(shapes):
        fields[row] = target_field(shape, solution.basis)
    np.savez(
        stream,
        neutral=display.points,
        triangles=display.triangles.astype(np.int32),
        names=np.array([shape.name for shape in shapes], dtype=np.str_),
        fields=fields,
        posed=next(pieces(project, solution.basis, project.expression)).positions,
    )

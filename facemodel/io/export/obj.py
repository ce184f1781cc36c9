"""Wavefront OBJ: the posed face as one named object for each of its meshes, in millimetres."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any, BinaryIO

import numpy as np
from numpy.typing import NDArray

from facemodel.io.export.pieces import Piece, pieces
from facemodel.project import Project
from facemodel.solve import Solution


def write_obj(project: Project, solution: Solution, stream: BinaryIO) -> None:
    """Write skin, eyes and parts posed with the project's expression; see `write_obj_pieces`."""
    write_obj_pieces(project.face.title, pieces(project, solution.basis, project.expression), stream)


def write_obj_pieces(title: str, posed: Iterable[Piece], stream: BinaryIO) -> None:
    """Write the pieces of a posed face.

    The format knows no transparency here, so the clear corneas, which would hide the irises, stay out.
    """
    stream.write(f"# {' '.join(title.split())}, posed with Risorius, millimetres\n".encode())
    points, textured = 1, 1
    for piece in posed:
        if piece.kind == "cornea":
            continue
        stream.write(_object(piece, points, textured).encode())
        points += len(piece.positions)
        textured += 0 if piece.uv is None else len(piece.uv)


def _object(piece: Piece, first: int, first_uv: int) -> str:
    """The text of one mesh; ``first`` and ``first_uv`` are its first indices in the file."""
    corner = piece.triangles + first
    columns = [corner, corner]
    if piece.uv is not None:
        columns.insert(1, piece.triangles + first_uv)
    face = " ".join(["%d//%d" if piece.uv is None else "%d/%d/%d"] * 3)
    return "".join(
        [
            f"o {'_'.join(piece.name.split())}\nusemtl {piece.kind}\n",
            _lines("v %.5f %.5f %.5f\n", piece.positions),
            "" if piece.uv is None else _lines("vt %.6f %.6f\n", piece.uv),
            _lines("vn %.5f %.5f %.5f\n", piece.normals),
            _lines(f"f {face}\n", np.stack(columns, axis=2)),
        ]
    )


def _lines(pattern: str, rows: NDArray[Any]) -> str:
    """One line per row, formatted in one go."""
    return (pattern * len(rows)) % tuple(rows.ravel().tolist())

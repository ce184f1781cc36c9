"""Binary PLY: the posed face as one mesh with normals and colours, in millimetres."""

from __future__ import annotations

from collections.abc import Iterable
from typing import BinaryIO

import numpy as np

from facemodel.io.export.pieces import Piece, pieces
from facemodel.project import Project
from facemodel.solve import Solution

VERTEX = np.dtype(
    [(name, "<f4") for name in ("x", "y", "z", "nx", "ny", "nz")]
    + [(name, "u1") for name in ("red", "green", "blue", "alpha")]
)
FACE = np.dtype([("count", "u1"), ("corners", "<i4", 3)])

HEADER = """ply
format binary_little_endian 1.0
comment {title}, posed with Risorius, millimetres
element vertex {points}
property float x
property float y
property float z
property float nx
property float ny
property float nz
property uchar red
property uchar green
property uchar blue
property uchar alpha
element face {faces}
property list uchar int vertex_indices
end_header
"""


def write_ply(project: Project, solution: Solution, stream: BinaryIO) -> None:
    """Write skin, eyes and parts posed with the project's expression; see `write_ply_pieces`."""
    write_ply_pieces(project.face.title, pieces(project, solution.basis, project.expression), stream)


def write_ply_pieces(title: str, posed: Iterable[Piece], stream: BinaryIO) -> None:
    """Write the pieces of a posed face as one mesh, without the clear corneas."""
    drawn = [piece for piece in posed if piece.kind != "cornea"]
    counts = [len(piece.positions) for piece in drawn]
    starts = np.cumsum([0, *counts[:-1]])
    vertices = np.empty(sum(counts), dtype=VERTEX)
    positions = np.concatenate([piece.positions for piece in drawn])
    normals = np.concatenate([piece.normals for piece in drawn])
    colours = np.round(255 * np.concatenate([piece.colours for piece in drawn]))
    for k, axis in enumerate("xyz"):
        vertices[axis] = positions[:, k]
        vertices[f"n{axis}"] = normals[:, k]
    for k, channel in enumerate(("red", "green", "blue", "alpha")):
        vertices[channel] = colours[:, k]
    corners = np.concatenate([piece.triangles + start for piece, start in zip(drawn, starts, strict=True)])
    faces = np.empty(len(corners), dtype=FACE)
    faces["count"] = 3
    faces["corners"] = corners
    plain = " ".join(title.split()).encode("ascii", "replace").decode()
    stream.write(HEADER.format(title=plain, points=len(vertices), faces=len(faces)).encode())
    stream.write(vertices.tobytes())
    stream.write(faces.tobytes())

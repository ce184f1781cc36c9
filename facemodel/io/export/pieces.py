"""A face taken apart into the meshes that are exported, posed with an expression."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace

import numpy as np
from scipy.spatial import cKDTree

from facemodel.actions import Expression
from facemodel.basis import Basis
from facemodel.eyeball import eyeball
from facemodel.face import Eye, Face, Part
from facemodel.io.export.appearance import APPEARANCES
from facemodel.kinematics import rig_of
from facemodel.mesh import Mesh
from facemodel.project import Project
from facemodel.superposition import Superposition
from fem.types import Float32Array, FloatArray, IntArray


@dataclass(frozen=True, eq=False)
class Piece:
    """One mesh of one material.

    Attributes
    ----------
    name : ``skin``, ``eye-left``, ``cornea-left``, or the name of a part
    kind : key of `APPEARANCES`
    positions, normals : (P, 3) float32, millimetres
    triangles : (T, 3) int
    colours : (P, 4) float 0..1, sRGB and opacity
    uv : (P, 2) float with v upwards, or None
    """

    name: str
    kind: str
    positions: Float32Array
    normals: Float32Array
    triangles: IntArray
    colours: FloatArray
    uv: FloatArray | None = None


def pieces(project: Project, basis: Basis, expression: Expression) -> Iterator[Piece]:
    """The skin, both eyes and all parts, in this order, as they are seen in an expression."""
    pose = Superposition(project.face, basis, rig_of(project.units))
    pose.pose(expression)
    yield from posed_pieces(pose)


def posed_pieces(pose: Superposition) -> Iterator[Piece]:
    """The pieces of a face as it is posed, with eyes and head as they stand."""
    head = pose.stance.head
    for piece in _upright(pose):
        yield piece if np.array_equal(head, np.eye(4)) else moved(piece, head)


def _upright(pose: Superposition) -> Iterator[Piece]:
    """The pieces of a head that is held upright, whatever it does else."""
    face, display = pose.face, pose.basis.display
    yield Piece(
        "skin",
        "skin",
        pose.points.copy(),
        pose.normals.copy(),
        display.triangles,
        plain_colours("skin", len(pose.points)),
        display_uv(face, pose.basis),
    )
    for eye, motion in zip(face.eyes, pose.stance.eyes, strict=True):
        for piece in eye_pieces(eye):
            yield piece if np.array_equal(motion, np.eye(4)) else moved(piece, motion)
    for part in face.parts:
        yield part_piece(part, face, pose.parts[part.name].copy())


def moved(piece: Piece, motion: FloatArray) -> Piece:
    """A piece moved rigidly by (4, 4)."""
    turn, shift = motion[:3, :3], motion[:3, 3]
    positions = (piece.positions @ turn.T + shift).astype(np.float32)
    return replace(piece, positions=positions, normals=(piece.normals @ turn.T).astype(np.float32))


def plain_colours(kind: str, count: int) -> FloatArray:
    """The colour of a kind for each of ``count`` points, opaque: (count, 4)."""
    return np.tile(np.array([*APPEARANCES[kind].colour, 1.0]), (count, 1))


def display_uv(face: Face, basis: Basis) -> FloatArray:
    """Texture coordinates (P, 2) of the drawn points, linear on each triangle of the skin."""
    display = basis.display
    corners = face.uv[face.skin.triangles[display.elements]]
    return np.asarray(np.einsum("pk,pkc->pc", display.barycentric, corners))


def eye_pieces(eye: Eye) -> Iterator[Piece]:
    """The coloured eyeball and its clear cornea."""
    whole = eyeball(eye)
    side = {"L": "left", "R": "right"}[eye.side]
    for name, (mesh, index) in (("eye", whole.opaque), ("cornea", whole.cornea)):
        yield Piece(
            f"{name}-{side}",
            name,
            mesh.positions.astype(np.float32),
            whole.normals[index].astype(np.float32),
            mesh.triangles,
            whole.colours[index],
        )


def part_piece(part: Part, face: Face, positions: Float32Array) -> Piece:
    """A part of a face with its points at ``positions`` (P, 3)."""
    colours = plain_colours(part.kind, len(positions))
    if part.kind == "lashes":
        colours[:, 3] = lash_opacity(part, face)
    normals = Mesh(positions.astype(np.float64), part.mesh.triangles).normals
    return Piece(
        part.name,
        part.kind,
        positions,
        normals.astype(np.float32),
        part.mesh.triangles,
        colours,
    )


def lash_opacity(part: Part, face: Face) -> FloatArray:
    """Opacity (P,) of a strip of lashes: dense at the lid margin, nothing at the tips, as hairs thin out."""
    margins = face.skin.positions[np.concatenate(face.skin.boundary_loops)]
    distance, _ = cKDTree(margins).query(part.mesh.positions)
    return np.asarray((1 - distance / distance.max()) ** 3)

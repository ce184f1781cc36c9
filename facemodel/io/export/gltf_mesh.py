"""Meshes and materials of a glTF file."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass

import numpy as np
from pygltflib import BLEND, OPAQUE, Attributes, Material, Mesh, PbrMetallicRoughness, Primitive

from facemodel.io.export.appearance import APPEARANCES, linear
from facemodel.io.export.gltf_buffer import GltfBuffer
from facemodel.io.export.performance import Shape
from facemodel.io.export.pieces import Piece
from fem.types import Float32Array

METRES = 0.001
UNSEEN = 1e-6
"""Metres: a thousandth of a millimetre of motion is left out, which halves the file."""
UNSEEN_TURN = 2e-3
"""Change of a unit normal (a tenth of a degree) that is left out."""


@dataclass(frozen=True)
class Morphs:
    """The morph targets of one mesh.

    Attributes
    ----------
    shapes : what they are
    weights : their defaults
    """

    shapes: Sequence[Shape]
    weights: Sequence[float]


NO_MORPHS = Morphs((), ())


def gltf_mesh(piece: Piece, buffer: GltfBuffer, material: int, morphs: Morphs = NO_MORPHS) -> Mesh:
    """A mesh with its targets, named in ``extras.targetNames`` as most programs read them."""
    primitive = _primitive(piece, buffer, material)
    mesh = Mesh(name=piece.name, primitives=[primitive])
    if morphs.shapes:
        primitive.targets = [_target(shape, piece.name, buffer) for shape in morphs.shapes]
        mesh.weights = list(morphs.weights)
        mesh.extras = {"targetNames": [shape.name for shape in morphs.shapes]}
    return mesh


def gltf_material(kind: str) -> Material:
    """How a kind of piece looks."""
    looks = APPEARANCES[kind]
    return Material(
        name=kind,
        pbrMetallicRoughness=PbrMetallicRoughness(
            baseColorFactor=[*linear(np.array(looks.colour)).round(4).tolist(), looks.opacity],
            metallicFactor=0.0,
            roughnessFactor=looks.roughness,
        ),
        alphaMode=BLEND if looks.sheer else OPAQUE,
        doubleSided=looks.two_sided,
    )


def moves_seen(shape: Shape, name: str) -> bool:
    """Whether a shape moves a mesh by more than is left out."""
    moved = shape.moved.get(name)
    return moved is not None and bool(METRES * np.abs(moved).max(initial=0.0) > UNSEEN)


def _target(shape: Shape, name: str, buffer: GltfBuffer) -> Attributes:
    target = Attributes(POSITION=buffer.change(shape.moved[name] * np.float32(METRES), UNSEEN, bounded=True))
    if name in shape.turns:
        target.NORMAL = buffer.change(shape.turns[name], UNSEEN_TURN)
    return target


def _primitive(piece: Piece, buffer: GltfBuffer, material: int) -> Primitive:
    attributes = Attributes(
        POSITION=buffer.attribute(piece.positions * np.float32(METRES), bounded=True),
        NORMAL=buffer.attribute(_units(piece.normals)),
    )
    if piece.uv is not None:
        attributes.TEXCOORD_0 = buffer.attribute(piece.uv * [1, -1] + [0, 1])
    if piece.kind in ("eye", "lashes"):
        plain = linear(np.array(APPEARANCES[piece.kind].colour))
        shades = np.column_stack([linear(piece.colours[:, :3]) / plain, piece.colours[:, 3]])
        attributes.COLOR_0 = buffer.attribute(shades)
    return Primitive(attributes=attributes, indices=buffer.triangles(piece.triangles), material=material)


def _units(normals: Float32Array) -> Float32Array:
    """Normals of length one to the last bit that glTF asks for; a point without a triangle faces forward."""
    exact = normals.astype(np.float64)
    length = np.linalg.norm(exact, axis=1, keepdims=True)
    return np.where(length > 0, exact / np.where(length > 0, length, 1), [0.0, 0.0, 1.0]).astype(np.float32)

"""Binary glTF 2.0: the face at rest with one morph target per action unit, in metres.

All meshes that move have the same list of targets, so that one array of weights drives skin, lashes, eyes, lower teeth
and tongue.  A target is linear in its weight and ends where the motion ends at activation 1; what the sum of the
targets of the project's expression lacks of what is seen, since jaws turn and lips meet, is one more target, ``posed``,
whose weight is 1.  Every viewer draws morph targets, so the eyes have targets as well; the head, which turns too far
for a straight line, is held by the transform of its node.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import BinaryIO

import numpy as np
from pygltflib import (
    BLEND,
    GLTF2,
    OPAQUE,
    Asset,
    Attributes,
    Buffer,
    Material,
    Mesh,
    Node,
    PbrMetallicRoughness,
    Primitive,
    Scene,
)
from scipy.spatial.transform import Rotation

from facemodel.io.export.appearance import APPEARANCES, linear
from facemodel.io.export.gltf_buffer import GltfBuffer
from facemodel.io.export.morphs import Morph, morphs_of
from facemodel.io.export.pieces import Piece, pieces
from facemodel.kinematics import rig_of, stance_of
from facemodel.project import Project
from facemodel.solve import Solution
from fem.types import Float32Array

METRES = 0.001
UNSEEN = 1e-6
"""Metres: a thousandth of a millimetre of motion is left out, which halves the file."""
UNSEEN_TURN = 2e-3
"""Change of a unit normal (a tenth of a degree) that is left out."""


def write_glb(project: Project, solution: Solution, stream: BinaryIO) -> None:
    """Write skin, eyes and parts with targets named ``AU12``, ``AU12L``, ``AU12R`` in ``extras.targetNames``.

    The project's expression is the default of the weights, and of how the head is held.
    """
    stream.write(glb_bytes(project, solution))


def glb_bytes(project: Project, solution: Solution) -> bytes:
    """The bytes of the file."""
    face = project.face
    buffer = GltfBuffer()
    drawn = list(pieces(project, solution.basis, {}))
    kinds = list(dict.fromkeys(piece.kind for piece in drawn))
    meshes, morphs = [], morphs_of(project, solution.basis)
    for piece in drawn:
        primitive = _primitive(piece, buffer, kinds.index(piece.kind))
        mesh = Mesh(name=piece.name, primitives=[primitive])
        if any(morph.moves[piece.name].any() for morph in morphs):
            primitive.targets = [_target(morph, piece.name, buffer) for morph in morphs]
            mesh.weights = [morph.weight for morph in morphs]
            mesh.extras = {"targetNames": [morph.name for morph in morphs]}
        meshes.append(mesh)
    document = GLTF2(
        asset=Asset(generator="Risorius", copyright=face.provenance or None),
        materials=[_material(kind) for kind in kinds],
        meshes=meshes,
        nodes=_nodes(project, [mesh.name for mesh in meshes]),
        scene=0,
        scenes=[Scene(nodes=[0])],
        accessors=buffer.accessors,
        bufferViews=buffer.views,
        buffers=[Buffer(byteLength=len(buffer.data))],
    )
    document.set_binary_blob(buffer.data)
    return b"".join(document.save_to_bytes())


def _target(morph: Morph, name: str, buffer: GltfBuffer) -> Attributes:
    target = Attributes(POSITION=buffer.change(morph.moves[name] * np.float32(METRES), UNSEEN, bounded=True))
    if name in morph.turns:
        target.NORMAL = buffer.change(morph.turns[name], UNSEEN_TURN)
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


def _material(kind: str) -> Material:
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


def _nodes(project: Project, names: Sequence[str]) -> list[Node]:
    """A head as it is held, with the skin, a node for each eye that holds its layers, and the parts."""
    posture = rig_of(project.units).posture(project.face, project.expression)
    held = stance_of(project.face, posture, np.eye(4)).head
    nodes = [Node(name=project.face.title, children=[])]
    if not np.array_equal(held, np.eye(4)):
        nodes[0].rotation = Rotation.from_matrix(held[:3, :3]).as_quat().tolist()
        nodes[0].translation = (METRES * held[:3, 3]).tolist()

    def add(parent: int, node: Node) -> int:
        nodes.append(node)
        nodes[parent].children.append(len(nodes) - 1)
        return len(nodes) - 1

    groups: dict[str, int] = {}
    for mesh, name in enumerate(names):
        layer, _, side = name.partition("-")
        parent = 0
        if layer in ("eye", "cornea"):
            if side not in groups:
                groups[side] = add(0, Node(name=f"eyeball-{side}", children=[]))
            parent = groups[side]
        add(parent, Node(name=name, mesh=mesh))
    return nodes

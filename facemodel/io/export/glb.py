"""Binary glTF 2.0 in metres: the face with one morph target per action unit, still or playing its animation.

Still, all meshes that move have the same list of targets, so that one array of weights drives skin, lashes, eyes, lower
teeth and tongue.  A target is linear in its weight and ends where the motion ends at activation 1; what the sum of the
targets of the project's expression lacks of what is seen is one more target, ``posed``.  The head, which turns too far
for a straight line, is held by the transform of its node.  Playing, jaw, eyes and head are nodes that turn, and a few
corrective targets take the skin to where the editor has it.
"""

from __future__ import annotations

from collections.abc import Sequence
from typing import BinaryIO

from pygltflib import GLTF2, Asset, Buffer, Mesh, Scene
from pygltflib import Animation as GltfAnimation

from facemodel.basis import Basis
from facemodel.io.export.asked import AS_IT_IS, Asked
from facemodel.io.export.gltf_buffer import GltfBuffer
from facemodel.io.export.gltf_mesh import NO_MORPHS, Morphs, gltf_material, gltf_mesh, moves_seen
from facemodel.io.export.gltf_motion import GltfMotion
from facemodel.io.export.gltf_nodes import GltfNodes
from facemodel.io.export.performance import Performance, performance
from facemodel.io.export.pieces import Piece, pieces
from facemodel.io.export.still import still_performance
from facemodel.project import Project
from facemodel.solution import Progress, silent
from facemodel.solve import Solution


def write_glb(
    project: Project,
    solution: Solution,
    stream: BinaryIO,
    asked: Asked = AS_IT_IS,
    progress: Progress = silent,
) -> str:
    """Write skin, eyes and parts with targets named ``AU12``, ``AU12L``, ``AU12R`` in ``extras.targetNames``.

    The project's expression is the default of the weights.  An animated project has the targets that its clip needs
    and an animation that plays it.
    """
    take = asked.take(project)
    if take is None:
        stream.write(_still(project, solution.basis))
        return ""
    played = performance(take, solution.basis, asked, progress)
    stream.write(_playing(project, solution.basis, played))
    return played.remark


def _still(project: Project, basis: Basis) -> bytes:
    shown = still_performance(project, basis)
    morphs = Morphs(shown.shapes, shown.weights[0].tolist())
    made = _Made(project, basis)
    made.nodes.stand(shown.joints[0])
    for piece in made.pieces:
        moving = any(moves_seen(shape, piece.name) for shape in shown.shapes)
        made.add(piece, morphs if moving else NO_MORPHS)
    return made.document([])


def _playing(project: Project, basis: Basis, played: Performance) -> bytes:
    made = _Made(project, basis)
    morphs: dict[str, list[int]] = {}
    for piece in made.pieces:
        chosen = [k for k, shape in enumerate(played.shapes) if moves_seen(shape, piece.name)]
        morphs[piece.name] = chosen
        made.add(piece, Morphs([played.shapes[k] for k in chosen], played.weights[0, chosen].tolist()))
    motion = GltfMotion(played, made.buffer)
    return made.document([motion.animation(project.face.title, made.nodes, morphs)])


class _Made:
    """A document under construction.

    Attributes
    ----------
    pieces : all meshes of the face at rest
    buffer : its arrays
    nodes : its tree
    """

    def __init__(self, project: Project, basis: Basis) -> None:
        self._face = face = project.face
        self.pieces: list[Piece] = list(pieces(project, basis, {}))
        self.buffer = GltfBuffer()
        self.nodes = GltfNodes(face, [piece.name for piece in self.pieces])
        self._kinds = list(dict.fromkeys(piece.kind for piece in self.pieces))
        self._meshes: list[Mesh] = []

    def add(self, piece: Piece, morphs: Morphs) -> None:
        """Add the next mesh."""
        self._meshes.append(gltf_mesh(piece, self.buffer, self._kinds.index(piece.kind), morphs))

    def document(self, animations: Sequence[GltfAnimation]) -> bytes:
        """The bytes of the whole."""
        document = GLTF2(
            asset=Asset(generator="Risorius", copyright=self._face.provenance or None),
            materials=[gltf_material(kind) for kind in self._kinds],
            meshes=self._meshes,
            nodes=self.nodes.nodes,
            animations=list(animations),
            scene=0,
            scenes=[Scene(nodes=[0])],
            accessors=self.buffer.accessors,
            bufferViews=self.buffer.views,
            buffers=[Buffer(byteLength=len(self.buffer.data))],
        )
        document.set_binary_blob(self.buffer.data)
        return b"".join(document.save_to_bytes())

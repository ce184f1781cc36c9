"""The nodes of a glTF file: a head that turns about the neck, in it a jaw and eyes that turn about pivots of their own.

Every mesh keeps the coordinates of the head: below a pivot hangs what takes them back to it.
"""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from pygltflib import Node

from facemodel.face import Face
from facemodel.io.export.gltf_mesh import METRES
from facemodel.io.export.joints import HEAD, JAW, STILL, Joint, eye_joint, jaw_pivot, joint_of
from facemodel.kinematics import neck_joint
from fem.types import FloatArray


class GltfNodes:
    """The tree of a face; `nodes` is the list of the glTF document, the first one its root.

    Attributes
    ----------
    nodes : all of them
    joints : number of the node of each joint by its name
    meshes : number of the node of each mesh by its name

    Parameters
    ----------
    face : whose it is
    names : of all meshes, in the order of the document
    """

    def __init__(self, face: Face, names: Sequence[str]) -> None:
        self.nodes: list[Node] = [Node(name=face.title, children=[])]
        self.joints: dict[str, int] = {}
        self.meshes: dict[str, int] = {}
        pivots = {HEAD: neck_joint(face), JAW: jaw_pivot(face)}
        pivots |= {eye_joint(eye.side): eye.centre for eye in face.eyes}
        jaw_parts = {part.name for part in face.parts if part.carrier == "jaw"}
        self.joints[HEAD] = self._add(0, Node(name=HEAD, translation=metres(pivots[HEAD]), children=[]))
        upright = self._add(self.joints[HEAD], Node(name="face", translation=metres(-pivots[HEAD]), children=[]))
        for number, name in enumerate(names):
            joint = joint_of(name, jaw_parts)
            parent, place = upright, None
            if joint:
                if joint not in self.joints:
                    node = Node(name=joint, translation=metres(pivots[joint]), children=[])
                    self.joints[joint] = self._add(upright, node)
                parent, place = self.joints[joint], metres(-pivots[joint])
            self.meshes[name] = self._add(parent, Node(name=name, mesh=number, translation=place))

    def stand(self, head: Joint) -> None:
        """Hold the head as a joint does in its first frame."""
        node = self.nodes[self.joints[HEAD]]
        node.translation = metres(head.places[0])
        if not np.allclose(head.turns[0], [0, 0, 0, 1], atol=STILL):
            node.rotation = head.turns[0].tolist()

    def _add(self, parent: int, node: Node) -> int:
        self.nodes.append(node)
        self.nodes[parent].children.append(len(self.nodes) - 1)
        return len(self.nodes) - 1


def metres(place: FloatArray) -> list[float]:
    """A place (3,) in millimetres as glTF has it."""
    return [METRES * float(x) for x in place]

"""A face: the skin, what lies behind it, and the painted fields that make it tissue; frozen values."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, field
from typing import Literal

import numpy as np

from facemodel.mesh import Mesh
from fem.types import BoolArray, FloatArray, IntArray

Carrier = Literal["skull", "jaw", "skin"]
PartKind = Literal["lining", "socket", "lashes", "teeth", "tongue"]


@dataclass(frozen=True, eq=False)
class Part:
    """Something that is drawn with the skin but not solved.

    Attributes
    ----------
    name : unique, for example ``teeth-lower``
    kind : what it is, which decides how it looks
    carrier : what moves it: the skull (still), the jaw (a rigid turn) or the skin (its displacements)
    mesh : its rest shape
    anchors, shares : (P, K) skin vertices and weights (rows sum to one) that carry each vertex; empty unless
        ``carrier`` is ``skin``
    """

    name: str
    kind: PartKind
    carrier: Carrier
    mesh: Mesh
    anchors: IntArray
    shares: FloatArray


@dataclass(frozen=True, eq=False)
class Eye:
    """An eyeball: its centre (3,) and radius in millimetres; it looks along +z at rest."""

    side: Literal["L", "R"]
    centre: FloatArray
    radius: float


@dataclass(frozen=True, eq=False)
class Jaw:
    """The hinge of the mandible.

    Attributes
    ----------
    axis : (2, 3) the right and left condyle, millimetres
    teeth : (3,) a point between the lower incisors
    """

    axis: FloatArray
    teeth: FloatArray


Triple = tuple[float, float, float]


@dataclass(frozen=True)
class Pose:
    """How a skull was moved since it was made.

    Attributes
    ----------
    shift : millimetres along x, y and z of the head
    turn : degrees about x, then y, then z of the head
    scale : times its size along its own axes x, y and z
    """

    shift: Triple = (0.0, 0.0, 0.0)
    turn: Triple = (0.0, 0.0, 0.0)
    scale: Triple = (1.0, 1.0, 1.0)


AT_REST = Pose()


@dataclass(frozen=True, eq=False)
class Placement:
    """The pose of a skull, and what it takes to put it back.

    Attributes
    ----------
    pose : how it was moved
    centre : (3,) millimetres, what it is turned about and scaled from, before it is moved
    feet : (N, 3) its `Skull.anchors` as they were before it was moved; none while it lies where it was made
    """

    pose: Pose = AT_REST
    centre: FloatArray = field(default_factory=lambda: np.zeros(3))
    feet: FloatArray = field(default_factory=lambda: np.zeros((0, 3)))


@dataclass(frozen=True, eq=False)
class Skull:
    """The bone under the skin.

    Attributes
    ----------
    cranium, mandible : closed meshes
    anchors : (N, 3) for every skin vertex the point of the bone its main spring goes to
    jawbone : (N,) in 0..1, the share of that point which belongs to the mandible
    jaw : the hinge
    placement : how all of it was moved since it was made, imported or snapped
    """

    cranium: Mesh
    mandible: Mesh
    anchors: FloatArray
    jawbone: FloatArray
    jaw: Jaw
    placement: Placement = field(default_factory=Placement)


@dataclass(frozen=True, eq=False)
class Layers:
    """The painted fields, one row per skin vertex.

    Attributes
    ----------
    direction : (N, 3) first principal direction of alpha and beta, a vector that is projected on the skin
    stretching : (N, 2) principal stiffnesses alpha along and across it, N/mm
    bending : (N, 3) beta as b11, b22, b12 in the same frame, N mm
    stiffness : (N,) tissue stiffness along the normal per area of skin, N/mm^3, at the depth of the bone
    thickness : (N,) of the tissue between skin and bone, millimetres; 0 where nobody painted it and it is as thick as
        the bone is deep.  Thicker tissue of the same stuff is the softer spring; how thick the skin itself is,
        stretching and bending tell
    sliding : (N,) how many times softer the tissue is along the surface than along its springs, since skin slides over
        bone
    volume : (N,) stiffness of the tissue against a change of its volume, N/mm^3; 0 where it may be squeezed freely
    supports : (N,) int, see `fem.Support`
    """

    direction: FloatArray
    stretching: FloatArray
    bending: FloatArray
    stiffness: FloatArray
    thickness: FloatArray
    sliding: FloatArray
    volume: FloatArray
    supports: IntArray


@dataclass(frozen=True, eq=False)
class Face:
    """Everything that is known of one head at rest; x to the subject's left, y up, z forward; millimetres.

    Attributes
    ----------
    key, title : file name and the name people see
    skin : the whole skin of the head, with boundary loops mouth, two eyes and neck rim
    solved : (T,) bool, the triangles that the finite elements move; the rest is held and drawn
    uv : (N, 2) texture coordinates
    mirror : (N,) skin vertex across the midline
    chart : (N, 2) the bijective, low-distortion map (u, v) of the skin
    landmarks : skin vertices by anatomical name
    eyes : left and right eyeball
    parts : what is drawn with the skin
    skull : the bone
    layers : the painted fields
    provenance : where the data come from and under which licence
    """

    key: str
    title: str
    skin: Mesh
    solved: BoolArray
    uv: FloatArray
    mirror: IntArray
    chart: FloatArray
    landmarks: Mapping[str, int]
    eyes: tuple[Eye, Eye]
    parts: tuple[Part, ...]
    skull: Skull
    layers: Layers
    provenance: str = field(default="")

"""The pointer over the face: which place of skin and skull it is at, and what the hand does with it."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal, Protocol

import numpy as np

from facemodel.face import Face
from facemodel.laying.places import Bone
from facemodel.mesh import Mesh
from fem.types import BoolArray, FloatArray

Surface = Literal["skin", "cranium", "mandible"]

Modifier = Literal["shift", "control"]
"""Keys that change what a tool does; Alt turns the head and never reaches one."""


@dataclass(frozen=True, eq=False)
class Hit:
    """A place on a surface of the face at rest, whatever its expression on the screen.

    Attributes
    ----------
    surface : which one
    triangle : of its mesh
    barycentric : (3,) where in it
    position : (3,) millimetres
    normal : (3,) unit, outward
    vertex : of the mesh, the nearest corner
    """

    surface: Surface
    triangle: int
    barycentric: FloatArray
    position: FloatArray
    normal: FloatArray
    vertex: int


@dataclass(frozen=True, eq=False)
class Ray:
    """Where the pointer looks along: a place (3,) and a unit direction (3,), millimetres."""

    origin: FloatArray
    along: FloatArray

    def distance(self, points: FloatArray) -> FloatArray:
        """How far points (n, 3) lie from it, millimetres."""
        away = np.atleast_2d(points) - self.origin
        return np.asarray(np.linalg.norm(away - np.outer(away @ self.along, self.along), axis=1))


@dataclass(frozen=True, eq=False)
class Pointer:
    """The pointer at one moment.

    Attributes
    ----------
    x, y : pixels from the upper left corner of the viewport
    skin, skull : what lies under it; the skull is found through the skin, and only for tools that ask for it
    ray : the line of sight through it
    reach : millimetres on the face that the tip of the pointer covers
    modifiers : keys that are held
    pressure : of a pen, 0 to 1; a mouse presses fully
    """

    x: float
    y: float
    skin: Hit | None = None
    skull: Hit | None = None
    ray: Ray | None = None
    reach: float = 2.0
    modifiers: frozenset[Modifier] = frozenset()
    pressure: float = 1.0

    @property
    def hit(self) -> Hit | None:
        """What lies under it first: skin, else skull."""
        return self.skin or self.skull


class Projector(Protocol):
    """How the viewport sees the head now, asked when a lasso is closed or a handle is sought."""

    def millimetres(self, place: FloatArray | None = None) -> float:
        """Width of a pixel at a place (3,), or at what the camera looks at."""

    def towards(self, place: FloatArray) -> FloatArray:
        """The unit direction (3,) from a place (3,) to the eye."""

    def skin_on_screen(self) -> tuple[FloatArray, BoolArray]:
        """Pixels (N, 2) of every skin vertex as it is posed, and whether (N,) it faces the eye and can be seen."""

    def bone_on_screen(self) -> tuple[FloatArray, BoolArray]:
        """Pixels (M, 2) of every vertex of the whole skull as it is drawn, and whether (M,) no bone hides it."""


def skin_hit(face: Face, triangle: int, barycentric: FloatArray) -> Hit:
    """The place on the skin in a triangle of its mesh, as it is at rest."""
    return _hit("skin", face.skin, triangle, barycentric)


def skull_hit(face: Face, bone: Bone, triangle: int, barycentric: FloatArray) -> Hit:
    """The place on a bone in a triangle of its mesh."""
    return _hit(bone, face.skull.cranium if bone == "cranium" else face.skull.mandible, triangle, barycentric)


def _hit(surface: Surface, mesh: Mesh, triangle: int, barycentric: FloatArray) -> Hit:
    corners = mesh.triangles[triangle]
    normal = mesh.triangle_normals[triangle]
    length = float(np.linalg.norm(normal))
    return Hit(
        surface,
        triangle,
        barycentric,
        barycentric @ mesh.positions[corners],
        normal / length if length > 0 else normal,
        int(corners[np.argmax(barycentric)]),
    )

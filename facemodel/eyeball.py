"""The eyeball: a sclera, a dished iris round a pupil, and over them a clear cornea, coloured vertex by vertex.

The eye looks along +z. Lengths are millimetres; the cornea has its own size, since in adults it hardly varies.
"""

from __future__ import annotations

from dataclasses import dataclass
from enum import IntEnum
from functools import cached_property

import numpy as np

from facemodel.face import Eye
from facemodel.mesh import Mesh, submesh
from facemodel.smooth import smooth_step
from fem.types import FloatArray, IntArray

IRIS_RADIUS = 5.9
"""White-to-white diameter 11.8 mm: within half a millimetre the same in all adults."""
PUPIL_RADIUS = 1.9
"""An eye in soft indoor light."""
CORNEA_CURVATURE = 8.4
"""Radius of the corneal cap; 7.8 in life, a little flatter so that lids glide over it."""
IRIS_DEPTH = 0.55
"""How far the iris lies behind the plane of the limbus."""
DISH = 0.9
"""How far the shading normals of the iris lean outwards: light that the cornea gathers brightens the side
opposite to the lamp, as it does in a dish."""
LIMBUS = 0.9
"""Width over which the white turns into the iris."""


@dataclass(frozen=True)
class Fineness:
    """How finely an eyeball is cut.

    Attributes
    ----------
    around, cornea_around : vertices of a ring
    white, iris, cornea : rings
    """

    around: int = 80
    white: int = 9
    iris: int = 13
    cornea_around: int = 40
    cornea: int = 9


VERTEX_BY_VERTEX = Fineness()
"""So finely that the vertices carry the colours."""


HAZEL = np.array([0.50, 0.34, 0.17])
GREY_GREEN = np.array([0.36, 0.42, 0.36])
FIBRE = np.array([0.66, 0.66, 0.52])
RIM = np.array([0.10, 0.12, 0.13])
RUFF = np.array([0.12, 0.07, 0.04])
PUPIL = np.array([0.012, 0.010, 0.012])
WHITE = np.array([0.86, 0.83, 0.80])
CORNER = np.array([0.76, 0.55, 0.50])
CLEAR = np.array([1.0, 1.0, 1.0, 0.08])


class Region(IntEnum):
    """What a triangle of the eyeball belongs to."""

    SCLERA = 0
    IRIS = 1
    PUPIL = 2
    CORNEA = 3


@dataclass(frozen=True, eq=False)
class EyeballMesh:
    """An eyeball at rest, in the coordinates of the head.

    Attributes
    ----------
    mesh : the opaque surface and, as a component of its own, the cornea
    normals : (N, 3) unit normals for shading; those of the iris are dished
    colours : (N, 4) float in 0..1, sRGB and opacity
    regions : (T,) int, the `Region` of each triangle
    """

    mesh: Mesh
    normals: FloatArray
    colours: FloatArray
    regions: IntArray

    @cached_property
    def opaque(self) -> tuple[Mesh, IntArray]:
        """Sclera, iris and pupil, and the index of each of its vertices in the whole."""
        return submesh(self.mesh, self.regions != Region.CORNEA)

    @cached_property
    def cornea(self) -> tuple[Mesh, IntArray]:
        """The clear shell, and the index of each of its vertices in the whole."""
        return submesh(self.mesh, self.regions == Region.CORNEA)


@dataclass(frozen=True)
class _Profile:
    """A surface of revolution: radius, height, normal (radial and axial part) and where each ring belongs."""

    radius: FloatArray
    height: FloatArray
    outward: FloatArray
    axial: FloatArray


def _smooth(x: FloatArray, low: float, high: float) -> FloatArray:
    """0 below ``low``, 1 above ``high``, with level ends."""
    return smooth_step((x - low) / (high - low))


def _sclera(ball: float, rings: int) -> _Profile:
    """From the back pole to the limbus, denser towards the front, where it is seen."""
    limbus = np.arcsin(IRIS_RADIUS / ball)
    angle = limbus + (np.pi - limbus) * np.linspace(1, 0, rings) ** 1.8
    return _Profile(ball * np.sin(angle), ball * np.cos(angle), np.sin(angle), np.cos(angle))


def _iris(ball: float, rings: int) -> _Profile:
    """From the limbus inwards and down to the rim of the pupil."""
    share = np.linspace(1, 0, rings)
    radius = PUPIL_RADIUS + (IRIS_RADIUS - PUPIL_RADIUS) * share
    edge = np.sqrt(ball**2 - IRIS_RADIUS**2)
    height = edge - IRIS_DEPTH * _smooth(1 - share, 0.0, 0.35)
    lean = -DISH * (radius / IRIS_RADIUS) * _smooth(1 - share, 0.0, 0.2)
    length = np.hypot(lean, 1.0)
    return _Profile(radius, height, lean / length, 1 / length)


def _cornea(ball: float, rings: int) -> _Profile:
    """From a hair outside the limbus to the apex."""
    base = IRIS_RADIUS * 1.06
    plane = np.sqrt(ball**2 - base**2)
    angle = np.linspace(np.arcsin(base / CORNEA_CURVATURE), 0, rings)
    height = plane + CORNEA_CURVATURE * (np.cos(angle) - np.cos(angle[0]))
    return _Profile(CORNEA_CURVATURE * np.sin(angle), height + 0.02, np.sin(angle), np.cos(angle))


def cornea_cap(eye: Eye) -> tuple[FloatArray, float]:
    """Centre (3,) and radius of the sphere that the corneal cap is part of."""
    base = IRIS_RADIUS * 1.06
    forward = np.sqrt(eye.radius**2 - base**2) - np.sqrt(CORNEA_CURVATURE**2 - base**2)
    return eye.centre + np.array([0.0, 0.0, forward]), CORNEA_CURVATURE


def _revolve(profile: _Profile, around: int) -> tuple[FloatArray, FloatArray, IntArray]:
    """Vertices (R A, 3), normals and triangles of a profile turned about z, rings from the outside inwards."""
    turn = 2 * np.pi * np.arange(around) / around
    ring = np.stack([np.cos(turn), np.sin(turn)], axis=1)

    def swept(radial: FloatArray, axial: FloatArray) -> FloatArray:
        plane = radial[:, None, None] * ring[None]
        up = np.broadcast_to(axial[:, None, None], (*plane.shape[:2], 1))
        return np.concatenate([plane, up], axis=2).reshape(-1, 3)

    k, j = np.meshgrid(np.arange(len(profile.radius) - 1), np.arange(around), indexing="ij")
    a, b = k * around + j, k * around + (j + 1) % around
    c, d = a + around, b + around
    triangles = np.stack([a, b, d, a, d, c], axis=-1).reshape(-1, 3)
    points, normals = swept(profile.radius, profile.height), swept(profile.outward, profile.axial)
    x = points[triangles]
    area = np.linalg.norm(np.cross(x[:, 1] - x[:, 0], x[:, 2] - x[:, 0]), axis=1)
    return points, normals, triangles[area > 1e-9].astype(np.int64)


def around_the_eye(turn: FloatArray, waves: int, seed: int) -> FloatArray:
    """Smooth noise in -1..1 over the full turn with ``waves`` random values, cubic between them."""
    values = np.random.default_rng(seed).uniform(-1, 1, waves)
    at = (turn / (2 * np.pi) % 1.0) * waves
    low = np.floor(at).astype(np.int64)
    t = _smooth(at - low, 0.0, 1.0)
    return np.asarray(values[low % waves] * (1 - t) + values[(low + 1) % waves] * t)


def iris_colours(points: FloatArray) -> FloatArray:
    """Colours (n, 3) of the iris: radial fibres over a hazel centre and a grey-green rim, dark at both edges."""
    radius = np.hypot(points[:, 0], points[:, 1])
    turn = np.arctan2(points[:, 1], points[:, 0])
    share = (radius - PUPIL_RADIUS) / (IRIS_RADIUS - PUPIL_RADIUS)
    sway = 0.10 * np.sin(5 * share + 3 * turn)
    fine, mid, coarse = (around_the_eye(turn + sway, n, n) for n in (64, 29, 9))
    collarette = 0.34 + 0.05 * coarse + 0.03 * mid
    hazel = 1 - _smooth(share - collarette, -0.10, 0.22)
    colour = HAZEL * hazel[:, None] + GREY_GREEN * (1 - hazel[:, None])
    strand = np.clip(0.55 * fine + 0.35 * mid + 0.25 * coarse, -1, 1)
    colour = colour * (1 + 0.34 * strand)[:, None]
    bright = np.clip(strand, 0, 1) * _smooth(share, 0.15, 0.5) * (1 - _smooth(share, 0.7, 0.95))
    colour += (FIBRE - colour) * (0.45 * bright)[:, None]
    rim = _smooth(share + 0.03 * mid, 0.74, 0.97)
    colour += (RIM - colour) * (0.92 * rim)[:, None]
    ruff = 1 - _smooth(share + 0.02 * fine, 0.0, 0.10)
    return np.asarray(colour + (RUFF - colour) * (0.85 * ruff)[:, None])


def white_colours(points: FloatArray, ball: float) -> FloatArray:
    """Colours (n, 3) of the white: warm towards the corners of the eye, soft where it meets the iris."""
    radius = np.hypot(points[:, 0], points[:, 1])
    turn = np.arctan2(points[:, 1], points[:, 0])
    corner = _smooth(np.abs(points[:, 0]) / ball, 0.48, 0.98)
    flush = 0.10 * np.clip(around_the_eye(turn, 41, 41), 0, 1) * _smooth(radius / ball, 0.45, 0.8)
    colour = WHITE + (CORNER - WHITE) * (0.75 * corner + flush)[:, None]
    front = points[:, 2] > 0
    limbus = np.where(front, 1 - _smooth(radius, IRIS_RADIUS - 0.1, IRIS_RADIUS + LIMBUS), 0.0)
    return np.asarray(colour + (RIM - colour) * (0.80 * limbus)[:, None])


def _pupil(edge: FloatArray, first: int) -> tuple[FloatArray, IntArray]:
    """A black, slightly sunken disc (A + 1 vertices) within the ring ``edge`` (A, 3)."""
    around = len(edge)
    centre = edge.mean(axis=0) - [0.0, 0.0, 0.5]
    j = np.arange(around)
    triangles = np.stack([first + j, first + (j + 1) % around, np.full(around, first + around)], axis=1)
    return np.concatenate([edge, centre[None]]), triangles


def eyeball(eye: Eye, fineness: Fineness = VERTEX_BY_VERTEX) -> EyeballMesh:
    """Build the mesh of an eye.

    Parameters
    ----------
    eye : which eye, its centre and its radius
    fineness : how finely it is cut

    Returns
    -------
    The eyeball in the coordinates of the head; the right one is the mirror image of the left one.

    Raises
    ------
    ValueError
        if the eye is not larger than its cornea
    """
    ball = eye.radius
    if ball < 1.2 * IRIS_RADIUS:
        raise ValueError(f"The eye {eye.side} has a radius of {ball:g} mm; it must exceed {1.2 * IRIS_RADIUS:.1f}.")
    white, white_normals, white_triangles = _revolve(_sclera(ball, fineness.white), fineness.around)
    iris, iris_normals, iris_triangles = _revolve(_iris(ball, fineness.iris), fineness.around)
    pupil, pupil_triangles = _pupil(iris[-fineness.around :], 0)
    shell, shell_normals, shell_triangles = _revolve(_cornea(ball, fineness.cornea), fineness.cornea_around)

    blocks = (white, iris, pupil, shell)
    first = np.cumsum([0, *map(len, blocks)])
    faces = (white_triangles, iris_triangles, pupil_triangles, shell_triangles)
    colours = np.ones((first[-1], 4))
    colours[: first[1], :3] = white_colours(white, ball)
    colours[first[1] : first[2], :3] = iris_colours(iris)
    colours[first[2] : first[3], :3] = PUPIL
    colours[first[3] :] = CLEAR
    forward = np.broadcast_to([0.0, 0.0, 1.0], pupil.shape)
    mirror = np.array([1.0 if eye.side == "L" else -1.0, 1.0, 1.0])
    triangles = np.concatenate([f + start for f, start in zip(faces, first, strict=False)])
    return EyeballMesh(
        mesh=Mesh(np.concatenate(blocks) * mirror + eye.centre, triangles[:, :: int(mirror[0])]),
        normals=np.concatenate([white_normals, iris_normals, forward, shell_normals]) * mirror,
        colours=np.clip(colours, 0.0, 1.0),
        regions=np.repeat([int(r) for r in Region], [len(f) for f in faces]).astype(np.int64),
    )

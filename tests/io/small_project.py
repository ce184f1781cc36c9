"""A small made-up project that has one of everything a project may hold, and bitwise comparison of projects."""

import dataclasses
import struct
from collections.abc import Mapping

import numpy as np

from facemodel.actions import ActionUnit, Emotion, JawMotion
from facemodel.face import Eye, Face, Jaw, Layers, Part, Skull
from facemodel.mesh import Mesh
from facemodel.muscles import Fibre, Muscle, Sphincter
from facemodel.project import Project, Settings
from fem import Support

SIDE = 5


def grid(side: int = SIDE, size: float = 80.0, bulge: float = 20.0) -> Mesh:
    """A bulged square sheet that faces +z."""
    line = np.linspace(-0.5, 0.5, side)
    x, y = np.meshgrid(line, line)
    z = 0.5 - x**2 - y**2
    corner = np.arange(side * (side - 1)).reshape(-1, side)[:, :-1].ravel()
    lower = np.stack([corner, corner + 1, corner + side + 1], axis=1)
    upper = np.stack([corner, corner + side + 1, corner + side], axis=1)
    positions = np.stack([size * x, size * y, bulge * z], axis=-1).reshape(-1, 3)
    return Mesh(positions, np.concatenate([lower, upper]).astype(np.int64))


def tetrahedron(centre: tuple[float, float, float], size: float) -> Mesh:
    corners = np.array([[1, 1, 1], [1, -1, -1], [-1, 1, -1], [-1, -1, 1]], dtype=float)
    triangles = np.array([[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]])
    return Mesh(np.array(centre) + size * corners, triangles)


def small_face() -> Face:
    skin = grid()
    n = len(skin.positions)
    across = np.arange(n).reshape(SIDE, SIDE)[:, ::-1].ravel()
    rim = np.any(np.abs(skin.positions[:, :2]) > 39, axis=1)
    nothing = (np.zeros((0, 0), dtype=np.int64), np.zeros((0, 0)))
    teeth = tetrahedron((0, -20, -5), 4)
    lashes = Mesh(skin.positions[[6, 7, 11]] + [0, 0, 1.0], np.array([[0, 1, 2]]))
    parts = (
        Part("teeth-upper", "teeth", "skull", teeth, *nothing),
        Part("teeth-lower", "teeth", "jaw", teeth.moved(teeth.positions - [0, 9, 0]), *nothing),
        Part(
            "lashes",
            "lashes",
            "skin",
            lashes,
            np.array([[6, 7], [7, 8], [11, 12]]),
            np.array([[1.0, 0.0], [0.75, 0.25], [0.5, 0.5]]),
        ),
    )
    return Face(
        key="sheet",
        title="Sheet (made up)",
        skin=skin,
        solved=np.arange(len(skin.triangles)) != 3,
        uv=skin.positions[:, :2] / 80 + 0.5,
        mirror=across.astype(np.int64),
        chart=skin.positions[:, :2].copy(),
        landmarks={"pronasale": 12, "exocanthion left": 8},
        eyes=(
            Eye("L", np.array([30.0, 20.0, -40.0]), 12.0),
            Eye("R", np.array([-30.0, 20.0, -40.0]), 12.0),
        ),
        parts=parts,
        skull=Skull(
            cranium=tetrahedron((0, 10, -60), 40),
            mandible=tetrahedron((0, -40, -30), 20),
            anchors=skin.positions - [0, 0, 10.0],
            jawbone=np.clip(-skin.positions[:, 1] / 40, 0, 1),
            jaw=Jaw(np.array([[-45.0, 0.0, -70.0], [45.0, 0.0, -70.0]]), np.array([0.0, -30.0, 10.0])),
        ),
        layers=Layers(
            direction=np.tile([1.0, 0.0, 0.0], (n, 1)),
            stretching=np.tile([0.03, 0.02], (n, 1)),
            bending=np.tile([0.4, 0.4, 0.2], (n, 1)),
            stiffness=np.full(n, 0.001),
            thickness=np.zeros(n),
            sliding=np.full(n, 12.0),
            volume=np.zeros(n),
            supports=np.where(rim, Support.CLAMPED, Support.FREE).astype(np.int64),
        ),
        provenance="Made up for the tests. CC0.",
    )


def _zygomaticus(side: str, sign: float) -> Muscle:
    fibres = (
        Fibre(np.array([sign * 32.0, 25.0, -2.0]), np.array([sign * 12.0, -12.0, 8.0])),
        Fibre(np.array([sign * 34.0, 20.0, -2.0]), np.array([sign * 12.0, -16.0, 8.0])),
    )
    name = "zygomaticus_major"
    return Muscle(name, side, "M. zygomaticus major", "cheek", "fibre", fibres, None, 9.0, 4.0, 0.02, 20)


def small_project() -> Project:
    ring = Sphincter(np.array([0.0, -20.0, 9.0]), np.array([15.0, 0.0, 0.0]), np.array([0.0, 8.0, 0.0]), forward=0.5)
    orbicularis = Muscle(
        "orbicularis_oris", "M", "M. orbicularis oris", "lip", "sphincter", (), ring, 8.0, 1.0, 0.01, 1
    )
    return Project(
        face=small_face(),
        muscles=(_zygomaticus("L", 1.0), _zygomaticus("R", -1.0), orbicularis),
        units=(
            ActionUnit(12, "lip corner puller", "diagonal", True, {"zygomaticus_major": 1.0}, 9.0),
            ActionUnit(18, "lip pucker", "orbital", False, {"orbicularis_oris": 1.0}, 6.0, note="lips “oo”"),
            ActionUnit(26, "jaw drop", "jaw", False, {}, 12.0, JawMotion(12.0, 2.0)),
        ),
        emotions=(Emotion("happiness", {"12": 1.0}), Emotion("surprise", {"AU26": 0.7})),
        expression={"12L": 0.8, "26": 0.1},
        settings=Settings("hct9", 2),
    )


def identical(first: object, second: object) -> bool:
    """Whether two values of a project are the same to the last bit, in type and in order."""
    if isinstance(first, Mapping) and isinstance(second, Mapping):
        return identical(tuple(first.items()), tuple(second.items()))
    if type(first) is not type(second):
        return False
    if isinstance(first, np.ndarray):
        return (first.dtype, first.shape, first.tobytes()) == (second.dtype, second.shape, second.tobytes())
    if isinstance(first, float):
        return struct.pack("d", first) == struct.pack("d", second)
    if isinstance(first, tuple):
        return len(first) == len(second) and all(map(identical, first, second))
    if dataclasses.is_dataclass(first):
        names = [field.name for field in dataclasses.fields(first)]
        return all(identical(getattr(first, name), getattr(second, name)) for name in names)
    return first == second

"""Small skins on which muscles and tissue can be computed by hand."""

from dataclasses import replace
from typing import Any

import numpy as np

from facemodel.face import Eye, Face, Jaw, Layers, Skull
from facemodel.mesh import Mesh
from facemodel.muscles import Fibre, Muscle, Sphincter
from fem.types import FloatArray
from tests.fem.meshes import plate


def flat_skin(size: float = 60.0, segments: int = 30) -> Mesh:
    """Return a square in the plane z = 0 about the origin, its normals along z."""
    surface = plate(segments)
    return Mesh((surface.positions - [0.5, 0.5, 0.0]) * size, surface.triangles)


def domed_skin(size: float = 60.0, segments: int = 30) -> Mesh:
    """Return the same square bulging along z."""
    skin = flat_skin(size, segments)
    x, y, _ = skin.positions.T
    return skin.moved(np.column_stack([x, y, -(x**2 + y**2) / (2 * size)]))


def face_on(skin: Mesh, layers: Layers, depth: float = 8.0) -> Face:
    """Return a face of one patch of skin over a bone that lies evenly below it, without symmetry."""
    here = np.zeros(3)
    return Face(
        key="patch",
        title="Patch",
        skin=skin,
        solved=np.ones(len(skin.triangles), dtype=np.bool_),
        uv=skin.positions[:, :2],
        mirror=np.arange(len(skin.positions)),
        chart=skin.positions[:, :2],
        landmarks={},
        eyes=(Eye("L", here, 12.0), Eye("R", here, 12.0)),
        parts=(),
        skull=Skull(
            skin, skin, skin.positions - [0, 0, depth], np.zeros(len(skin.positions)), Jaw(np.zeros((2, 3)), here)
        ),
        layers=layers,
    )


def fibre_muscle(fibres: list[tuple[list[float], list[float]]], **changes: Any) -> Muscle:
    """Return a muscle of fibres given as (origin, attachment)."""
    central = tuple(Fibre(np.array(origin), np.array(attachment)) for origin, attachment in fibres)
    values = {"width": 8.0, "kappa": 1.0, "strength": 1.0, "count": 50} | changes
    return Muscle("strap", "L", "Musculus", "cheek", "fibre", central, None, **values)


def bent_muscle(fibres: list[tuple[FloatArray, FloatArray, tuple[FloatArray, ...]]], like: Muscle) -> Muscle:
    """Return a muscle of bent fibres given as (origin, attachment, via) with the values of another one."""
    return replace(like, fibres=tuple(Fibre(*fibre) for fibre in fibres))


def ring_muscle(ring: Sphincter | None, model: str = "sphincter", **changes: Any) -> Muscle:
    values = {"width": 5.0, "kappa": 1.0, "strength": 1.0, "count": 1} | changes
    return Muscle("ring", "L", "Orbicularis", "eye", model, (), ring, **values)  # type: ignore[arg-type]


def at(skin: Mesh, *place: float) -> int:
    """Return the vertex at a place, which must be there."""
    away = np.linalg.norm(skin.positions - place, axis=1)
    assert away.min() < 1e-9
    return int(away.argmin())


def sizes(forces: FloatArray) -> FloatArray:
    """Return the length of every force."""
    return np.asarray(np.linalg.norm(forces, axis=1))


def by(*step: float) -> FloatArray:
    """Return a step (3,) to add to a place."""
    return np.array(step, dtype=np.float64)

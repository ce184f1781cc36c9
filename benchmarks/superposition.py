"""Superposing 50 fields against streaming the basis once, and against shape keys in Blender where it is installed."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from collections.abc import Callable, Iterator, Mapping
from importlib.util import find_spec
from pathlib import Path

import numpy as np

from benchmarks.figure import Figure, alone, compared, interleaved
from benchmarks.shapes import FIELDS, default_face, drawn, random_basis
from facemodel.field_sum import FieldSum, Layer, add_field, sum_fields
from facemodel.superposition import Superposition
from fem.types import Float32Array, FloatArray

DENSITIES: Mapping[str, int] = {"25k": 3, "100k": 6, "1M": 18}
"""Segments per edge that draw the default face with about so many moving points."""

REPEATS: Mapping[str, int] = {"25k": 41, "100k": 31, "1M": 11}
COPY = 256 * 2**20
"""Bytes of the memory copy that tells the bandwidth: far more than any cache holds."""

SUM_LIMIT, SLIDER_LIMIT = 1.3, 1 / 20

BLENDER = "BLENDER_PYTHON"
"""Environment variable that may name another Python which has ``bpy``; its wheels fit one version of Python each."""


def figures() -> Iterator[Figure]:
    """Measure at 25 and 100 thousand and a million points."""
    blender = blender_python()
    for size in DENSITIES:
        yield from _figures_at(size, blender)
    if blender is None:
        yield Figure(f"Blender's shape keys: not measured, bpy is not installed and {BLENDER} names no Python")


def _figures_at(size: str, blender: str | None) -> Iterator[Figure]:
    posed = Superposition(default_face(), random_basis(drawn(DENSITIES[size])))
    taken = interleaved(_Steps(posed).named(), REPEATS[size])
    basis = posed.basis
    read = basis.fields.nbytes + basis.slopes.nbytes
    streamed = taken["copy"] * read / (2 * COPY)
    summed, added = taken["sum"], taken["add"]
    at = f"{size} points"
    yield alone(f"{read / 1e6:.0f} MB of basis at the bandwidth of a copy, {at}", streamed)
    yield compared(f"{FIELDS} fields superposed, {at}", summed, "basis streamed once", streamed, SUM_LIMIT)
    yield compared(f"one changed slider, {at}", added, "all fields", summed, SLIDER_LIMIT)
    yield compared(f"whole pose, every slider changed, {at}", taken["pose all"], "all fields", summed)
    yield compared(f"whole pose, one slider changed, {at}", taken["pose one"], "all fields", summed)
    if blender is not None:
        every, single = shape_keys(blender, basis.display.moving)
        yield compared(
            f"whole pose, every slider changed, {at}", np.median(taken["pose all"], keepdims=True), "bpy", every
        )
        yield compared(
            f"whole pose, one slider changed, {at}", np.median(taken["pose one"], keepdims=True), "bpy", single
        )


class _Steps:
    """What is measured on one face; every call changes the weights."""

    def __init__(self, posed: Superposition) -> None:
        self._posed = posed
        self._calls = 0
        # Of ones, since untouched zeros are one page of memory, however many there are.
        self._copy = np.ones(COPY // 4, dtype=np.float32), np.ones(COPY // 4, dtype=np.float32)
        self._sums = tuple(_sum_of(matrix) for matrix in (posed.basis.fields, posed.basis.slopes))

    def named(self) -> dict[str, Callable[[], None]]:
        """The steps by name."""
        return {
            "copy": self.copy,
            "sum": self.sum,
            "add": self.add,
            "pose all": self.pose_all,
            "pose one": self.pose_one,
        }

    def copy(self) -> None:
        """Copy a large array, which reads and writes it once."""
        np.copyto(*self._copy)

    def sum(self) -> None:
        """Superpose all fields and slopes."""
        sum_fields(self._sums)

    def add(self) -> None:
        """Add one field."""
        self._calls += 1
        for total, _, (layer,) in self._sums:
            add_field(total, layer.fields[self._calls % FIELDS], 0.01)

    def pose_all(self) -> None:
        """Pose with every weight changed, normals, lids and jaw included."""
        self._calls += 1
        step = 1e-4 * (self._calls % 1000)
        self._posed.pose({name: 0.2 + 0.01 * k + step for k, name in enumerate(self._posed.basis.names)})

    def pose_one(self) -> None:
        """Pose with one weight changed from what `pose_all` left."""
        step = 1e-4 * (self._calls % 1000)
        weights = {name: 0.2 + 0.01 * k + step for k, name in enumerate(self._posed.basis.names)}
        weights[self._posed.basis.names[7]] += 0.3
        self._posed.pose(weights)


def _sum_of(fields: Float32Array) -> FieldSum:
    rest = np.ones(fields.shape[1], dtype=np.float32)
    return FieldSum(np.empty_like(rest), rest, (Layer(fields, np.linspace(0.1, 1.0, FIELDS, dtype=np.float32)),))


def blender_python() -> str | None:
    """A Python that can import ``bpy``: this one, or the one that the environment names."""
    named = os.environ.get(BLENDER)
    if named:
        return named
    return sys.executable if find_spec("bpy") else None


def shape_keys(python: str, points: int) -> tuple[FloatArray, FloatArray]:
    """Seconds (n,) that Blender takes to evaluate 50 shape keys and hand the mesh back: all changed, and one."""
    script = Path(__file__).with_name("shape_keys.py")
    command = [python, str(script), str(points), str(FIELDS)]
    done = subprocess.run(command, capture_output=True, text=True, check=True)
    found = json.loads(done.stdout.splitlines()[-1])
    return np.array([np.median(found["all"])]), np.array([np.median(found["one"])])

"""Layers evened out over the skin."""

from __future__ import annotations

from typing import TypeVar

import numpy as np
from numpy.typing import NDArray
from scipy.sparse import csr_array, diags_array, eye_array

from facemodel.mesh import Mesh
from facemodel.painting.frames import angle_of, line_at
from facemodel.painting.layers import Kind
from fem.types import FloatArray

Number = TypeVar("Number", np.float64, np.complex128)

STEPS = 6
"""Steps of one smoothing: unevenness of the size of a few triangles goes, a region's own shape stays."""

SHARE = 0.7
"""Part of each step that comes from the neighbours; all of it would swap checkerboards instead of evening them out."""


def smoothing(mesh: Mesh) -> csr_array:
    """One step as an operator (N, N): rows are shares that sum to one, larger for nearer neighbours.

    A smoothed value is therefore never beyond those around it, and what is constant stays.
    """
    count = len(mesh.positions)
    i, j = mesh.edges.T
    length = np.linalg.norm(mesh.positions[i] - mesh.positions[j], axis=1)
    nearness = 1 / np.maximum(length, np.finfo(float).tiny)
    half = csr_array((nearness, (i, j)), shape=(count, count))
    both = csr_array(half + half.T)
    total = np.asarray(both.sum(axis=1))
    alone = total == 0
    mean = diags_array(np.where(alone, 0.0, SHARE) / np.where(alone, 1.0, total)) @ both
    return csr_array(mean + diags_array(np.where(alone, 1.0, 1 - SHARE)) @ eye_array(count))


def smoothed(kind: Kind, values: FloatArray, step: csr_array) -> FloatArray:
    """Values (N,) of a layer evened out; angles as lines, so that 89° and -89° make 90° and not 0°."""
    if kind == "angle":
        return angle_of(_stepped(line_at(values), step))
    return _stepped(values, step)


def _stepped(values: NDArray[Number], step: csr_array) -> NDArray[Number]:
    for _ in range(STEPS):
        values = step @ values
    return values

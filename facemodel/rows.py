"""Put values into some rows of an array, several times as fast as numpy does where rows are short."""

from __future__ import annotations

from facemodel.compiled import compiled
from fem.types import Float32Array, IntArray


@compiled
def put_rows(into: Float32Array, rows: IntArray, values: Float32Array) -> None:
    """Write values (n, k) into rows (n,) of an array (N, k), in place."""
    for number, row in enumerate(rows):
        for k in range(into.shape[1]):
            into[row, k] = values[number, k]

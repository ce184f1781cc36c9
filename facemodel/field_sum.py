"""Weighted sums of fields in single precision, as fast as memory can be read."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np
from scipy.linalg.blas import saxpy

from facemodel.compiled import compiled
from facemodel.side_by_side import side_by_side
from fem.types import Float32Array

ABREAST = 5
"""Fields that are read side by side: with fewer the total is passed over more often, with more the processor loses some
of the streams (measured from 1 to 13 with nothing of the fields in the cache; up to a seventh slower with eight)."""

STRETCH = 32_768
"""Numbers of the total that are finished before the next ones: few enough to stay in the cache beside one core,
and long enough a stretch of every field that its stream gets going (measured from 8 thousand to all at once)."""

ALONE = 2**20
"""Numbers of fields that one thread has read before another would have begun (4 MB, a tenth of a millisecond)."""


class Layer(NamedTuple):
    """Fields (M, n) in C order, and their weights (M,)."""

    fields: Float32Array
    weights: Float32Array


class FieldSum(NamedTuple):
    """A total (n,) to be written, what it is without any field (n,), and the fields."""

    total: Float32Array
    rest: Float32Array
    layers: tuple[Layer, ...]


def add_field(total: Float32Array, field: Float32Array, weight: float) -> None:
    """Add a weighted field (n,) to the first n numbers of a total, in place."""
    if len(field) < ALONE:
        saxpy(field, total, n=len(field), a=weight)
    else:
        _in_two([_Job(_add_part, (total, field, np.float32(weight)), len(field))], 1)


def sum_fields(sums: Sequence[FieldSum]) -> None:
    """Write rest + sum of w_k u_k over all layers into every total."""
    jobs = [_Job(_sum_layers, each, len(each.total)) for each in sums]
    _in_two(jobs, max(sum(int(np.count_nonzero(layer.weights)) for layer in each.layers) for each in sums))


class _Job(NamedTuple):
    """A loop over so many numbers: its arguments, to which come from which number to which."""

    loop: Callable[..., None]
    arguments: tuple[object, ...]
    length: int


def _in_two(jobs: Sequence[_Job], fields: int) -> None:
    """Do jobs that read so many fields, in two threads where that is worth while.

    One core reads more slowly than memory gives, so a second thread takes one half.
    """
    total = sum(job.length for job in jobs)
    if total * fields < ALONE:
        _do(jobs, 0, total)
        return
    side_by_side(lambda: _do(jobs, 0, total // 2), lambda: _do(jobs, total // 2, total))


def _do(jobs: Sequence[_Job], begin: int, end: int) -> None:
    """Do what lies between two numbers of all that the jobs go over, one behind the other."""
    for loop, arguments, length in jobs:
        first, last = max(begin, 0), min(end, length)
        if first < last:
            loop(*arguments, first, last)
        begin, end = begin - length, end - length


def _add_part(total: Float32Array, field: Float32Array, weight: np.float32, begin: int, end: int) -> None:
    _add_row(total[begin:end], field[begin:end], weight)


@compiled
def _add_row(total: Float32Array, field: Float32Array, weight: np.float32) -> None:
    for n in range(len(field)):
        total[n] += weight * field[n]


@compiled
def _sum_layers(total: Float32Array, rest: Float32Array, layers: tuple[Layer, ...], begin: int, end: int) -> None:
    """Sum the fields that have a weight between two places, stretch by stretch."""
    for first in range(begin, end, STRETCH):
        last = min(first + STRETCH, end)
        part = total[first:last]
        part[:] = rest[first:last]
        for layer in layers:
            _add_rows(part, layer.fields, layer.weights, first, last)


@compiled
def _add_rows(part: Float32Array, fields: Float32Array, weights: Float32Array, first: int, last: int) -> None:
    """Add what lies between two places of the fields that have a weight.

    Those read side by side are variables of their own in one loop, since only so the compiler keeps them apart.
    """
    rows = np.flatnonzero(weights)
    abreast = len(rows) - len(rows) % ABREAST
    for k in range(0, abreast, ABREAST):
        g, h, i, j, m = rows[k], rows[k + 1], rows[k + 2], rows[k + 3], rows[k + 4]
        a, b, c = fields[g, first:last], fields[h, first:last], fields[i, first:last]
        d, e = fields[j, first:last], fields[m, first:last]
        v, w, x, y, z = weights[g], weights[h], weights[i], weights[j], weights[m]
        for n in range(len(part)):
            part[n] += v * a[n] + w * b[n] + x * c[n] + y * d[n] + z * e[n]
    for k in range(abreast, len(rows)):
        a, v = fields[rows[k], first:last], weights[rows[k]]
        for n in range(len(part)):
            part[n] += v * a[n]

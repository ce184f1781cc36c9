"""One array as the bytes of an ``.npy`` file, version 1.0, never pickled.

The header of an ``.npy`` file is a Python expression.  It is not evaluated here: it has to be, letter by
letter, what NumPy writes for a C-ordered array of one of a few types.
"""

from __future__ import annotations

import math
import re
from io import BytesIO
from typing import Any

import numpy as np
from numpy.typing import NDArray

from facemodel.io.damage import DamageError

DTYPES = {"<f8", "<f4", "<i8", "<i4", "|i1", "|b1"}
"""The types that are written and read."""

MAGIC = b"\x93NUMPY\x01\x00"
LONGEST_HEADER = 256
MOST_AXES = 3

HEADER = re.compile(
    rb"\{'descr': '(?P<dtype>[<|][a-z]\d)', 'fortran_order': False, 'shape': "
    rb"\((?P<shape>(?:\d{1,10}, )*\d{1,10},?)\), \} *\n"
)


def npy_bytes(array: NDArray[Any]) -> bytes:
    """The array as an ``.npy`` file, little-endian, in C order.

    Raises
    ------
    ValueError
        If its type is not one of `DTYPES`.
    """
    plain = np.ascontiguousarray(array, dtype=array.dtype.newbyteorder("<"))
    if plain.dtype.str not in DTYPES:
        raise ValueError(f"arrays of type {plain.dtype} are not stored")
    stream = BytesIO()
    np.lib.format.write_array(stream, plain, version=(1, 0), allow_pickle=False)
    return stream.getvalue()


def npy_array(data: bytes, where: str) -> NDArray[Any]:
    """The array in the bytes of an ``.npy`` file; its declared shape has to account for every byte.

    Parameters
    ----------
    data : the whole file
    where : the name of the member, for the error

    Raises
    ------
    DamageError
        If it is anything else.
    """
    start = len(MAGIC) + 2
    length = int.from_bytes(data[len(MAGIC) : start], "little")
    if not data.startswith(MAGIC) or length > LONGEST_HEADER:
        raise DamageError(where, "is not an array file of version 1.0")
    header = HEADER.fullmatch(data[start : start + length])
    if header is None or header["dtype"].decode() not in DTYPES:
        raise DamageError(where, "has a header that is not that of a plain array of numbers")
    shape = tuple(int(count) for count in header["shape"].replace(b" ", b"").split(b",") if count)
    dtype = np.dtype(header["dtype"].decode())
    declared = math.prod(shape) * dtype.itemsize
    if len(shape) > MOST_AXES or declared != len(data) - start - length:
        raise DamageError(where, f"declares {declared} bytes of numbers but holds {max(0, len(data) - start - length)}")
    if dtype == np.bool_ and np.frombuffer(data, np.uint8, offset=start + length).max(initial=0) > 1:
        raise DamageError(where, "holds truth values other than 0 and 1")
    flat = np.frombuffer(data, dtype, offset=start + length)
    return flat.reshape(shape).astype(dtype.newbyteorder("="))

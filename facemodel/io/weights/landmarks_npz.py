"""Landmarks of MediaPipe's face mesh as an ``.npz`` archive of arrays, as scripts about NumPy keep them."""

from __future__ import annotations

import zipfile
from io import BytesIO
from typing import Any

import numpy as np
from numpy.typing import NDArray

from facemodel.animation.landmarks import LandmarkTrack
from facemodel.io.archive import ENCRYPTED, METHODS, UNREADABLE
from facemodel.io.damage import DamageError
from facemodel.io.npy import npy_array
from facemodel.io.weights.landmark_frames import AGAIN, tracked

LARGEST_MEMBER = 1 << 28
"""Bytes; 25 minutes of 478 points at 30 frames a second in single precision."""

POINTS = ("landmarks", "points", "face_landmarks")
TIMES = ("times", "time", "timestamps", "seconds")
NPY = ".npy"


def read_landmarks_npz(data: bytes, rate: float | None = None) -> LandmarkTrack:
    """The landmarks in the bytes of an archive with an array ``landmarks`` (N, 468 or 478, 3), perhaps with ``times``.

    Raises
    ------
    DamageError
        If it is no such archive, holds objects instead of numbers, or has no frame with a face.
    """
    try:
        zipped = zipfile.ZipFile(BytesIO(data))
    except UNREADABLE as error:
        raise DamageError("the file", "is cut short or no .npz archive", AGAIN) from error
    with zipped:
        points = _first(zipped, POINTS)
        if points is None:
            raise DamageError("the file", f"has no array {POINTS[0]}", AGAIN)
        return tracked(points.astype(np.float64), _first(zipped, TIMES), rate)


def _first(zipped: zipfile.ZipFile, names: tuple[str, ...]) -> NDArray[Any] | None:
    """The first array that has one of some names; none if there is none."""
    infos = {info.filename: info for info in zipped.infolist()}
    found = next((infos[name + NPY] for name in names if name + NPY in infos), None)
    return None if found is None else _array(zipped, found)


def _array(zipped: zipfile.ZipFile, info: zipfile.ZipInfo) -> NDArray[Any]:
    """One array, its size looked at before it is unpacked, its length and CRC after."""
    where = f"the array {info.filename.removesuffix(NPY)}"
    if info.flag_bits & ENCRYPTED or info.compress_type not in METHODS:
        raise DamageError(where, "is encrypted or packed with an unknown method", AGAIN)
    if info.file_size > LARGEST_MEMBER:
        raise DamageError(where, f"would unpack to {info.file_size >> 20} MiB, which no recording needs", AGAIN)
    try:
        with zipped.open(info) as stream:
            raw = stream.read(info.file_size + 1)
    except UNREADABLE as error:
        raise DamageError(where, "is damaged", AGAIN) from error
    try:
        return npy_array(raw, where)
    except DamageError as damage:
        raise DamageError(damage.where, damage.what, AGAIN) from damage

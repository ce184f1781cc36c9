"""The container of every Risorius file: a zip of one JSON document and ``.npy`` arrays.

What is written depends on the contents alone, so that saving twice gives the same bytes.  What is read is
believed only after its declared sizes, names and checksums have been looked at.
"""

from __future__ import annotations

import json
import re
import struct
import zipfile
import zlib
from collections.abc import Mapping
from dataclasses import dataclass
from io import BytesIO
from typing import Any

from numpy.typing import NDArray

from facemodel.io.damage import DamageError
from facemodel.io.npy import npy_array, npy_bytes
from facemodel.io.readable import readable

LARGEST_ARCHIVE = 1 << 30
"""Bytes of all members together, unpacked; a scan of a million vertices takes a quarter of it."""

LARGEST_MEMBER = 1 << 28
LARGEST_DOCUMENT = 1 << 24
MOST_MEMBERS = 2000

SUSPECT_SIZE = 1 << 26
MOST_SHRINKAGE = 50
"""Over 64 MiB an archive may not unpack to more than 50 times its size: coordinates hardly shrink at all."""

OLDEST_DATE = (1980, 1, 1, 0, 0, 0)
MEMBER_NAME = re.compile(r"[a-z0-9_]+(/[a-z0-9_]+)*\.(json|npy)")
ENCRYPTED = 0x1
METHODS = {zipfile.ZIP_STORED, zipfile.ZIP_DEFLATED}

UNREADABLE = (
    zipfile.BadZipFile,
    zlib.error,
    struct.error,
    EOFError,
    NotImplementedError,
    OSError,
    OverflowError,
    ValueError,
)
"""What `zipfile` raises for damaged archives."""


@dataclass(frozen=True, eq=False)
class Archive:
    """The contents of a file.

    Attributes
    ----------
    document : the JSON object
    arrays : arrays by member name, without the suffix
    """

    document: Mapping[str, Any]
    arrays: Mapping[str, NDArray[Any]]


def pack(archive: Archive, member: str) -> bytes:
    """The bytes of an archive whose JSON document is called ``member``.

    Raises
    ------
    DamageError
        If it holds text or an array that cannot be written.
    """
    try:
        members = {member: readable(archive.document)}
        members |= {f"{name}.npy": npy_bytes(archive.arrays[name]) for name in sorted(archive.arrays)}
    except ValueError as error:
        raise DamageError(member, f"cannot be written: {error}") from error
    stream = BytesIO()
    with zipfile.ZipFile(stream, "w") as out:
        for name, data in members.items():
            info = zipfile.ZipInfo(name, OLDEST_DATE)
            info.create_system = 3
            info.external_attr = 0o644 << 16
            info.compress_type = zipfile.ZIP_DEFLATED
            out.writestr(info, data)
    return stream.getvalue()


def unpack(data: bytes, member: str) -> Archive:
    """The contents of an archive whose JSON document is called ``member``.

    Raises
    ------
    DamageError
        If it is not such an archive, is damaged, or unpacks to more than the limits of this module.
    """
    try:
        zipped = zipfile.ZipFile(BytesIO(data))
    except UNREADABLE as error:
        raise DamageError("the file", "is cut short or not a Risorius file") from error
    with zipped:
        infos = zipped.infolist()
        _check_directory(infos, len(data))
        members = {info.filename: _member(zipped, info) for info in infos}
    if member not in members:
        raise DamageError("the file", f"is a zip without {member}, so it is another kind of file")
    document = _document(members.pop(member), member)
    arrays = {name.removesuffix(".npy"): npy_array(array, name) for name, array in members.items()}
    return Archive(document, arrays)


def _check_directory(infos: list[zipfile.ZipInfo], packed: int) -> None:
    """Everything that can be known before a single member is unpacked."""
    if len(infos) > MOST_MEMBERS:
        raise DamageError("the file", f"has {len(infos)} members and at most {MOST_MEMBERS} are allowed")
    seen: set[str] = set()
    for info in infos:
        name = info.filename
        if not MEMBER_NAME.fullmatch(name):
            raise DamageError(f"the member {name[:100]!r}", "has a name that no Risorius file contains")
        if name in seen:
            raise DamageError(f"the member {name}", "is there twice")
        seen.add(name)
        if info.flag_bits & ENCRYPTED:
            raise DamageError(f"the member {name}", "is encrypted")
        if info.compress_type not in METHODS:
            raise DamageError(f"the member {name}", "is packed with an unknown method")
        limit = LARGEST_DOCUMENT if name.endswith(".json") else LARGEST_MEMBER
        if info.file_size > limit:
            raise DamageError(
                f"the member {name}",
                f"would unpack to {info.file_size >> 20} MiB and at most {limit >> 20} are allowed",
            )
    total = sum(info.file_size for info in infos)
    if total > LARGEST_ARCHIVE or (total > SUSPECT_SIZE and total > MOST_SHRINKAGE * packed):
        raise DamageError("the file", f"would unpack from {packed >> 10} KiB to {total >> 20} MiB, which no face does")


def _member(zipped: zipfile.ZipFile, info: zipfile.ZipInfo) -> bytes:
    """One member, its length and CRC verified."""
    try:
        with zipped.open(info) as stream:
            data = stream.read()
    except UNREADABLE as error:
        raise DamageError(f"the member {info.filename}", "is damaged") from error
    if len(data) != info.file_size:
        raise DamageError(f"the member {info.filename}", "is cut short")
    return data


def _document(data: bytes, member: str) -> dict[str, Any]:
    try:
        document = json.loads(data, object_pairs_hook=_unique_keys)
    except RecursionError as error:
        raise DamageError(member, "is nested too deeply") from error
    except ValueError as error:
        raise DamageError(member, f"is not JSON ({error})") from error
    if not isinstance(document, dict):
        raise DamageError(member, "is not a JSON object")
    return document


def _unique_keys(pairs: list[tuple[str, Any]]) -> dict[str, Any]:
    keys = dict(pairs)
    if len(keys) < len(pairs):
        raise ValueError("a key is there twice")
    return keys

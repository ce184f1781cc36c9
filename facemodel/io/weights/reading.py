"""Reads weights over time from a file, whatever program wrote it."""

from __future__ import annotations

from collections.abc import Sequence
from pathlib import Path

from facemodel.actions import ActionUnit
from facemodel.animation.capture import Capture
from facemodel.animation.landmarks import LandmarkTrack
from facemodel.errors import ProjectError
from facemodel.io.damage import naming
from facemodel.io.disk import read_file
from facemodel.io.weights.arkit_json import read_arkit_json
from facemodel.io.weights.fap import read_fap
from facemodel.io.weights.landmarks_json import holds_landmarks, read_landmarks_json
from facemodel.io.weights.landmarks_npz import read_landmarks_npz
from facemodel.io.weights.live_link import is_arkit, read_live_link
from facemodel.io.weights.openface import is_openface, read_openface
from facemodel.io.weights.plain import read_plain
from facemodel.io.weights.table import heading

LARGEST_FILE = 1 << 29
"""Bytes; an hour of OpenFace's 431 columns at 30 frames a second takes 400 MB."""

READABLE = (".csv", ".json", ".fap")
"""Suffixes of files with weights over time."""

LANDMARKS = ".npz"
"""Suffix of files with landmarks over time."""

RECORDINGS = (*READABLE, LANDMARKS)
"""Suffixes of whatever trackers write."""

SLOWEST, FASTEST = 1.0, 1000.0
"""Frames per second that may be said of a file."""


def read_capture(path: Path, units: Sequence[ActionUnit] = (), rate: float | None = None) -> Capture:
    """What a tracker saw, from a file of OpenFace, Live Link Face, ARKit, MediaPipe or MPEG-4, or a plain table.

    Parameters
    ----------
    path : ``.csv``, ``.json`` or ``.fap``; the format of a table is known by its heading
    units : of the face, for plain tables
    rate : frames per second; noted times are then not looked at

    Raises
    ------
    ProjectError
        If there is no such file, it is of another kind, or damaged; the place and the remedy are named.
    """
    return _weights(_read(path, READABLE, rate), path, units, rate)


def read_recording(path: Path, units: Sequence[ActionUnit] = (), rate: float | None = None) -> Capture | LandmarkTrack:
    """What a tracker saw, weights as `read_capture` reads them, or landmarks of MediaPipe.

    These are in an ``.npz`` file, or in JSON that has no weights.

    Raises
    ------
    ProjectError
        If there is no such file, it is of another kind, or damaged; the place and the remedy are named.
    """
    data = _read(path, RECORDINGS, rate)
    if path.suffix.lower() == LANDMARKS:
        with naming(path, "read"):
            return read_landmarks_npz(data, rate)
    if path.suffix.lower() == ".json" and holds_landmarks(data):
        with naming(path, "read"):
            return read_landmarks_json(data, rate)
    return _weights(data, path, units, rate)


def _read(path: Path, readable: Sequence[str], rate: float | None) -> bytes:
    """The bytes of a file whose suffix is one of those that can be read."""
    if path.suffix.lower() not in readable:
        raise ProjectError(f"“{path}” cannot be read: weights over time are in {', '.join(readable)} files.")
    if rate is not None and not SLOWEST <= rate <= FASTEST:
        raise ProjectError(f"“{path}” cannot have {rate:g} frames a second; choose from {SLOWEST:g} to {FASTEST:g}.")
    return read_file(path, LARGEST_FILE)


def _weights(data: bytes, path: Path, units: Sequence[ActionUnit], rate: float | None) -> Capture:
    """The weights in the bytes of a file; the format of a table is known by its heading."""
    suffix = path.suffix.lower()
    with naming(path, "read"):
        if suffix == ".json":
            return read_arkit_json(data, rate)
        if suffix == ".fap":
            return read_fap(data, rate)
        names = heading(data)
        if is_openface(names):
            return read_openface(data, rate)
        if is_arkit(names):
            return read_live_link(data, rate)
        return read_plain(data, units, rate)

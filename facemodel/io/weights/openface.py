"""OpenFace's CSV: intensities of action units 0 to 5, head and gaze, and how sure it was."""

from __future__ import annotations

import re

import numpy as np

from facemodel.animation.capture import Capture
from facemodel.io.damage import DamageError
from facemodel.io.weights.table import Table, read_table
from facemodel.io.weights.timing import even, kept
from fem.types import FloatArray

INTENSITY = re.compile(r"AU\d\d_r", re.IGNORECASE)
WANTED = re.compile(r"frame|timestamp|confidence|success|face_id|AU\d\d_r|AU28_c|pose_R[xyz]|gaze_[01]_[xyz]", re.I)

SURE = 0.5
"""Confidence below which a frame is not believed; OpenFace itself calls a frame tracked from about there."""

HEAD = {"head.yaw": ("pose_Ry", -1.0), "head.pitch": ("pose_Rx", -1.0), "head.roll": ("pose_Rz", 1.0)}
"""Its camera looks along z, with x to the right and y down in the picture: a positive turn about y is to the subject's
right, one about x is down, one about z towards the subject's left shoulder."""

EYES = {"eyeR": "gaze_0", "eyeL": "gaze_1"}
"""Its first eye is the left one in the picture."""


def is_openface(names: tuple[str, ...]) -> bool:
    """Whether a heading is that of an OpenFace table."""
    return any(INTENSITY.fullmatch(name) for name in names)


def read_openface(data: bytes, rate: float | None = None) -> Capture:
    """A capture from the bytes of an OpenFace table; of several faces, the first.

    Raises
    ------
    DamageError
        If it is no such table, or its times go back.
    """
    table = read_table(data, lambda name: WANTED.fullmatch(name) is not None)
    units = [name for name in table.names if name.upper().startswith("AU")]
    if not any(INTENSITY.fullmatch(name) for name in units):
        raise DamageError("line 1", "has no intensities such as AU12_r", "write them with OpenFace’s -aus")
    table, notes = _one_face(table)
    columns = {_unit_name(name): table.column(name) for name in units} | _turns(table)
    values = np.stack([column for column in columns.values() if column is not None], axis=1)
    unsure = _unsure(table)
    values[unsure] = np.nan
    if unsure.any():
        notes.append(f"In {int(unsure.sum())} of {len(values)} frames no face was found for sure; they were bridged.")
    found = even(table.column("timestamp"), values, table.lines, rate)
    return Capture(
        "openface",
        tuple(columns),
        kept(found.values),
        found.rate,
        0.0,
        (*table.notes, *notes, *found.notes),
    )


def _unit_name(name: str) -> str:
    """``AU12_r`` however it is written."""
    return name[:4].upper() + name[4:].lower()


def _one_face(table: Table) -> tuple[Table, list[str]]:
    faces = table.column("face_id")
    if faces is None or len(np.unique(faces)) < 2:
        return table, []
    rows = np.flatnonzero(faces == faces[0])
    kept = Table(
        table.names, table.values[rows], table.texts, tuple(table.lines[k] for k in rows.tolist()), table.notes
    )
    return kept, [f"It has {len(np.unique(faces))} faces; the first one was taken."]


def _unsure(table: Table) -> np.ndarray:
    unsure = np.zeros(len(table.values), dtype=np.bool_)
    confidence, success = table.column("confidence"), table.column("success")
    if confidence is not None:
        unsure |= ~(confidence >= SURE)
    if success is not None:
        unsure |= ~(success >= 0.5)
    return unsure


def _turns(table: Table) -> dict[str, FloatArray]:
    """Head and eyes in degrees, eyes as seen from the head."""
    found: dict[str, FloatArray] = {}
    for name, (column, sign) in HEAD.items():
        radians = table.column(column)
        if radians is not None:
            found[name] = sign * np.degrees(radians)
    for eye, gaze in EYES.items():
        x, y, z = (table.column(f"{gaze}_{axis}") for axis in "xyz")
        if x is not None and y is not None and z is not None:
            found[f"{eye}.yaw"] = np.degrees(np.arctan2(x, -z)) - found.get("head.yaw", 0.0)
            found[f"{eye}.pitch"] = np.degrees(np.arctan2(-y, -z)) - found.get("head.pitch", 0.0)
    return found

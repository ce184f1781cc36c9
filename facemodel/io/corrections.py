"""What is sculpted on top of solved fields, as records and arrays of a project file."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np
from numpy.typing import NDArray

from facemodel.io.damage import DamageError
from facemodel.io.members import Members
from facemodel.io.schema import CorrectionRecord
from facemodel.sculpting.correction import FARTHEST, Correction, Corrections

FOLDER = "corrections"


def corrections_json(corrections: Corrections) -> list[dict[str, Any]]:
    """What `CorrectionRecord` reads, in the order of `correction_arrays`."""
    return [
        {"field": name, "amount": float(each.amount), "on": bool(each.on)} for name, each in sorted(corrections.items())
    ]


def correction_arrays(corrections: Corrections) -> dict[str, NDArray[Any]]:
    """The arrays by member name: of every correction the vertices that it moves, and how."""
    arrays: dict[str, NDArray[Any]] = {}
    for number, (_, each) in enumerate(sorted(corrections.items())):
        arrays[f"{FOLDER}/{number}/vertices"] = each.vertices.astype(np.int32)
        arrays[f"{FOLDER}/{number}/moved"] = each.moved
    return arrays


def without_corrections(arrays: Mapping[str, NDArray[Any]]) -> dict[str, NDArray[Any]]:
    """The other arrays of a file."""
    return {name: array for name, array in arrays.items() if not name.startswith(f"{FOLDER}/")}


def corrections_of(
    records: Sequence[CorrectionRecord], arrays: Mapping[str, NDArray[Any]], count: int
) -> dict[str, Correction]:
    """The corrections of a file, for a skin of so many vertices.

    Raises
    ------
    DamageError
        If an array is missing, left over, of another shape, or out of range, or two are of one field.
    """
    members = Members({name: array for name, array in arrays.items() if name.startswith(f"{FOLDER}/")})
    found: dict[str, Correction] = {}
    for number, record in enumerate(records):
        place = f"{FOLDER}/{number}"
        if record.field in found:
            raise DamageError(f"project.json, corrections[{number}]", f"names the field “{record.field}” once more")
        vertices = members.indices(f"{place}/vertices", (None,), count)
        if np.any(np.diff(vertices) <= 0):
            raise DamageError(f"{place}/vertices.npy", "does not name each vertex once, in order")
        moved = members.floats(f"{place}/moved", (len(vertices), 3), -FARTHEST, FARTHEST).astype(np.float32)
        found[record.field] = Correction(vertices, moved, record.amount, record.on)
    members.finish()
    return dict(sorted(found.items()))

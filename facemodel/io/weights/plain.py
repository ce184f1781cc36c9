"""A plain table: a column of times, and one for every action unit, field or rigid motion by its name."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from facemodel.actions import ActionUnit, resolve
from facemodel.animation.capture import Capture
from facemodel.animation.channels import RIGID
from facemodel.errors import UnknownNameError
from facemodel.io.damage import DamageError
from facemodel.io.weights.table import read_table
from facemodel.io.weights.timing import even, kept

TIMES = ("time", "seconds", "timestamp", "t")
FRAMES = ("frame", "frames")
IGNORED = ("index",)


def read_plain(data: bytes, units: Sequence[ActionUnit], rate: float | None = None) -> Capture:
    """A capture from the bytes of a table whose headings are names of action units, fields or rigid motions.

    Raises
    ------
    DamageError
        If no heading is one of these, or it goes back in time.
    """
    table = read_table(data, lambda name: name.casefold() not in IGNORED)
    own = {*TIMES, *FRAMES}
    columns = [name for name in table.names if name.casefold() not in own]
    fields = {name: _fields(name, units) for name in columns}
    known = [name for name in columns if fields[name]]
    if not known:
        raise DamageError(
            "line 1",
            f"names nothing that this face can do ({', '.join(columns[:5]) or 'it has no heading'})",
            "name columns as action units are, such as 12, 12L or head.yaw, or choose another mapping",
        )
    unknown = [name for name in columns if not fields[name]]
    notes = (f"Columns that this face has nothing for were left out: {', '.join(unknown)}.",) if unknown else ()
    at = {name: k for k, name in enumerate(table.names)}
    channels = [field for name in known for field in fields[name]]
    values = np.stack([table.values[:, at[name]] for name in known for _ in fields[name]], axis=1)
    found = even(table.column(*TIMES), values, table.lines, rate)
    return Capture(
        "plain", tuple(channels), kept(found.values), found.rate, found.start, (*table.notes, *notes, *found.notes)
    )


def _fields(name: str, units: Sequence[ActionUnit]) -> tuple[str, ...]:
    if name in RIGID:
        return (name,)
    try:
        return resolve(name, units)
    except UnknownNameError:
        return ()

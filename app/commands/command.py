"""What every step has that can be done to a project and undone."""

from __future__ import annotations

import dataclasses
from collections.abc import Iterator, Mapping
from typing import Any, Protocol

import numpy as np

from facemodel.project import Project

ITEM_BYTES = 200
"""About what one small value of a step takes, with its name; only the order of magnitude counts."""


class Command(Protocol):
    """Something that can be done to a project and undone."""

    @property
    def label(self) -> str:
        """What a person calls it, as in “Undo …”."""

    @property
    def gesture(self) -> str:
        """Steps with the same gesture in a row are one step; empty for a step of its own."""

    @property
    def cost(self) -> int:
        """Bytes that only this command keeps alive."""

    @property
    def changes(self) -> bool:
        """Whether it does anything."""

    def do(self, project: Project) -> Project:
        """The project with it done."""

    def undo(self, project: Project) -> Project:
        """The project as it was, to the last bit; takes what `do` gave."""

    def joined(self, later: Command) -> Command | None:
        """Both this and a later command as one step, or none where each is a step of its own."""


def array_bytes(value: Any) -> int:
    """Bytes of all arrays that a frozen value holds, at any depth."""
    return sum(array.nbytes for array in _arrays(value))


def _arrays(value: Any) -> Iterator[np.ndarray[Any, Any]]:
    if isinstance(value, np.ndarray):
        yield value
    elif isinstance(value, tuple):
        for item in value:
            yield from _arrays(item)
    elif isinstance(value, Mapping):
        for item in value.values():
            yield from _arrays(item)
    elif dataclasses.is_dataclass(value):
        for member in dataclasses.fields(value):
            yield from _arrays(getattr(value, member.name))

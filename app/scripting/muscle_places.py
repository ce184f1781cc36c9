"""Where a muscle lies, in scripts: its fibres, its ring, and the handles that the mouse drags."""

from __future__ import annotations

from collections.abc import Callable, Sequence

import numpy as np

from app.scripting.desk import ScriptDesk
from facemodel.errors import MuscleError
from facemodel.laying import collection, rings
from facemodel.laying.fibres import (
    End,
    added_fibre,
    bent,
    laid_fibre,
    removed_fibre,
    reordered,
    snapped,
    with_end,
    with_via,
    without_via,
)
from facemodel.laying.handles import dragged, handles
from facemodel.laying.rings import Axis, Sector
from facemodel.muscles import Muscle
from fem.types import FloatArray

Place = Sequence[float] | FloatArray
"""A point, three millimetres."""


class PlacedMuscle:
    """What of a muscle lies somewhere; every call is one step, and a linked partner follows."""

    _desk: ScriptDesk
    _key: str

    @property
    def value(self) -> Muscle:
        """The muscle as it is now, a frozen value."""
        return collection.muscle_of(self._desk.project, self._key)

    def move(self, end: End, to: Place, fibre: int = 0, *, snap: bool = True) -> None:
        """Move the origin to the bone nearest to a point, or the attachment to the nearest vertex of the skin.

        Both ends of a fold lie on the skin.  Without ``snap`` the end lies where it is told.
        """
        face, place = self._desk.project.face, _point(to)
        if snap:
            place = snapped(self.value, end, face, place)
        self._change(lambda muscle: with_end(muscle, fibre, end, place), "Move")

    def bend(self, through: Place, fibre: int = 0, at: int | None = None) -> None:
        """Lead a fibre through one more point, or move the one that it goes through already, by its number."""
        place = _point(through)
        if at is None:
            self._change(lambda muscle: bent(muscle, fibre, place)[0], "Bend")
        else:
            self._change(lambda muscle: with_via(muscle, fibre, at, place), "Bend")

    def straighten(self, fibre: int = 0, at: int = 0) -> None:
        """Take a point out that a fibre goes through."""
        self._change(lambda muscle: without_via(muscle, fibre, at), "Straighten")

    def add_fibre(self, origin: Place, attachment: Place) -> None:
        """Give it one more central fibre."""
        fibre = laid_fibre(self._desk.project.face, _point(origin), _point(attachment))
        self._change(lambda muscle: added_fibre(muscle, fibre), "Add fibre to")

    def remove_fibre(self, fibre: int) -> None:
        """Take a central fibre out."""
        self._change(lambda muscle: removed_fibre(muscle, fibre), "Remove fibre of")

    def order_fibre(self, fibre: int, to: int) -> None:
        """Put a central fibre at another place in the fan."""
        self._change(lambda muscle: reordered(muscle, fibre, to), "Order fibres of")

    def centre(self, at: Place) -> None:
        """Move the middle of its ring."""
        self._change(lambda muscle: rings.with_centre(muscle, _point(at)), "Move")

    def tip(self, axis: Axis, to: Place) -> None:
        """Move the tip of a half axis of its ring; the other one turns along."""
        self._change(lambda muscle: rings.with_axis(muscle, axis, _point(to)), "Stretch")

    def stretch(self, axis: Axis, length: float) -> None:
        """Give a half axis of its ring another length, millimetres."""
        self._change(lambda muscle: rings.with_length(muscle, axis, length), "Stretch")

    def half(self, sector: Sector) -> None:
        """Keep the whole of its ring, or the half towards ``left``, ``right``, ``up`` or ``down``."""
        if sector not in rings.SECTORS:
            raise MuscleError(f"There is no part “{sector}” of a ring; choose one of {', '.join(rings.SECTORS)}.")
        self._change(lambda muscle: rings.with_sector(muscle, sector), "Part of")

    def handles(self) -> tuple[tuple[str, int, int, FloatArray], ...]:
        """What a hand can drag: the part, the number of the fibre, which of several, and where (3,) it is."""
        found = handles(self.value, self._desk.project.face)
        return tuple((each.part, each.fibre, each.place, each.point.copy()) for each in found)

    def drag(self, part: str, to: Place, fibre: int = 0, place: int = 0) -> None:
        """Drag a handle as the mouse does: ends snap, numbers stop at the ends of their range."""
        face, goal = self._desk.project.face, _point(to)
        meant = [h for h in handles(self.value, face) if (h.part, h.fibre, h.place) == (part, fibre, place)]
        if not meant:
            known = ", ".join(dict.fromkeys(each.part for each in handles(self.value, face)))
            raise MuscleError(f"“{self._key}” has no handle “{part}” there; it has {known}.")
        self._change(lambda muscle: dragged(muscle, meant[0], goal, face), "Drag")

    def _change(self, change: Callable[[Muscle], Muscle], verb: str) -> None:
        changed = change(self.value)
        self._desk.edit(lambda project: collection.with_muscle(project, changed), f"{verb} {changed.title}")


def _point(given: Place) -> FloatArray:
    place = np.array(given, dtype=np.float64)
    if place.shape != (3,) or not np.isfinite(place).all():
        raise MuscleError(f"“{given}” is no place; give x, y and z in millimetres.")
    return place

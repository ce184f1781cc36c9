"""Lay folds by hand: a line drawn on the skin, along which muscles end and it creases."""

from __future__ import annotations

from dataclasses import replace
from typing import ClassVar

import numpy as np

from app.tools.laying import group_at
from app.tools.muscle_hand import Drag, MuscleHand
from app.tools.pointer import Pointer
from facemodel.errors import MuscleError
from facemodel.laying.collection import drafted_muscle
from facemodel.laying.places import on_skin
from facemodel.muscles import Fibre, Muscle
from fem.types import FloatArray

APART = 7.0
"""Millimetres between the points that a drawn line goes through: nearer ones would keep the hand's trembling."""

CREASE, DRAWN_IN = 4.0, 0.06
"""Width of a new fold, millimetres, and its strength, N/mm^2: a cheek then folds two millimetres deep."""


class FoldTool(MuscleHand):
    """Press on the skin and draw along it lays a fold; press on a handle of a selected muscle drags it."""

    id: ClassVar[str] = "fold"
    title: ClassVar[str] = "Fold"
    shortcut: ClassVar[str] = "Shift+F"
    hint: ClassVar[str] = "Press where the skin is to fold and draw along the crease · drag a point of it to bend it"

    def begun(self, pointer: Pointer) -> Drag | None:
        """From a place on the skin: a new fold along what is drawn."""
        if pointer.skin is None:
            return None
        line = [pointer.skin.position]

        def made(now: Pointer) -> Muscle | None:
            if now.skin is None:
                raise MuscleError("A fold lies on the skin; let go over the face.")
            end = now.skin.position
            if np.linalg.norm(end - line[-1]) >= APART:
                line.append(end)
            return self._drafted([*_without_near(line, end), end])

        return Drag("Lay", made)

    def _drafted(self, line: list[FloatArray]) -> Muscle:
        face = self._project.face
        first, *between, last = (on_skin(face, point, "surface") for point in line)
        group = group_at(face, last)
        fibre = Fibre(first, last, tuple(between))
        muscle = drafted_muscle(self._project, f"{group.capitalize()} fold", group, fibres=(fibre,), model="fold")
        return replace(muscle, width=CREASE, strength=DRAWN_IN, count=1)


def _without_near(line: list[FloatArray], end: FloatArray) -> list[FloatArray]:
    """The points of a line before its end: the first, and those that are far enough from it."""
    return [line[0], *(point for point in line[1:] if np.linalg.norm(end - point) >= APART / 2)]

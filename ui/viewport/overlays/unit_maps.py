"""What the Actions workspace lays on the skin: pull, motion or sculpt of the unit in hand, or what was checked."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from app.document import Document
from app.solo import unit_in_hand
from app.solved import moved_by
from app.view_state import ViewState
from facemodel.actions import ActionUnit
from facemodel.solution import Solution
from fem.types import Float32Array, FloatArray
from ui.viewport.look import at_points
from ui.viewport.muscle_fields import FieldForces
from ui.viewport.overlays.amounts import amount_legend, amount_paint, top_of
from ui.viewport.overlays.overlay import Drawn
from ui.widgets.legend_card import LegendCard
from ui.workspaces.workspace import Parts

KPA = 1000.0
"""Kilopascal in a newton per square millimetre."""

LEAST = 0.01
"""Millimetres, or kilopascal; the end of the range where there is next to nothing."""

SHOWN = ("workspace", "unit", "mixing", "influence", "unit_map", "apart_map")
"""Members of the view state that decide what is laid on the skin."""


@dataclass(frozen=True, eq=False)
class Amounts:
    """Amounts at all drawn points, and what they are."""

    title: str
    unit: str
    values: FloatArray | Float32Array


class UnitMaps:
    """Colours and legend; the check goes before the pull, and that before motion and sculpted layer."""

    def __init__(self, parts: Parts) -> None:
        self._document, self._view = parts.context.document, parts.context.view
        self._check = parts.check
        self._scene, self._canvas = parts.viewport.scene, parts.viewport.canvas
        self._legend = LegendCard(parts.viewport)
        self._on = False
        document = self._document
        for signal in (
            document.project_changed,
            document.solution_changed,
            document.units_changed,
            document.muscles_changed,
            self._check.changed,
        ):
            signal.connect(self._read)
        self._view.changed.connect(self._look)

    def switch(self, on: bool) -> None:
        """Begin to draw, or give the skin back."""
        self._on = on
        self._scene.coat = self._coat if on else None
        self._read()

    def _look(self, now: ViewState, before: ViewState) -> None:
        if any(getattr(now, name) != getattr(before, name) for name in SHOWN):
            self._read()

    def _read(self, *_now: object) -> None:
        """Take over what there is now, and draw it."""
        if not self._on and self._legend.legend is None:
            return
        self._scene.repaint()
        drawn = self._scene.drawn
        amounts = self._amounts(drawn) if self._on and drawn is not None else None
        top = top_of(amounts.values, LEAST) if amounts is not None else 1.0
        self._legend.show_legend(None if amounts is None else amount_legend(amounts.title, amounts.unit, top))
        self._canvas.ask_frame()

    def _coat(self, drawn: Drawn) -> Float32Array | None:
        amounts = self._amounts(drawn)
        return None if amounts is None else amount_paint(amounts.values, top_of(amounts.values, LEAST))

    def _amounts(self, drawn: Drawn) -> Amounts | None:
        """What is laid on the skin now; nothing while what is drawn is of another solution than the document."""
        state, count = self._view.state, len(drawn.figure.posed.points)
        found = self._check.found
        if found is not None and state.apart_map and len(found.apart) <= count:
            whole = np.zeros(count)
            whole[: len(found.apart)] = found.apart
            return Amounts("Superposed and solved in full apart by", "mm", whole)
        unit = unit_in_hand(self._document.project, state)
        if unit is None:
            return None
        if state.influence:
            return self._pull(unit, drawn)
        made = MAPS.get(state.unit_map)
        amounts = made(self._document, unit) if made is not None else None
        return amounts if amounts is not None and len(amounts.values) == count else None

    def _pull(self, unit: ActionUnit, drawn: Drawn) -> Amounts:
        """How hard the muscles of a unit pull at 1."""
        force = FieldForces(drawn.project).of(unit.full)
        display = drawn.figure.posed.basis.display
        size = at_points(drawn.project.face, display, np.linalg.norm(force, axis=1))
        return Amounts(f"Pull of AU {unit.number}", "kPa", KPA * size)


def _motion(document: Document, unit: ActionUnit) -> Amounts | None:
    """How far a unit moves the skin at 1."""
    moved = _moved(document.solution, unit)
    return None if moved is None else Amounts(f"Moved by AU {unit.number}", "mm", np.linalg.norm(moved, axis=1))


def _sculpted(document: Document, unit: ActionUnit) -> Amounts | None:
    """How far what is sculpted on a unit moves the skin at 1."""
    whole, solved = _moved(document.solution, unit), _moved(document.solved, unit)
    if whole is None or solved is None:
        return None
    return Amounts(f"Sculpted on AU {unit.number}", "mm", np.linalg.norm(whole - solved, axis=1))


def _moved(solution: Solution | None, unit: ActionUnit) -> Float32Array | None:
    return None if solution is None else moved_by(solution.basis, unit.full)


MAPS: dict[str, Callable[[Document, ActionUnit], Amounts | None]] = {"motion": _motion, "sculpted": _sculpted}

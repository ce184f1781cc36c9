"""Which expression is to be seen: the sliders', one action unit alone, or a jaw that is tried."""

from __future__ import annotations

from collections.abc import Sequence

from app.document import Document
from app.view_state import ViewState
from facemodel.actions import ActionUnit, Expression
from facemodel.project import Project

SCULPT = "sculpt"
"""Id of the tool that sculpts the unit in hand."""


def unit_in_hand(project: Project, state: ViewState) -> ActionUnit | None:
    """The action unit that is worked on; none where whole expressions are, or in another workspace."""
    if state.workspace != "actions" or state.mixing:
        return None
    return next((unit for unit in project.units if unit.number == state.unit), None)


def alone(project: Project, state: ViewState, shown: Expression) -> Expression | None:
    """The unit in hand at 1 where it is to be seen alone, or is worked on and would not be seen in what is shown."""
    unit = unit_in_hand(project, state)
    if unit is None:
        return None
    unseen = not any(shown.get(field) for field in unit.fields)
    if state.solo or (unseen and (state.trying or state.tool == SCULPT)):
        return unit.full
    return None


def seen(document: Document, state: ViewState) -> Expression:
    """What a document shows, or in the Actions workspace the unit in hand at 1 where that is to be seen alone.

    While a jaw is tried in the Skull workspace the skin follows as far as a unit knows how: by the unit that opens the
    jaw furthest and moves no muscle.
    """
    if state.jaw_tried:
        opening = _opening(document.project.units)
        return {} if opening is None else dict.fromkeys(opening[0].fields, state.jaw_open / opening[1])
    lonely = alone(document.project, state, document.shown)
    return document.shown if lonely is None else lonely


def _opening(units: Sequence[ActionUnit]) -> tuple[ActionUnit, float] | None:
    """The unit that opens the jaw furthest with no muscle, and by how many degrees."""
    found = [(unit, unit.jaw.degrees) for unit in units if unit.jaw and unit.jaw.degrees > 0 and not unit.muscles]
    return max(found, key=lambda each: each[1], default=None)

"""What can be done with what is sculpted on the action unit in hand, and with the unit's mirror image."""

from __future__ import annotations

from app.actions.action import Action
from app.actions.context import Context
from app.authoring.mirroring import mirrored_unit, one_sided
from app.authoring.sculpting import SIDE_TITLES, cleared, copied_to, layers_of, symmetric
from app.authoring.units import unit_of
from facemodel.actions import Side
from facemodel.painting.mirror import mirror_partners
from ui.panels.actions.unit_deeds import MENU, in_hand
from ui.panels.unit_text import unit_title


def is_sculpted(context: Context) -> bool:
    """Whether something is sculpted on the unit in hand."""
    unit = in_hand(context)
    return unit is not None and bool(layers_of(context.document.project, unit))


def clear(context: Context) -> None:
    """Take off all that is sculpted on the unit in hand."""
    unit = in_hand(context)
    if unit is not None:
        context.document.edit(cleared(context.document.project, unit.number), f"Clear the sculpt of {unit_title(unit)}")


def fold(context: Context, source: Side) -> None:
    """Make the other side of what is sculpted the mirror image of one side."""
    unit, project = in_hand(context), context.document.project
    if unit is not None:
        made = symmetric(project, unit.number, source, mirror_partners(project.face))
        context.document.edit(made, f"Mirror the {SIDE_TITLES[source]} sculpt of {unit_title(unit)}")


def copy(context: Context, number: int) -> None:
    """Put what is sculpted on the unit in hand on another one."""
    unit, project = in_hand(context), context.document.project
    if unit is not None:
        other = unit_of(project, number)
        context.document.edit(copied_to(project, unit.number, number), f"Copy the sculpt to {unit_title(other)}")
        context.host.show_message(f"AU {number} {unit_title(other)} now has what is sculpted on AU {unit.number}.")


def turn_over(context: Context) -> None:
    """Make the unit in hand its mirror image."""
    unit, project = in_hand(context), context.document.project
    if unit is not None:
        made = mirrored_unit(project, unit.number, mirror_partners(project.face))
        context.document.edit(made, f"Mirror {unit_title(unit)}")


def _turns(context: Context) -> bool:
    unit = in_hand(context)
    return unit is not None and one_sided(context.document.project, unit)


SCULPT_ACTIONS = (
    Action(
        "unit.mirror",
        "Mirror action unit",
        turn_over,
        menu=MENU,
        group=4,
        hint="Let it do on the right what it did on the left, and the other way round: jaw and what is sculpted",
        enabled=_turns,
    ),
    Action(
        "sculpt.left",
        "Mirror the sculpt from left to right",
        lambda context: fold(context, "L"),
        menu=MENU,
        group=4,
        hint="Make the right side of what is sculpted the mirror image of the left one",
        enabled=is_sculpted,
    ),
    Action(
        "sculpt.right",
        "Mirror the sculpt from right to left",
        lambda context: fold(context, "R"),
        menu=MENU,
        group=4,
        hint="Make the left side of what is sculpted the mirror image of the right one",
        enabled=is_sculpted,
    ),
    Action(
        "sculpt.clear",
        "Clear the sculpt",
        clear,
        menu=MENU,
        group=4,
        hint="Take off all that is sculpted on the unit; what is solved stays",
        enabled=is_sculpted,
    ),
)
"""For the panel's buttons, the menu bar and the palette."""

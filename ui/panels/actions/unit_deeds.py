"""What can be done with the action unit in hand: duplicate, split, fit, show alone, fill from the table, delete."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from app.actions.action import Action
from app.actions.context import Context
from app.authoring.facs_table import filled_from_facs
from app.authoring.merging import merged
from app.authoring.ordering import listed, placed, stepped
from app.authoring.parting import joined, split
from app.authoring.units import (
    unit_of,
    with_duplicate,
    with_new_unit,
    with_unit,
    without_units,
)
from facemodel.actions import ActionUnit, Group
from ui.panels.unit_text import unit_title

MENU = ("Edit", "Action unit")

STILL = 1e-3
"""Millimetres; a unit that moves the skin by less has nothing that could be made larger."""


def in_hand(context: Context) -> ActionUnit | None:
    """The unit that is worked on."""
    number = context.view.state.unit
    return next((unit for unit in context.document.project.units if unit.number == number), None)


def reached(context: Context, unit: ActionUnit) -> float | None:
    """Largest displacement of the skin by a unit, millimetres; none where it is not solved as it is now."""
    document = context.document
    fields = [name for name in unit.fields if document.solution is not None and name in document.solution.basis.index]
    if document.solution is None or not fields or document.stale_fields & set(unit.fields):
        return None
    return max(document.solution.basis.peak(name) for name in fields)


def new(context: Context) -> None:
    """Make a unit that moves nothing yet, and take it in hand."""
    unit = in_hand(context)
    project, number = with_new_unit(context.document.project, group=unit.group if unit else "diagonal")
    context.document.edit(project, "New action unit")
    context.view.change(unit=number)


def duplicate(context: Context) -> None:
    """Copy the unit in hand, and take the copy."""
    unit = _wanted(context)
    project, number = with_duplicate(context.document.project, unit.number)
    context.document.edit(project, f"Duplicate {unit_title(unit)}")
    context.view.change(unit=number)


def part(context: Context) -> None:
    """Let left and right of the unit in hand move apart, or as one."""
    unit = _wanted(context)
    act = joined if unit.paired else split
    label = f"{'Join' if unit.paired else 'Split'} sides of {unit_title(unit)}"
    context.document.edit(act(context.document.project, unit.number), label)


def fit(context: Context) -> None:
    """Make the unit in hand move the skin as far as it is meant to."""
    unit = _wanted(context)
    moved = reached(context, unit)
    if moved is None or moved < STILL or unit.amplitude <= 0:
        return
    factor = unit.amplitude / moved
    jaw = None if unit.jaw is None else replace(unit.jaw, degrees=unit.jaw.degrees * factor)
    muscles = {name: weight * factor for name, weight in unit.muscles.items()}
    scaled = replace(unit, muscles=muscles, jaw=jaw)
    project = with_unit(context.document.project, scaled)
    context.document.edit(project, f"Fit {unit_title(unit)} to {unit.amplitude:g} mm")


def fill(context: Context) -> None:
    """Give all units of the FACS table its weights, and make those that are missing."""
    filling = filled_from_facs(context.document.project)
    context.document.edit(filling.project, "Fill from the FACS table")
    if filling.missing:
        numbers = ", ".join(map(str, sorted(filling.missing)))
        context.host.show_message(f"Filled from the FACS table; for AU {numbers} this face lacks some muscles.")
    else:
        context.host.show_message("Filled all action units from the FACS table.")


def place(context: Context, number: int, group: Group, before: int | None) -> None:
    """List a unit in front of another one, or at the end of a group."""
    project = context.document.project
    made = placed(project, number, group, before)
    context.document.edit(made, f"Move {unit_title(unit_of(project, number))}")
    context.view.change(unit=number)


def step(context: Context, by: int) -> None:
    """List the unit in hand one place further up (-1) or down (1)."""
    unit = _wanted(context)
    context.document.edit(stepped(context.document.project, unit.number, by), f"Move {unit_title(unit)}")


def merge(context: Context) -> None:
    """Let the unit in hand do so much of what it and another one do, in place of both."""
    unit, project = _wanted(context), context.document.project
    asked = context.host.ask_merge(unit, partners(context))
    if asked is None:
        return
    gone = unit_of(project, asked.other)
    made = merged(project, unit.number, asked.other, asked.own, asked.share)
    context.document.edit(made, f"Merge {unit_title(gone)} into {unit_title(unit)}")
    context.host.show_message(
        f"AU {unit.number} now does {asked.own:.0%} of itself and {asked.share:.0%} of AU {gone.number}."
    )


def partners(context: Context) -> tuple[ActionUnit, ...]:
    """The units that the one in hand can be merged with."""
    unit = in_hand(context)
    units = listed(context.document.project)
    return tuple(each for each in units if unit is not None and each is not unit and each.paired == unit.paired)


def delete(context: Context) -> None:
    """Delete the unit in hand; expressions let go of it."""
    unit = _wanted(context)
    numbers = [each.number for each in context.document.project.units]
    place = numbers.index(unit.number)
    left = numbers[:place] + numbers[place + 1 :]
    users = [
        before.title
        for before, after in zip(
            context.document.project.emotions,
            without_units(context.document.project, [unit.number]).emotions,
            strict=True,
        )
        if before.weights != after.weights
    ]
    context.document.edit(without_units(context.document.project, [unit.number]), f"Delete {unit_title(unit)}")
    context.view.change(unit=left[min(place, len(left) - 1)] if left else None)
    used = f", which {', '.join(users)} used" if users else ""
    context.host.show_message(f"Deleted AU {unit.number} {unit_title(unit)}{used}. Ctrl+Z brings it back.")


def _wanted(context: Context) -> ActionUnit:
    unit = in_hand(context)
    return unit if unit is not None else unit_of(context.document.project, context.view.state.unit or 0)


def _any(context: Context) -> bool:
    return in_hand(context) is not None


def _fits(context: Context) -> bool:
    unit = in_hand(context)
    if unit is None or unit.amplitude <= 0:
        return False
    moved = reached(context, unit)
    return moved is not None and moved >= STILL


def _steps(by: int) -> Callable[[Context], bool]:
    def can(context: Context) -> bool:
        rows, unit = listed(context.document.project), in_hand(context)
        return unit is not None and 0 <= rows.index(unit) + by < len(rows)

    return can


def _paired(context: Context) -> bool:
    unit = in_hand(context)
    return unit is not None and unit.paired


UNIT_ACTIONS = (
    Action("unit.new", "New action unit", new, menu=MENU, hint="Make a unit that moves nothing yet"),
    Action("unit.duplicate", "Duplicate action unit", duplicate, menu=MENU, hint="Copy the unit", enabled=_any),
    Action(
        "unit.merge",
        "Merge with another action unit…",
        merge,
        menu=MENU,
        hint="Make one unit of two: it does what both did, each in a share of its own",
        enabled=lambda context: bool(partners(context)),
    ),
    Action("unit.delete", "Delete action unit", delete, menu=MENU, hint="Delete the unit", enabled=_any),
    Action(
        "unit.split",
        "Left and right apart",
        part,
        menu=MENU,
        group=1,
        hint="Give the unit a field for each side, or one for both",
        kind="toggle",
        enabled=_any,
        checked=_paired,
    ),
    Action(
        "unit.fit",
        "Fit to its amplitude",
        fit,
        menu=MENU,
        group=1,
        hint="Scale all activations so that the skin moves as far as the unit is meant to",
        enabled=_fits,
    ),
    Action(
        "unit.solo",
        "Show alone",
        lambda context: context.view.toggle("solo"),
        menu=MENU,
        group=1,
        shortcut="/",
        hint="Show this unit at 1 and nothing else; the sliders stay as they are",
        kind="toggle",
        enabled=_any,
        checked=lambda context: context.view.state.solo,
    ),
    Action(
        "unit.fill",
        "Fill from the FACS table",
        fill,
        menu=MENU,
        group=2,
        hint="Give every unit the muscles and weights of FACS, in one step",
    ),
    Action(
        "unit.up",
        "Move action unit up",
        lambda context: step(context, -1),
        menu=MENU,
        group=3,
        hint="List the unit one place further up (Alt+Up in the list)",
        enabled=_steps(-1),
    ),
    Action(
        "unit.down",
        "Move action unit down",
        lambda context: step(context, 1),
        menu=MENU,
        group=3,
        hint="List the unit one place further down (Alt+Down in the list)",
        enabled=_steps(1),
    ),
)
"""For the panel's buttons, the menu bar and the palette."""

"""What the command palette offers for what was typed."""

from __future__ import annotations

from app.actions.action import Action
from app.actions.context import Context
from app.palette import rank, typed_expression
from ui.widgets.command_palette import PaletteEntry
from ui.window.action_binding import ActionBinding

KINDS = {"unit": "Action unit", "muscle": "Muscle", "expression": "Expression", "timeline": "Animation"}
"""What actions without a menu are, by the first part of their id."""


def palette_entries(query: str, context: Context, binding: ActionBinding) -> tuple[PaletteEntry, ...]:
    """An expression, if one was typed, and every action that matches, the best first."""
    typed = typed_expression(query, context) if "=" in query else None
    first = (PaletteEntry(typed.title, "Expression", payload=typed),) if typed else ()
    matches = rank(query, binding.actions)
    return (*first, *(_entry(match.action, match.letters, context, binding) for match in matches))


def _entry(action: Action, letters: tuple[int, ...], context: Context, binding: ActionBinding) -> PaletteEntry:
    section = " › ".join(action.menu) or KINDS.get(action.id.split(".")[0], "")
    enabled = action.enabled(context)
    return PaletteEntry(action.title, section, binding.keys(action), letters, enabled, action)

"""Undo, redo, and the expression as a whole."""

from __future__ import annotations

from app.actions.action import Action
from app.actions.context import Context
from app.expression_text import format_expression, parse_expression


def _undo_title(context: Context) -> str:
    document = context.document
    if document.held:
        return "Undo"
    return f"Undo {document.history.to_undo.label}" if document.history.to_undo else "Undo"


def _redo_title(context: Context) -> str:
    step = context.document.history.to_redo
    return f"Redo {step.label}" if step else "Redo"


def _copy(context: Context) -> None:
    text = format_expression(context.document.shown, context.document.project.units)
    context.host.set_clipboard(text)
    context.host.show_message(f"Copied {text}")


def _paste(context: Context) -> None:
    set_expression_text(context, context.host.clipboard(), "Paste expression")


def set_expression_text(context: Context, text: str, label: str) -> None:
    """Show the expression that a text such as ``12=0.8 1L=0.5`` means, and nothing else."""
    context.document.set_expression(parse_expression(text, context.document.project.units), label)


EDIT_ACTIONS = (
    Action(
        "edit.undo",
        "Undo",
        lambda context: context.document.undo(),
        menu=("Edit",),
        shortcut="Ctrl+Z",
        hint="Take the last step back",
        enabled=lambda context: context.document.held or context.document.history.to_undo is not None,
        caption=_undo_title,
        toolbar=True,
    ),
    Action(
        "edit.redo",
        "Redo",
        lambda context: context.document.redo(),
        menu=("Edit",),
        shortcut="Ctrl+Shift+Z",
        also=("Ctrl+Y",),
        hint="Do the step again that was taken back",
        enabled=lambda context: context.document.history.to_redo is not None,
        caption=_redo_title,
        toolbar=True,
    ),
    Action(
        "edit.copy",
        "Copy expression",
        _copy,
        menu=("Edit",),
        group=1,
        shortcut="Ctrl+Shift+C",
        hint="Copy all weights as text such as 12L=0.8 12R=0.8",
    ),
    Action(
        "edit.paste",
        "Paste expression",
        _paste,
        menu=("Edit",),
        group=1,
        shortcut="Ctrl+Shift+V",
        hint="Show the expression in the clipboard, as text such as 12=0.8 1L=50%",
    ),
    Action(
        "edit.reset",
        "Neutral face",
        lambda context: context.document.reset_expression(),
        menu=("Edit",),
        group=2,
        shortcut="0",
        hint="Set every action unit to zero",
        enabled=lambda context: any(context.document.shown.values()),
        toolbar=True,
    ),
    Action(
        "edit.link",
        "Link left and right",
        lambda context: context.view.toggle("linked"),
        menu=("Edit",),
        group=2,
        shortcut="L",
        hint="Move the sliders of both sides together",
        kind="toggle",
        checked=lambda context: context.view.state.linked,
    ),
    Action(
        "edit.search",
        "Find action unit",
        lambda context: context.host.focus_search(),
        menu=("Edit",),
        group=3,
        shortcut="Ctrl+F",
        hint="Search the action units by number, name or muscle",
    ),
    Action(
        "edit.palette",
        "Command palette…",
        lambda context: context.host.show_palette(),
        menu=("Edit",),
        group=3,
        shortcut="Ctrl+Shift+P",
        hint="Find anything that can be done, or type an expression such as 12=0.8",
    ),
)

"""Finished projects to look at and to change."""

from __future__ import annotations

from app.actions.action import Action
from app.actions.context import Context
from app.actions.files import may_leave
from app.examples import EXAMPLES, Example, examples_folder


def open_example(context: Context, example: Example) -> None:
    """Begin with an example, unless the open document is to stay; one that moves plays.

    Raises
    ------
    RisoriusError
        If a file that belongs to it cannot be written; the open document stays.
    """
    if may_leave(context):
        context.document.begin(example.made(examples_folder()))
        context.host.show_message(example.hint)
        if context.document.project.animation.moves:
            context.host.perform()


EXAMPLE_ACTIONS = tuple(
    Action(
        f"file.example.{example.key}",
        example.title,
        lambda context, example=example: open_example(context, example),  # type: ignore[misc]
        menu=("File", "Examples"),
        hint=example.hint,
    )
    for example in EXAMPLES
)

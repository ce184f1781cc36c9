"""What can be done with the selected muscles: duplicate, mirror, link, copy, paste and delete."""

from __future__ import annotations

from collections.abc import Iterable
from dataclasses import replace

from app.actions.action import Action
from app.actions.context import Context
from app.actions.paths import folder
from app.model_comparison import to_compare
from app.tools.locks import refuse_locked
from facemodel.errors import MuscleError
from facemodel.laying.clipboard import muscles_from, muscles_text
from facemodel.laying.collection import (
    added,
    deleted,
    duplicated,
    jaw_muscle,
    on_other_side,
    users_of,
    with_muscle,
)
from facemodel.laying.sides import linked, partner, unlinked
from facemodel.muscles import Muscle
from facemodel.muscles.models import comparable_models
from facemodel.project import Project
from ui.panels.muscles.selection import chosen, in_step, titles, with_partners

MENU = ("Edit", "Muscle")


def selected(context: Context) -> tuple[Muscle, ...]:
    """The selected muscles."""
    return chosen(context.document.project, context.view.state)


def delete(context: Context) -> None:
    """Delete the selected muscles and their linked partners, and say which units contracted them."""
    project = context.document.project
    gone = with_partners(project, selected(context))
    if not free(context, gone):
        return
    outcome = deleted(project, [muscle.key for muscle in gone])
    names = titles(gone)
    context.document.edit(outcome.project, f"Delete {names}")
    context.view.change(muscle="")
    numbers = sorted({number for users in outcome.users.values() for number in users})
    if numbers:
        units = ", ".join(map(str, numbers))
        names = f"{names}, which AU {units} contracted"
    context.host.show_message(f"Deleted {names}. Ctrl+Z brings it back.")


def duplicate(context: Context) -> None:
    """Copy the selected muscles and their linked partners to the same place, and select the copies."""
    muscles = with_partners(context.document.project, selected(context))
    project, keys = duplicated(context.document.project, [muscle.key for muscle in muscles])
    context.document.edit(project, f"Duplicate {titles(muscles)}")
    _select(context, keys)


def mirror(context: Context) -> None:
    """Lay the mirror image of the selected muscles on the other side, in place of what is there."""
    muscles = [muscle for muscle in selected(context) if muscle.side != "M"]
    there = [partner(context.document.project.muscles, muscle) for muscle in muscles]
    if not free(context, [muscle for muscle in there if muscle is not None]):
        return
    project, keys = on_other_side(context.document.project, [muscle.key for muscle in muscles])
    context.document.edit(project, f"{titles(muscles)} to the other side")
    _select(context, keys)


def link(context: Context) -> None:
    """Keep the selected muscles and their partners in step, or no longer."""
    project, muscles = context.document.project, selected(context)
    others = [partner(project.muscles, muscle) for muscle in muscles]
    if not free(context, [muscle for muscle in (*muscles, *others) if muscle is not None]):
        return
    apart = _linked(context)
    for muscle in muscles:
        changed = unlinked(project.muscles, muscle) if apart else linked(project.muscles, muscle, project.face)
        project = replace(project, muscles=changed)
    context.document.edit(project, f"{'Unlink' if apart else 'Link'} sides of {titles(muscles)}")


def copy(context: Context) -> None:
    """Put the selected muscles into the clipboard as text."""
    muscles = selected(context)
    context.host.set_clipboard(muscles_text(muscles, context.document.project.face))
    context.host.show_message(f"Copied {titles(muscles)}")


def paste(context: Context) -> None:
    """Lay the muscles of the clipboard, fitted to this head if they come from another one."""
    muscles = muscles_from(context.host.clipboard(), context.document.project.face)
    project, keys = added(context.document.project, muscles)
    context.document.edit(project, f"Paste {titles(muscles)}")
    _select(context, keys)


def fit(context: Context) -> None:
    """Take the muscles of another head, fitted to this one."""
    project = context.document.project
    fitted = context.host.ask_fitting(project, folder(context))
    if fitted is None:
        return
    after = {muscle.key: muscle for muscle in fitted.project.muscles}
    if free(context, [muscle for muscle in project.muscles if after.get(muscle.key) is not muscle]):
        context.document.edit(fitted.project, "Fit muscles of another head")
        context.host.show_message(" ".join(fitted.fit.sentences))


def new_jaw(context: Context) -> None:
    """Let the skin over the mandible be pushed when the jaw opens, by a muscle of its own."""
    made = jaw_muscle(context.document.project)
    context.document.edit(with_muscle(context.document.project, made), f"Lay {made.title}")
    _select(context, (made.key,))


def compare(context: Context) -> None:
    """Show what the selected muscle does under each of its models, side by side."""
    to_compare(context.document, context.view)
    context.host.compare_models()


def select_all(context: Context) -> None:
    """Select every muscle."""
    _select(context, tuple(muscle.key for muscle in context.document.project.muscles))


def free(context: Context, muscles: Iterable[Muscle]) -> bool:
    """Whether muscles may be changed; the status line says which of them may not."""
    try:
        refuse_locked(context.document.project, context.view.state, muscles)
    except MuscleError as error:
        context.host.show_message(str(error))
        return False
    return True


def users_text(project: Project, muscles: tuple[Muscle, ...]) -> str:
    """Which units contract some muscles."""
    numbers = sorted({number for muscle in muscles for number in users_of(project, muscle.name)})
    if not numbers:
        return "No action unit contracts it yet"
    return f"Contracted by AU {', '.join(map(str, numbers))}"


def _select(context: Context, keys: tuple[str, ...]) -> None:
    if keys:
        context.view.change(muscle=keys[0], others=frozenset(keys[1:]))


def _any(context: Context) -> bool:
    return bool(selected(context))


def _comparable(context: Context) -> bool:
    muscles = selected(context)
    return bool(muscles) and len(comparable_models(muscles[0])) > 1


def _sided(context: Context) -> bool:
    return any(muscle.side != "M" for muscle in selected(context))


def _has_partner(context: Context) -> bool:
    muscles = context.document.project.muscles
    return any(partner(muscles, muscle) is not None for muscle in selected(context))


def _linked(context: Context) -> bool:
    return any(in_step(context.document.project, muscle) for muscle in selected(context))


def _has_muscles(context: Context) -> bool:
    return bool(context.document.project.muscles)


EDITING_ACTIONS = (
    Action("muscle.duplicate", "Duplicate", duplicate, menu=MENU, hint="Copy the selected muscles", enabled=_any),
    Action(
        "muscle.mirror",
        "To the other side",
        mirror,
        menu=MENU,
        hint="Lay the mirror image of the selected muscles on the other side, in place of what is there",
        enabled=_sided,
    ),
    Action(
        "muscle.link",
        "Keep sides in step",
        link,
        menu=MENU,
        hint="Whatever is changed on one side is changed on the other",
        kind="toggle",
        enabled=_has_partner,
        checked=_linked,
    ),
    Action("muscle.copy", "Copy muscles", copy, menu=MENU, group=1, hint="Copy them as text", enabled=_any),
    Action("muscle.paste", "Paste muscles", paste, menu=MENU, group=1, hint="Lay the muscles in the clipboard"),
    Action(
        "muscle.jaw",
        "New jaw force",
        new_jaw,
        menu=MENU,
        hint="A muscle that pushes the skin over the mandible round the jaw’s axis (Choe, Lee and Ko 2001, eq. 3)",
    ),
    Action(
        "muscle.compare",
        "Compare models…",
        compare,
        menu=MENU,
        hint="Show what the muscle does to this face under each model, side by side",
        enabled=_comparable,
    ),
    Action(
        "muscle.fit",
        "Fit muscles from another head…",
        fit,
        menu=MENU,
        hint="Take the muscles of another individual or project, fitted to this head by landmarks",
    ),
    Action("muscle.all", "Select all muscles", select_all, menu=MENU, group=1, enabled=_has_muscles),
    Action(
        "muscle.delete",
        "Delete muscles",
        delete,
        menu=MENU,
        group=3,
        hint="Delete the selected muscles, with the partners that are in step with them",
        enabled=_any,
    ),
)
"""Those that change the project; see `ui.panels.muscles.actions`."""

"""What can be done with a skull as a whole, for the panel, the menus and the palette."""

from __future__ import annotations

from collections.abc import Callable

from app.actions.action import Action
from app.actions.context import Context, FileQuestion
from app.actions.paths import folder
from app.authoring.skull import (
    at_template,
    has_template,
    proposed_region,
    with_jaw_region,
    with_pose,
)
from app.tools.tool import Bench
from facemodel.errors import RisoriusError
from facemodel.face import AT_REST
from facemodel.project import Project
from facemodel.skull.jaw_region import whole_skull

MENU = ("Edit", "Skull")
KIND, SUFFIX, ALSO = "Skull as a mesh", ".obj", (".ply", ".stl")


def import_skull(context: Context, bench: Bench) -> None:
    """Ask for a file, read it in the background, and then fit what is in it."""
    context.view.change(workspace="skull")
    path = context.host.ask_path(FileQuestion("Import skull", KIND, SUFFIX, folder(context), False, ALSO))
    if path is not None:
        bench.importing.read(path, bench.deliver)


def use_template(context: Context) -> None:
    """Go back to the skull that the face is shipped with."""
    change(context, lambda project: at_template(project, context.view.state.origins_follow), "Template skull")


def snap(context: Context, bench: Bench, scales: bool = True) -> None:
    """Lay the bone as deep under the landmarks as the tables say, in the background."""
    bench.snapping.snap(scales, context.view.state.origins_follow, bench.deliver)


def reset(context: Context) -> None:
    """Put the skull back to where it was made."""
    change(context, lambda project: with_pose(project, AT_REST, context.view.state.origins_follow), "Reset skull")


def propose_jaw(context: Context, bench: Bench) -> None:
    """Select the bone that may be jaw."""
    context.view.change(workspace="skull")
    project = context.document.project
    bench.bones.select(project.face.skull, proposed_region(project))


def select_jaw(context: Context, bench: Bench) -> None:
    """Select the bone that is jaw."""
    context.view.change(workspace="skull")
    skull = context.document.project.face.skull
    bench.bones.select(skull, whole_skull(skull).jaw)


def make_jaw(context: Context, bench: Bench) -> None:
    """Make the selected bone the jaw, and all other bone the cranium."""
    region = bench.bones.selected(context.document.project.face.skull)
    if region is not None:
        change(context, lambda project: with_jaw_region(project, region), "Choose the jaw")


def change(context: Context, made: Callable[[Project], Project], label: str) -> None:
    """Change the project as one step, or say why that cannot be."""
    document = context.document
    try:
        document.edit(made(document.project), label)
    except RisoriusError as error:
        context.host.show_error(str(error))


def skull_actions(bench: Bench) -> tuple[Action, ...]:
    """All of it, in the order of its menu."""

    def other(context: Context) -> bool:
        return has_template(context.document.project)

    def moved(context: Context) -> bool:
        return context.document.project.face.skull.placement.pose != AT_REST

    def chosen(context: Context) -> bool:
        return bench.bones.selected(context.document.project.face.skull) is not None

    def at(deed: Callable[[Context, Bench], None]) -> Callable[[Context], None]:
        return lambda context: deed(context, bench)

    return (
        Action("skull.import", "Import skull…", at(import_skull), MENU, 0, hint=IMPORT_HINT),
        Action(
            "skull.template",
            "Template skull",
            use_template,
            MENU,
            0,
            hint=TEMPLATE_HINT,
            enabled=other,
        ),
        Action("skull.snap", "Snap to tissue depths", at(snap), MENU, 1, hint=SNAP_HINT),
        Action("skull.reset", "Reset skull", reset, MENU, 1, hint=RESET_HINT, enabled=moved),
        Action("skull.propose-jaw", "Propose jaw", at(propose_jaw), MENU, 2, hint=PROPOSE_HINT),
        Action("skull.select-jaw", "Select jaw", at(select_jaw), MENU, 2, hint="Select the bone that is jaw now"),
        Action("skull.make-jaw", "Make it the jaw", at(make_jaw), MENU, 2, hint=MAKE_HINT, enabled=chosen),
    )


IMPORT_HINT = "Take a skull from an OBJ, PLY or STL file and fit it to the head by landmarks"
TEMPLATE_HINT = "Go back to the skull that the face is shipped with, where and as it was"
SNAP_HINT = "Lay the bone as deep under the landmarks as tables of tissue depth say"
RESET_HINT = "Put the skull back to where it was made"
PROPOSE_HINT = "Select the bone that may be jaw, by the place of the jaw in the shipped skull"
MAKE_HINT = "Make the selected bone the jaw, and all other bone the cranium"

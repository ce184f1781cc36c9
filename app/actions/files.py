"""Files: begin, open, save and leave, with the questions that belong to it."""

from __future__ import annotations

from pathlib import Path

from app.actions.action import Action
from app.actions.context import Context, FileQuestion
from app.actions.exporting import EXPORT_ACTIONS
from app.actions.paths import folder, with_suffix
from app.actions.scripts import RUN_SCRIPT
from facemodel.errors import ProjectError
from facemodel.faces import face_keys

SUFFIX = ".risorius"
PROJECT = "Risorius project"


def may_leave(context: Context) -> bool:
    """Whether the open document may be put away: it is saved, or the person saves or discards it now."""
    context.document.commit()
    if not context.document.dirty:
        return True
    answer = context.host.ask_unsaved(context.document.name)
    return answer == "discard" or (answer == "save" and save(context))


def open_path(context: Context, path: Path) -> None:
    """Open a project by its path, wherever that comes from; a failure is shown and changes nothing."""
    if not may_leave(context):
        return
    try:
        context.document.open(path)
    except ProjectError as error:
        if not path.exists():
            context.settings.forget(path)
        context.host.show_error(str(error))
        return
    context.settings.remember(path)


def save(context: Context) -> bool:
    """Save to the document's file, or ask for one; whether that was done."""
    path = context.document.path
    return save_as(context) if path is None else _save_to(context, path)


def save_as(context: Context) -> bool:
    """Ask for a file and save to it; whether that was done."""
    start = context.document.path or folder(context) / f"{context.document.project.face.key}{SUFFIX}"
    path = context.host.ask_path(FileQuestion("Save project", PROJECT, SUFFIX, start, writes=True))
    return path is not None and _save_to(context, with_suffix(path, SUFFIX))


def recent_actions(context: Context) -> tuple[Action, ...]:
    """One action for each project of late."""
    return tuple(
        Action(
            f"file.recent.{place}",
            f"{path.stem}  ({path.parent})",
            lambda context, path=path: open_path(context, path),  # type: ignore[misc]
            menu=("File", "Open recent"),
            hint=f"Open {path}",
        )
        for place, path in enumerate(context.settings.preferences.recent)
    )


def new_actions() -> tuple[Action, ...]:
    """One action for each face a project can begin with; the first one has the key."""
    return tuple(
        Action(
            f"file.new.{key}",
            key.capitalize(),
            lambda context, key=key: _new(context, key),  # type: ignore[misc]
            menu=("File", "New"),
            shortcut="" if place else "Ctrl+N",
            hint=f"Begin a new project with the face {key.capitalize()}",
        )
        for place, key in enumerate(face_keys())
    )


def bare_actions() -> tuple[Action, ...]:
    """One action for each face whose head a project can begin with, without muscles, paint and action units."""
    return tuple(
        Action(
            f"file.new-bare.{key}",
            key.capitalize(),
            lambda context, key=key: _new_bare(context, key),  # type: ignore[misc]
            menu=("File", "New bare head"),
            hint=f"Begin with the head of {key.capitalize()} and nothing else: no muscle, no paint, no action unit",
        )
        for key in face_keys()
    )


def _new(context: Context, key: str) -> None:
    if may_leave(context):
        context.document.new(key)


def _new_bare(context: Context, key: str) -> None:
    if may_leave(context):
        context.document.new_bare(key)


def _open(context: Context) -> None:
    path = context.host.ask_path(FileQuestion("Open project", PROJECT, SUFFIX, folder(context), writes=False))
    if path is not None:
        open_path(context, path)


def _save_to(context: Context, path: Path) -> bool:
    try:
        context.document.save(path)
    except ProjectError as error:
        context.host.show_error(str(error))
        return False
    context.settings.remember(path)
    context.host.show_message(f"Saved {path.name}")
    return True


def _save(context: Context) -> None:
    save(context)


def _save_as(context: Context) -> None:
    save_as(context)


OPEN = Action(
    "file.open",
    "Open…",
    _open,
    menu=("File",),
    shortcut="Ctrl+O",
    hint="Open a project from a file",
    toolbar=True,
)

FILE_ACTIONS = (
    Action(
        "file.save",
        "Save",
        _save,
        menu=("File",),
        group=1,
        shortcut="Ctrl+S",
        hint="Save the project to its file",
        enabled=lambda context: context.document.dirty or context.document.held or context.document.path is None,
        toolbar=True,
    ),
    Action(
        "file.save-as",
        "Save as…",
        _save_as,
        menu=("File",),
        group=1,
        shortcut="Ctrl+Shift+S",
        hint="Save the project to another file",
    ),
    *EXPORT_ACTIONS,
    RUN_SCRIPT,
    Action(
        "file.quit",
        "Quit",
        lambda context: context.host.quit(),
        menu=("File",),
        group=4,
        shortcut="Ctrl+Q",
        hint="Close Risorius",
    ),
)

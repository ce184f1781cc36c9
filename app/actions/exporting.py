"""What leaves for other programs: the solved face in each format, and a picture."""

from __future__ import annotations

from pathlib import Path

from app.actions.action import Action
from app.actions.context import Context, FileQuestion
from app.actions.paths import folder, with_suffix
from facemodel.errors import RisoriusError
from facemodel.io.export import EXPORTS, Asked, export_project

PICTURE = ".png"


def export_to(context: Context, path: Path) -> None:
    """Write the face as it is shown in the format of the path's suffix, without its animation.

    Raises
    ------
    RisoriusError
        If it is not solved, or the file cannot be written.
    """
    document = context.document
    document.commit()
    if document.solution is None or document.stale:
        raise RisoriusError("There is nothing to export before this face is solved; choose “Solve now” first.")
    export_project(document.project, document.solution, path, Asked(animated=False))
    context.host.show_message(f"Exported {path.name}")


def _export(context: Context, suffix: str) -> None:
    path = _asked(context, "Export face", EXPORTS[suffix].title, suffix)
    if path is not None:
        export_to(context, path)


def _screenshot(context: Context) -> None:
    path = _asked(context, "Save picture", "PNG picture", PICTURE)
    if path is not None:
        context.host.save_picture(path)
        context.host.show_message(f"Saved {path.name}")


def _asked(context: Context, title: str, kind: str, suffix: str) -> Path | None:
    document = context.document
    name = document.path.stem if document.path else document.project.face.key
    start = folder(context) / f"{name}{suffix}"
    path = context.host.ask_path(FileQuestion(title, kind, suffix, start, writes=True))
    return None if path is None else with_suffix(path, suffix)


def _solved(context: Context) -> bool:
    return context.document.solution is not None and not context.document.stale


EXPORT_ACTIONS = (
    *(
        Action(
            f"file.export{suffix}",
            f"{export.title} ({suffix})…",
            lambda context, suffix=suffix: _export(context, suffix),  # type: ignore[misc]
            menu=("File", "Export"),
            group=2,
            shortcut="Ctrl+E" if suffix == ".glb" else "",
            hint=f"Write {export.holds}",
            enabled=_solved,
        )
        for suffix, export in EXPORTS.items()
    ),
    Action(
        "file.export-animation",
        "Animation…",
        lambda context: context.host.show_export(),
        menu=("File", "Export"),
        group=3,
        shortcut="Ctrl+Shift+E",
        hint="Film the animation, or write it as glTF, USD or numbered meshes",
    ),
    Action(
        "file.screenshot",
        "Save picture…",
        _screenshot,
        menu=("File",),
        group=2,
        shortcut="F12",
        hint="Write what the viewport shows as a PNG picture",
        toolbar=True,
    ),
)

"""Run a script of the user's own against the open document."""

from __future__ import annotations

from pathlib import Path

from app.actions.action import Action
from app.actions.context import Context, FileQuestion
from app.actions.paths import folder
from app.scripting import run_script
from facemodel.errors import ProjectError
from facemodel.io.disk import read_file

LARGEST_SCRIPT = 2**20
"""Bytes; a mebibyte of Python is no script that somebody wrote for a face."""


def run_script_file(context: Context, path: Path) -> None:
    """Run a script from a file as one step; if it raises, its line is told and nothing is changed.

    Raises
    ------
    ProjectError
        If the file cannot be read as text.
    """
    try:
        text = read_file(path, LARGEST_SCRIPT).decode("utf-8-sig")
    except UnicodeDecodeError as error:
        raise ProjectError(f"“{path}” is no text in UTF-8; save the script as such, then run it again.") from error
    outcome = run_script(text, context.document, f"Script {path.stem}", context.view)
    if outcome.error:
        context.host.show_error(f"{path.name}: {outcome.error}")
    else:
        last = outcome.output.strip().rpartition("\n")[2]
        context.host.show_message(f"Ran {path.name}" + (f": {last}" if last else ""))


def _run(context: Context) -> None:
    path = context.host.ask_path(FileQuestion("Run script", "Python script", ".py", folder(context), writes=False))
    if path is not None:
        run_script_file(context, path)


RUN_SCRIPT = Action(
    "file.run-script",
    "Run script…",
    _run,
    menu=("File",),
    group=3,
    hint="Run a Python script of your own on this project, as one step that can be undone",
)

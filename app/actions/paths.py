"""Where file dialogs begin, and what files are called in the end."""

from __future__ import annotations

from pathlib import Path

from app.actions.context import Context


def folder(context: Context) -> Path:
    """The folder of the last file, or the user's own."""
    return context.settings.preferences.folder or Path.home()


def with_suffix(path: Path, suffix: str) -> Path:
    """The path with the ending, if the person left it out."""
    return path if path.suffix.lower() == suffix else path.with_name(path.name + suffix)

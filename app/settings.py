"""The owner of the user's preferences."""

from __future__ import annotations

from pathlib import Path
from typing import Any

from psygnal import Signal

from app.preferences import Preferences, preferences_path, read_preferences, write_preferences
from facemodel.errors import ProjectError


class UserSettings:
    """Holds the `Preferences`, tells when they become others, and writes them at once.

    Parameters
    ----------
    path : where they are kept; the user's configuration folder if not given
    """

    changed = Signal(object, object)
    """(Preferences now, Preferences before)"""
    failed = Signal(str)
    """(sentence) they could not be written; the editor goes on with them all the same."""

    def __init__(self, path: Path | None = None) -> None:
        self._path = path or preferences_path()
        self._preferences, self._notice = read_preferences(self._path)

    @property
    def preferences(self) -> Preferences:
        """What the user chose."""
        return self._preferences

    @property
    def notice(self) -> str:
        """A sentence to show once after the start; empty if all is well."""
        return self._notice

    def change(self, **members: Any) -> None:
        """Change some members; the file is written if that makes a difference."""
        self._become(Preferences.model_validate({**dict(self._preferences), **members}))

    def remember(self, path: Path) -> None:
        """Put a project at the head of the recent ones."""
        self._become(self._preferences.remembering(path))

    def forget(self, path: Path) -> None:
        """Take a project from the recent ones."""
        self._become(self._preferences.forgetting(path))

    def _become(self, preferences: Preferences) -> None:
        before, self._preferences = self._preferences, preferences
        if preferences == before:
            return
        self.changed.emit(preferences, before)
        try:
            write_preferences(preferences, self._path)
        except ProjectError as error:
            self.failed.emit(str(error))

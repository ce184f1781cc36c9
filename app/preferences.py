"""What the editor remembers of its user between two starts: values, and the file they are kept in."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Literal

from platformdirs import user_config_path
from pydantic import BaseModel, ConfigDict, Field, ValidationError

from app.quality import FLUID, QUICKEST, SLOWEST, Quality
from facemodel.errors import ProjectError
from facemodel.io.disk import read_file, replacing

MOST_RECENT = 10
"""Files in the list of recent ones; more do not fit a menu that is read at a glance."""

LARGEST_FILE = 2**20
"""Bytes; preferences take a few thousand, so a file beyond a mebibyte is not ours."""

ThemeName = Literal["dark", "light"]


class Preferences(BaseModel):
    """What the user chose.

    Attributes
    ----------
    theme : colours of the window
    recent : projects opened or saved, latest first
    folder : where the last file dialog was
    geometry, layout : of the window and its docks, in whatever text the window makes of them
    hint_done : the first hint was read or followed
    quality : how finely the face is drawn
    least_rate : frames a second that the automatic quality keeps
    shortcuts : keys by action id where the user changed them; empty for none
    """

    model_config = ConfigDict(frozen=True, extra="ignore")

    theme: ThemeName = "dark"
    recent: tuple[Path, ...] = Field(default=(), max_length=MOST_RECENT)
    folder: Path | None = None
    geometry: str = ""
    layout: str = ""
    hint_done: bool = False
    quality: Quality = "automatic"
    least_rate: float = Field(default=FLUID, ge=SLOWEST, le=QUICKEST)
    shortcuts: dict[str, str] = Field(default_factory=dict)

    def remembering(self, path: Path) -> Preferences:
        """The same with a project at the head of the recent ones."""
        latest = path.absolute()
        others = tuple(other for other in self.recent if other != latest)
        return self.model_copy(update={"recent": (latest, *others)[:MOST_RECENT], "folder": latest.parent})

    def forgetting(self, path: Path) -> Preferences:
        """The same without a project that is gone."""
        gone = path.absolute()
        return self.model_copy(update={"recent": tuple(other for other in self.recent if other != gone)})


def preferences_path() -> Path:
    """The file in the user's configuration folder; ``RISORIUS_CONFIG`` in the environment names another folder."""
    named = os.environ.get("RISORIUS_CONFIG")
    return (Path(named) if named else user_config_path("risorius", appauthor=False)) / "preferences.json"


def read_preferences(path: Path) -> tuple[Preferences, str]:
    """The preferences in a file, and a sentence for the user if it was damaged (else empty).

    A missing file means the defaults.  A damaged one means them too and is kept beside as ``.bak``.
    """
    if not path.exists():
        return Preferences(), ""
    try:
        return Preferences.model_validate_json(read_file(path, LARGEST_FILE)), ""
    except (ValidationError, ProjectError):
        return Preferences(), _set_aside(path)


def write_preferences(preferences: Preferences, path: Path) -> None:
    """Replace the file.

    Raises
    ------
    ProjectError
        If that is not possible; the previous file stays.
    """
    try:
        path.parent.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise ProjectError(
            f"“{path}” cannot be saved: the system says “{error.strerror}”; allow writing to its folder."
        ) from error
    with replacing(path) as stream:
        stream.write(preferences.model_dump_json(indent=2).encode())


def _set_aside(path: Path) -> str:
    kept = path.with_name(path.name + ".bak")
    try:
        os.replace(path, kept)
    except OSError as error:
        return (
            f"The preferences in “{path}” cannot be read and not be moved aside ({error.strerror}); "
            "the defaults are used, delete the file to keep new ones."
        )
    return f"The preferences were damaged, so the defaults are used; the damaged file is kept as “{kept}”."

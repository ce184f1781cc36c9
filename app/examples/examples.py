"""The examples that there are."""

from __future__ import annotations

from pathlib import Path

from app.examples.demo import demo_project
from app.examples.example import Example
from app.examples.line import line_project
from app.examples.smile import smile_project
from app.examples.timing import timing_project
from facemodel.errors import ProjectError, UnknownNameError
from facemodel.folders import cache_folder
from facemodel.project import Project


def _demo(folder: Path) -> Project:
    return demo_project(folder / "demo-line.wav")


EXAMPLES: tuple[Example, ...] = (
    Example("demo", "Demo", "Seven emotions in turn, a spoken line and blinks: twenty seconds to play", _demo),
    Example(
        "smile",
        "Smile with a painted cheek",
        "The left cheek was painted stiff and smiles only half; paint it soft in the Tissue workspace",
        smile_project,
    ),
    Example(
        "line",
        "A spoken line",
        "Sounds become shapes of the mouth that run into each other; move them, or make them stronger",
        line_project,
    ),
    Example(
        "timing",
        "Three smiles",
        "The same smile comes and goes in three ways; drag the handles of its events",
        timing_project,
    ),
)
"""In the order of the menu."""


def find_example(key: str) -> Example:
    """An example by its key.

    Raises
    ------
    UnknownNameError
        If there is none.
    """
    for example in EXAMPLES:
        if example.key == key:
            return example
    raise UnknownNameError(f"There is no example “{key}”; choose one of {', '.join(each.key for each in EXAMPLES)}.")


def examples_folder() -> Path:
    """Where files that belong to examples are kept, so that an example that is not saved finds its voice.

    Raises
    ------
    ProjectError
        If it cannot be made.
    """
    folder = cache_folder() / "examples"
    try:
        folder.mkdir(parents=True, exist_ok=True)
    except OSError as error:
        raise ProjectError(
            f"“{folder}” cannot be made: {error.strerror or error}; free some space there, or name another folder in "
            "the variable RISORIUS_CACHE."
        ) from error
    return folder

"""What an example is."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from facemodel.project import Project


@dataclass(frozen=True)
class Example:
    """A project that is made when somebody wants it.

    Attributes
    ----------
    key : unique
    title : for people
    hint : one sentence about what it shows and what to try
    made : the project; it is given a folder for the files that belong to it, a voice say
    """

    key: str
    title: str
    hint: str
    made: Callable[[Path], Project]

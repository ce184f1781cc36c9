"""Read and write a recipe of anatomy as JSON."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import asdict, fields, is_dataclass
from functools import lru_cache
from pathlib import Path
from typing import Any

from pydantic import TypeAdapter, ValidationError

from facemodel.anatomy.recipe import Anatomy
from facemodel.errors import ProjectError
from facemodel.io.disk import read_file, replacing
from facemodel.io.readable import readable
from resources import resource

LARGEST = 4 << 20
"""Bytes; a recipe is a few pages."""

FARTHEST = 1e4
"""Numbers beyond this are no millimetres, factors or stiffnesses of a face."""


@lru_cache(maxsize=1)
def shipped_anatomy() -> Anatomy:
    """The recipe that ships with Risorius."""
    return read_anatomy(resource("anatomy", "anatomy.json"))


def read_anatomy(path: Path) -> Anatomy:
    """Read a recipe.

    Raises
    ------
    ProjectError
        If the file is missing or no recipe.
    """
    try:
        anatomy = TypeAdapter(Anatomy).validate_json(read_file(path, LARGEST))
    except ValidationError as error:
        first = error.errors()[0]
        place = ".".join(str(step) for step in first["loc"])
        raise ProjectError(
            f"“{path}” is no recipe of anatomy: {place or 'the file'} {first['msg'].lower()}."
        ) from error
    for place, number in _numbers(anatomy, ""):
        if not (math.isfinite(number) and abs(number) < FARTHEST):
            raise ProjectError(f"“{path}” is no recipe of anatomy: {place} is {number:g}.")
    return anatomy


def write_anatomy(anatomy: Anatomy, path: Path) -> None:
    """Write a recipe."""
    with replacing(path) as stream:
        stream.write(readable(asdict(anatomy)))


def _numbers(value: Any, place: str) -> Iterator[tuple[str, float]]:
    if is_dataclass(value):
        for each in fields(value):
            yield from _numbers(getattr(value, each.name), f"{place}.{each.name}".strip("."))
    elif isinstance(value, dict):
        for key, item in value.items():
            yield from _numbers(item, f"{place}.{key}")
    elif isinstance(value, tuple):
        for number, item in enumerate(value):
            yield from _numbers(item, f"{place}.{number}")
    elif isinstance(value, int | float):
        yield place, float(value)

"""Loops over points as machine code, where a frame is at stake: compiled once for every version of this code."""

from __future__ import annotations

import os
import shutil
from collections.abc import Callable
from hashlib import sha256
from pathlib import Path
from typing import TypeVar, cast

import numba
from numba import njit

from facemodel.folders import cache_folder

F = TypeVar("F", bound=Callable[..., object])

KEPT = 4
"""Versions of this code whose loops stay compiled: that of today, and those of a few branches."""

PREFIX = "loops-"


def compiled(function: F) -> F:
    """A function of arrays and numbers that is compiled when it is first called, for the types that it is called with.

    It lets other threads run meanwhile, since it touches nothing of Python.  It may call others of its own file, and
    those of this package.
    """
    return cast(F, njit(cache=True, nogil=True, error_model="numpy")(function))


def _version() -> str:
    """A digest of all code that may be compiled: a loop that calls another one contains it as it was."""
    digest = sha256(numba.__version__.encode())
    for path in sorted(Path(__file__).parent.rglob("*.py")):
        digest.update(path.read_bytes())
    return digest.hexdigest()[:16]


def _folder() -> Path:
    """Where compiled loops are kept: beside what else Python compiles, or with the user's caches."""
    beside = Path(__file__).parent / "__pycache__"
    base = beside if os.access(beside if beside.exists() else beside.parent, os.W_OK) else cache_folder()
    folder = base / (PREFIX + _version())
    if not folder.exists():
        folder.mkdir(parents=True, exist_ok=True)
        known = sorted(base.glob(PREFIX + "*"), key=lambda path: path.stat().st_mtime)
        for old in known[:-KEPT]:
            shutil.rmtree(old, ignore_errors=True)
    return folder


numba.config.CACHE_DIR = str(_folder())  # type: ignore[attr-defined]

"""Solutions kept in the user's cache folder by the hash of what they were solved from."""

from __future__ import annotations

import hashlib
import os
import tempfile
import time
import zipfile
from collections.abc import Iterator, Mapping
from contextlib import suppress
from dataclasses import fields, is_dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from facemodel.actions import skin_units
from facemodel.basis import Basis
from facemodel.chart import ChartFigures
from facemodel.display import DisplaySurface
from facemodel.face import Jaw
from facemodel.folders import cache_folder
from facemodel.jaw.arc import JawArc
from facemodel.jaw.modes import JawMode
from facemodel.project import Project
from facemodel.solve import Progress, Solution, silent, solve_project

METHOD = "11"
"""Raise this when the same project would be solved to other fields, so that old entries are not found."""

KEPT = 16
"""Entries that stay in the folder; the ones used longest ago go first.  One takes some 60 MB."""


ABANDONED = 3600.0
"""Seconds after which an unfinished entry counts as left behind by a program that was ended while it wrote."""


def solution_key(project: Project) -> str:
    """Hash of all that the fields depend on: face, muscles, action units and settings, not the expression."""
    digest = hashlib.blake2b(METHOD.encode(), digest_size=16)
    units = tuple(replace(unit, eyes=None, head=None) for unit in skin_units(project.units))
    for piece in _pieces((project.face, project.muscles, units, project.settings)):
        digest.update(piece)
    return digest.hexdigest()


def _pieces(value: Any) -> Iterator[bytes]:
    """The bytes of nested values, each with its kind, so that no two different values give the same stream."""
    if isinstance(value, np.ndarray):
        yield f"{value.dtype.str}{value.shape}".encode()
        yield np.ascontiguousarray(value).tobytes()
    elif is_dataclass(value) and not isinstance(value, type):
        yield type(value).__name__.encode()
        for each in fields(value):
            yield from _pieces(getattr(value, each.name))
    elif isinstance(value, Mapping):
        yield f"mapping{len(value)}".encode()
        for key, item in sorted(value.items()):
            yield from _pieces(key)
            yield from _pieces(item)
    elif isinstance(value, tuple):
        yield f"tuple{len(value)}".encode()
        for item in value:
            yield from _pieces(item)
    elif value is None or isinstance(value, str | bool | int | float):
        yield f"{type(value).__name__}:{value!r};".encode()
    else:  # a list's text, say, leaves out the middle of long arrays
        raise TypeError(f"A project holds a {type(value).__name__}, of which the cache knows no bytes.")


def cached_solution(project: Project) -> Solution | None:
    """The kept solution of a project, or None; a damaged entry is removed and counts as none."""
    path = cache_folder() / f"{solution_key(project)}.npz"
    try:
        with path.open("rb") as stream, np.load(stream, allow_pickle=False) as arrays:
            solution = _solution_of({name: arrays[name] for name in arrays.files})
    except (FileNotFoundError, NotADirectoryError):
        return None
    except (OSError, ValueError, KeyError, EOFError, zipfile.BadZipFile):
        with suppress(OSError):  # a folder that may only be read costs time, not work
            path.unlink(missing_ok=True)
        return None
    with suppress(OSError):
        os.utime(path)
    return solution


def keep_solution(project: Project, solution: Solution) -> bool:
    """Keep a solution; returns whether it could be written (a full or read-only disk costs time, not work)."""
    folder = cache_folder()
    try:
        folder.mkdir(parents=True, exist_ok=True)
        descriptor, name = tempfile.mkstemp(suffix=".part", dir=folder)
        try:
            with os.fdopen(descriptor, "wb") as stream:
                np.savez(stream, allow_pickle=False, **_arrays_of(solution))
            os.replace(name, folder / f"{solution_key(project)}.npz")
        except BaseException:
            Path(name).unlink(missing_ok=True)
            raise
        _forget_oldest(folder)
    except OSError:
        return False
    return True


def _forget_oldest(folder: Path) -> None:
    for path in folder.glob("*.part"):
        if path.stat().st_mtime < time.time() - ABANDONED:
            path.unlink(missing_ok=True)
    entries = sorted(folder.glob("*.npz"), key=lambda path: path.stat().st_mtime, reverse=True)
    for path in entries[KEPT:]:
        path.unlink(missing_ok=True)


def solve_cached(project: Project, progress: Progress = silent) -> Solution:
    """The kept solution of a project, or a new one, which is then kept.

    Raises
    ------
    FaceError, Cancelled
        As `facemodel.solve.solve_project` does.
    """
    kept = cached_solution(project)
    if kept is not None:
        progress(f"Read {len(kept.basis.names)} fields from the cache", 1.0)
        return kept
    solution = solve_project(project, progress)
    keep_solution(project, solution)
    return solution


def _arrays_of(solution: Solution) -> dict[str, np.ndarray[Any, Any]]:
    basis, display, chart = solution.basis, solution.basis.display, solution.chart
    return {
        "names": np.array(basis.names, dtype=np.str_),
        "fields": basis.fields,
        "slopes": basis.slopes,
        "jaw": basis.jaw,
        **_arc_arrays(basis.arc),
        "points": display.points,
        "normals": display.normals,
        "rest_slopes": display.slopes,
        "triangles": display.triangles,
        "elements": display.elements,
        "barycentric": display.barycentric,
        "counts": np.array([display.moving, display.density, solution.unknowns, chart.flips]),
        "carried_names": np.array([name for name, _ in display.carried], dtype=np.str_),
        "carried_counts": np.array([count for _, count in display.carried], dtype=np.int64),
        "stretch": np.array([chart.worst, chart.p95]),
        "steps": np.array(list(solution.seconds), dtype=np.str_),
        "seconds": np.array(list(solution.seconds.values())),
    }


def _solution_of(arrays: dict[str, np.ndarray[Any, Any]]) -> Solution:
    moving, density, unknowns, flips = (int(n) for n in arrays["counts"])
    counts = (int(n) for n in arrays["carried_counts"])
    display = DisplaySurface(
        points=arrays["points"],
        normals=arrays["normals"],
        slopes=arrays["rest_slopes"],
        triangles=arrays["triangles"],
        moving=moving,
        elements=arrays["elements"],
        barycentric=arrays["barycentric"],
        density=density,
        carried=tuple(zip((str(name) for name in arrays["carried_names"]), counts, strict=True)),
    )
    names = tuple(str(name) for name in arrays["names"])
    basis = Basis(names, display, arrays["fields"], arrays["slopes"], arrays["jaw"], arc=_arc_of(arrays))
    chart = ChartFigures(flips, float(arrays["stretch"][0]), float(arrays["stretch"][1]))
    seconds = dict(zip((str(step) for step in arrays["steps"]), arrays["seconds"].tolist(), strict=True))
    return Solution(basis, chart, unknowns, seconds)


def _arc_arrays(arc: JawArc | None) -> dict[str, np.ndarray[Any, Any]]:
    if arc is None:
        return {}
    return {
        "arc_hinge": np.concatenate([arc.hinge.axis, arc.hinge.teeth[None]]),
        "arc_carried": arc.carried,
        "arc_modes": np.array([mode.number for mode in arc.modes], dtype=np.int64),
        "arc_fields": arc.fields,
        "arc_slopes": arc.slopes,
    }


def _arc_of(arrays: dict[str, np.ndarray[Any, Any]]) -> JawArc | None:
    if "arc_modes" not in arrays:
        return None
    *axis, teeth = arrays["arc_hinge"]
    modes = tuple(JawMode(int(number)) for number in arrays["arc_modes"])
    return JawArc(
        Jaw(np.array(axis), teeth),
        arrays["jaw"],
        arrays["arc_carried"],
        modes,
        arrays["arc_fields"],
        arrays["arc_slopes"],
    )

"""The programs, and what each makes of a file."""

from __future__ import annotations

import base64
import importlib.util
import json
import os
import shutil
import subprocess
import sys
from collections.abc import Mapping, Sequence
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any

import numpy as np

from tests.clients.clip import FRAMES, RATE

HERE = Path(__file__).resolve().parent
PATIENCE = 600.0
"""Seconds that a program may take."""

Places = Sequence[Mapping[str, np.ndarray]]
"""Where every mesh is in each of the compared frames, metres."""


class Absent(Exception):  # noqa: N818 - it is a finding, not an error
    """A program is not installed here; says how it is."""


def told_by(*command: object) -> Any:
    """What a program says as JSON in its last line."""
    words = [str(word) for word in command]
    done = subprocess.run(words, capture_output=True, text=True, timeout=PATIENCE, cwd=HERE)
    if done.returncode:
        raise RuntimeError(f"{' '.join(words)} ended with {done.returncode}:\n{done.stderr.strip()[-2000:]}")
    return json.loads(done.stdout.strip().splitlines()[-1])


def node() -> str:
    """Node with the packages of ``tests/clients/package.json``."""
    program = shutil.which("node")
    if program is None:
        raise Absent("Node.js is not installed (nodejs.org, or apt install nodejs npm)")
    if not (HERE / "node_modules").is_dir():
        raise Absent("its packages are not installed (npm install --prefix tests/clients)")
    return program


def khronos(paths: Sequence[Path]) -> dict[str, str]:
    """What the Khronos validator holds against some glTF files, by name; empty if nothing."""
    said = told_by(node(), "validate.mjs", *paths)
    return {
        Path(path).name: ""
        if not found["errors"] + found["warnings"]
        else f"{found['errors']} errors, {found['warnings']} warnings, first {found['first']}"
        for path, found in said.items()
    }


def pixar(paths: Sequence[Path]) -> dict[str, str]:
    """What the validators of USD hold against some files."""
    if importlib.util.find_spec("pxr") is None:
        raise Absent("usd-core is not installed (pip install usd-core)")
    from pxr import Usd, UsdValidation

    context = UsdValidation.ValidationContext(UsdValidation.ValidationRegistry().GetOrLoadAllValidators())
    found = {path.name: context.Validate(Usd.Stage.Open(str(path))) for path in paths}
    return {name: "; ".join(error.GetErrorAsString() for error in errors) for name, errors in found.items()}


def three(path: Path, pictures: Path) -> Places:
    """A file as three.js plays it in Chromium; its pictures are kept."""
    program = next(filter(None, map(shutil.which, ("chromium", "chromium-browser", "google-chrome"))), None)
    if program is None:
        raise Absent("Chromium is not installed (apt install chromium)")
    times = [f"{frame / RATE:.6f}" for frame in FRAMES]
    with TemporaryDirectory() as folder:
        about = told_by(node(), "three_play.mjs", program, path, folder, *times)
        if about["complaints"]:
            raise RuntimeError(f"three.js: {about['complaints'][0]}")
        for time in times:
            shutil.copy(Path(folder) / f"{time}.png", pictures / f"{path.name}-three-{time}.png")
        return [_unpacked(json.loads((Path(folder) / f"{time}.json").read_text())) for time in times]


def _unpacked(places: Mapping[str, str]) -> dict[str, np.ndarray]:
    return {name: np.frombuffer(base64.b64decode(each), "<f4").reshape(-1, 3) for name, each in places.items()}


def blender(path: Path) -> Places:
    """A file as Blender plays it."""
    own = HERE / ".venv" / "bin" / "python"
    named = os.environ.get("BLENDER_PYTHON") or (own if own.exists() else sys.executable)
    known = subprocess.run([named, "-c", "import importlib.util as u, sys; sys.exit(u.find_spec('bpy') is None)"])
    if known.returncode:
        raise Absent("bpy is not installed (python3.11 -m venv tests/clients/.venv, and pip install bpy in it)")
    with TemporaryDirectory() as folder:
        told_by(named, "blender_play.py", path, folder, RATE, *FRAMES)
        found = []
        for frame in FRAMES:
            with np.load(Path(folder) / f"{frame}.npz", allow_pickle=False) as arrays:
                found.append({name: arrays[name] for name in arrays.files})
        return found

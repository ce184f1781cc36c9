"""``python -m tests.clients [FOLDER]``: export a clip, have other programs play it, and compare every vertex.

Programs that are not installed are left out, with the reason.  The status is not zero if one of them finds an error or
has a vertex elsewhere.  FOLDER keeps files and pictures; without it they are thrown away.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Callable
from pathlib import Path
from tempfile import TemporaryDirectory

# As the program runs, see `ui`; it must be set before NumPy is loaded.
os.environ.setdefault("OPENBLAS_NUM_THREADS", "1")

import numpy as np

from facemodel.io.export.performance import WITHIN
from tests.clients.clip import FRAMES, shown, written
from tests.clients.programs import Absent, Places, blender, khronos, pixar, three

LIMIT = WITHIN + 0.01
"""Millimetres: what the corrections of an export leave, and what float32 metres and sparse shapes cost."""


def main(folder: Path) -> int:
    """Try everything and say what came of it."""
    project, solution = written(folder)
    wanted = list(shown(project, solution))
    models, stages = sorted(folder.glob("*.glb")), sorted(folder.glob("*.usdc"))
    moving = [path for path in models if path.name != "still.glb"]
    good = [
        *_validated("Khronos validator", khronos, models),
        *_validated("USD validators", pixar, stages),
        *(_played("three.js", lambda path: three(path, folder), path, wanted) for path in moving),
        *(_played("Blender", blender, path, wanted) for path in (*moving, *stages)),
    ]
    return 0 if all(good) else 1


def _validated(who: str, ask: Callable[[list[Path]], dict[str, str]], paths: list[Path]) -> list[bool]:
    try:
        found = ask(paths)
    except Absent as reason:
        print(f"skipped  {who}: {reason}")
        return []
    for name, complaint in found.items():
        print(f"{'WRONG' if complaint else 'good':<8} {who}, {name}: {complaint or 'no error and no warning'}")
    return [not complaint for complaint in found.values()]


def _played(who: str, play: Callable[[Path], Places], path: Path, wanted: Places) -> bool:
    try:
        seen = play(path)
    except Absent as reason:
        print(f"skipped  {who}, {path.name}: {reason}")
        return True
    apart = max(_apart(places, found) for places, found in zip(wanted, seen, strict=True))
    good = apart < LIMIT
    print(
        f"{'good' if good else 'WRONG':<8} {who}, {path.name}: every vertex of {len(FRAMES)} frames within "
        f"{apart:.4f} mm of the editor"
    )
    return good


def _apart(wanted: dict[str, np.ndarray], seen: dict[str, np.ndarray]) -> float:
    """The largest distance of a vertex, millimetres; a mesh that is missing is infinitely far."""
    named = {name.replace("_", "-"): places for name, places in seen.items()}
    return max(
        float(np.linalg.norm(1000 * named[name] - places, axis=1).max()) if name in named else np.inf
        for name, places in wanted.items()
    )


if __name__ == "__main__":
    if len(sys.argv) > 1:
        kept = Path(sys.argv[1]).resolve()
        kept.mkdir(parents=True, exist_ok=True)
        sys.exit(main(kept))
    with TemporaryDirectory() as scratch:
        sys.exit(main(Path(scratch)))

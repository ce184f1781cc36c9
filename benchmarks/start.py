"""From the command to the first frame on which a slider can be moved, with the face in the cache.

    python -m benchmarks.start

opens the editor, says when that frame is drawn, and closes it.
"""

from __future__ import annotations

import os
import subprocess
import sys
import tempfile
import time
from collections.abc import Iterator
from pathlib import Path

import numpy as np

from benchmarks.figure import Figure, Unmeasured, alone

REPEATS = 5
PATIENCE = 120
"""Seconds after which a window that does not come is given up."""


def figures() -> Iterator[Figure]:
    """Start the editor several times with a cache and settings of its own."""
    if sys.platform == "linux" and not (os.environ.get("DISPLAY") or os.environ.get("WAYLAND_DISPLAY")):
        raise Unmeasured("there is no display; run it by .ci/with-display.")
    with tempfile.TemporaryDirectory() as folder:
        cold = _seconds_to_first_frame(Path(folder))
        warm = np.array([_seconds_to_first_frame(Path(folder)) for _ in range(REPEATS)])
    yield alone("start of the editor to the first interactive frame, warm cache", warm)
    yield alone("the very first start, which solves the face", np.array([cold]))


def _seconds_to_first_frame(folder: Path) -> float:
    homes = {name: str(folder / name.lower()) for name in ("XDG_CONFIG_HOME", "XDG_DATA_HOME", "XDG_STATE_HOME")}
    environment = os.environ | homes | {"RISORIUS_CACHE": str(folder / "cache")}
    environment.pop("PYTHONDONTWRITEBYTECODE", None)  # whoever starts a program twice has its bytecode
    start = time.time()
    command = [sys.executable, "-m", "benchmarks.start"]
    done = subprocess.run(command, env=environment, capture_output=True, text=True, timeout=PATIENCE, check=True)
    return float(done.stdout.split()[-1]) - start


def tell_first_frame() -> None:
    """Open the editor and print the time at which the solved face has been drawn."""
    # The imports are part of the start, and the measuring process needs none of them.
    from PySide6.QtCore import QTimer

    from app.settings import UserSettings
    from ui.window.main import first_document, follow_theme, make_application, make_window

    app = make_application()
    settings = UserSettings()
    follow_theme(app, settings)
    document, _ = first_document(None)
    window = make_window(document, settings)
    viewport = window.viewport

    def look(_milliseconds: float) -> None:
        figure = viewport.scene.figure
        if document.solution is not None and figure is not None and figure.posed.basis is document.solution.basis:
            print(time.time(), flush=True)
            viewport.canvas.drawn.disconnect(look)
            QTimer.singleShot(0, window.close)

    viewport.canvas.drawn.connect(look)
    window.show()
    app.exec()


if __name__ == "__main__":
    tell_first_frame()

"""From the command to the first frame on which a slider can be moved, with the face in the cache.

    python -m benchmarks.start

opens the editor, says when that frame is drawn, and closes it.
"""

from __future__ import annotations

import os
import sys
import tempfile
import time
from collections.abc import Iterator
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np

from benchmarks.figure import Figure, Unmeasured, alone, told_by

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
    return float(told_by(command, environment, PATIENCE).split()[0]) - start


def tell_first_frame() -> None:
    """Open the editor and print the time at which the solved face has been drawn."""
    # The imports are part of the start, and the measuring process needs none of them.
    from PySide6.QtCore import QTimer
    from PySide6.QtWidgets import QApplication

    from ui.window.main import make_application, run

    make_application()
    waiting = QTimer(interval=5)

    def watch() -> None:
        for window in QApplication.topLevelWidgets():
            if hasattr(window, "viewport") and hasattr(window, "context"):
                waiting.stop()
                window.viewport.canvas.drawn.connect(partial(look, window))

    def look(window: Any, _milliseconds: float) -> None:
        solution, figure = window.context.document.solution, window.viewport.scene.figure
        if solution is not None and figure is not None and figure.posed.basis is solution.basis:
            print(time.time(), flush=True)
            QTimer.singleShot(0, window.close)

    waiting.timeout.connect(watch)
    waiting.start()
    run()


if __name__ == "__main__":
    tell_first_frame()

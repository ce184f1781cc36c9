"""Make the pictures of README and docs: ``make pictures``.

They are photographs of the real editor and renderings by the real command line, never touched by hand.
"""

from __future__ import annotations

import sys
import tempfile
import time
from collections.abc import Callable
from pathlib import Path

from PIL import Image, ImageGrab
from PySide6.QtWidgets import QApplication

from app.document import Document
from app.settings import UserSettings
from docs.first_face import Hand, walk
from facemodel.cache import solve_cached
from facemodel.io.project_file import save_project
from facemodel.projects import new_project
from ui.launch import main as risorius
from ui.window.editor import make_window
from ui.window.main import follow_theme, make_application
from ui.window.main_window import MainWindow
from ui.window.preparation import Preparation

IMAGES = Path(__file__).parent / "images"
SIZE = (1440, 900)
STILL = 3.0
"""Seconds after which a face that does not move has been drawn with smooth edges."""

MUSCLE = "zygomaticus_major_L"
"""The muscle that is selected in the picture of the Muscles workspace."""

PLATES = {
    "smile": ["--au", "12=1", "--au", "6=0.7"],
    "brow-raise": ["--au", "1=1", "--au", "2=1"],
    "open-jaw": ["--au", "27=1"],
    "layers": ["--au", "12=0.6", "--show", "skull,muscles"],
}
"""Pictures drawn by ``risorius render``."""


def wait(app: QApplication, ready: Callable[[], bool], limit: float = 300.0) -> None:
    """Let the editor work until something is the case."""
    end = time.monotonic() + limit
    while not ready():
        if time.monotonic() > end:
            sys.exit("The editor did not come to rest; run this on a machine with less to do.")
        app.processEvents()
        time.sleep(0.01)


def rest(app: QApplication) -> None:
    """Let the picture come to rest."""
    end = time.monotonic() + STILL
    wait(app, lambda: time.monotonic() > end)


def photograph(window: MainWindow, name: str) -> None:
    """Keep what the screen shows of a window."""
    corner = window.mapToGlobal(window.rect().topLeft())
    box = (corner.x(), corner.y(), corner.x() + window.width(), corner.y() + window.height())
    ImageGrab.grab(box).convert("RGB").save(IMAGES / f"{name}.png", optimize=True)
    print(f"docs/images/{name}.png")


def editor(theme: str, emotion: str, name: str, workspaces: tuple[str, ...] = ()) -> None:
    """Photograph the editor on the default face with an emotion, then other workspaces."""
    app = make_application()
    with tempfile.TemporaryDirectory() as folder:
        settings = UserSettings(Path(folder) / "preferences.json")
        settings.change(theme=theme, hint_done=True)
        follow_theme(app, settings)
        document = Document(new_project())
        window = make_window(document, settings, Preparation(), solve_cached)
        window.resize(*SIZE)
        window.move(0, 0)
        window.show()
        wait(app, lambda: document.solution is not None and window.viewport.shows_face)
        document.apply_emotion(emotion)
        rest(app)
        photograph(window, name)
        for workspace in workspaces:
            window.context.view.change(workspace=workspace, muscle=MUSCLE if workspace == "muscles" else "")
            rest(app)
            photograph(window, workspace)
        document.undo()
        window.close()


def first_face() -> None:
    """Photograph the way from a bare head to a face that smiles, raises its brows and opens its jaw."""
    app = make_application()
    with tempfile.TemporaryDirectory() as folder:
        settings = UserSettings(Path(folder) / "preferences.json")
        settings.change(hint_done=True)
        follow_theme(app, settings)
        document = Document(new_project())
        window = make_window(document, settings, Preparation(), solve_cached)
        window.resize(*SIZE)
        window.move(0, 0)
        window.show()
        wait(app, lambda: document.solution is not None and window.viewport.shows_face)

        def keep(name: str) -> None:
            rest(app)
            photograph(window, name)

        walk(Hand(window, keep))
        document.reset_expression()
        document.save(Path(folder) / "first.risorius")
        window.close()


def plates() -> None:
    """Draw the plates and the sheet with the command line."""
    with tempfile.TemporaryDirectory() as folder:
        project = Path(folder) / "ada.risorius"
        save_project(new_project(), project)
        for name, options in PLATES.items():
            out = str(IMAGES / f"{name}.png")
            words = ["render", str(project), out, "--view", "three-quarter", "--size", "960x720", *options]
            if risorius(words):
                sys.exit(f"{name} could not be drawn.")
        if risorius(["gallery", str(project), str(IMAGES / "gallery.png")]):
            sys.exit("The sheet could not be drawn.")
    with Image.open(IMAGES / "gallery.png") as sheet:
        sheet.resize((sheet.width // 2, sheet.height // 2), Image.Resampling.LANCZOS).save(
            IMAGES / "gallery.png", optimize=True
        )


if __name__ == "__main__":
    IMAGES.mkdir(exist_ok=True)
    plates()
    editor("dark", "happiness", "editor", ("actions", "muscles", "skull", "tissue"))
    editor("light", "surprise", "editor-light")
    first_face()

"""Make the pictures of README and docs: ``make pictures``.

They are photographs of the real editor and renderings by the real command line, never touched by hand.
"""

from __future__ import annotations

import sys
import tempfile
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import numpy as np
from PIL import Image, ImageGrab
from PySide6.QtCore import QPoint
from PySide6.QtWidgets import QApplication, QFileDialog, QWidget

from app.document import Document
from app.settings import UserSettings
from app.speech.espeak import spoken_sound
from app.timeline.chosen import Chosen
from docs import three_keys
from docs.first_face import Hand, walk, workspace
from facemodel.cache import solve_cached
from facemodel.io.audio import write_sound
from facemodel.io.project_file import save_project
from facemodel.projects import new_project
from ui.launch import main as risorius
from ui.panels.actions.panel import EXPRESSIONS, ActionsPanel
from ui.panels.muscles.comparison.window import ComparisonWindow
from ui.panels.muscles.deeds import compare
from ui.window.editor import make_window
from ui.window.main import follow_theme, make_application
from ui.window.preparation import Preparation

IMAGES = Path(__file__).parent / "images"
SIZE = (1440, 900)
STILL = 3.0
"""Seconds after which a face that does not move has been drawn with smooth edges."""

PORTRAITS = 8.0
"""Seconds after which all portraits have been taken in idle moments."""

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


def photograph(window: QWidget, name: str) -> None:
    """Keep what the screen shows of a window."""
    corner = window.mapToGlobal(window.rect().topLeft())
    box = (corner.x(), corner.y(), corner.x() + window.width(), corner.y() + window.height())
    ImageGrab.grab(box).convert("RGB").save(IMAGES / f"{name}.png", optimize=True)
    print(f"docs/images/{name}.png")


@contextmanager
def opened(theme: str = "dark") -> Iterator[Hand]:
    """A hand on the editor, as it opens for the first time; it is closed without a question."""
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
        window.activateWindow()
        wait(app, lambda: document.solution is not None and window.viewport.shows_face)

        def keep(name: str) -> None:
            rest(app)
            photograph(window, name)

        yield Hand(window, keep)
        document.reset_expression()
        document.save(Path(folder) / "seen.risorius")
        window.close()


def editor(theme: str, emotion: str, name: str, workspaces: tuple[str, ...] = ()) -> None:
    """Photograph the editor on the default face with an emotion, then other workspaces."""
    with opened(theme) as hand:
        hand.window.context.document.apply_emotion(emotion)
        hand.photograph(name)
        for title in workspaces:
            view = hand.window.context.view
            view.change(workspace=title, muscle=MUSCLE if title == "muscles" else "")
            hand.photograph(title)


def first_face() -> None:
    """Photograph the way from a bare head to a face that smiles, raises its brows and opens its jaw."""
    with opened() as hand:
        walk(hand)


def models() -> None:
    """Photograph the models of a muscle side by side."""
    with opened() as hand:
        workspace(hand, "Muscles")
        hand.window.context.view.change(muscle=MUSCLE)
        compare(hand.window.context)
        shown = next(each for each in QApplication.topLevelWidgets() if isinstance(each, ComparisonWindow))
        hand.wait(lambda: all(card.has_picture for card in shown.cards.values()))
        shown.move(0, 0)
        hand.rest(STILL)
        photograph(shown, "models")
        shown.close()


def sculpting() -> None:
    """Photograph a stroke that pulls the corner of a smiling mouth, and the pad that blends emotions."""
    with opened() as hand:
        document, view = hand.window.context.document, hand.window.context.view
        document.set_weights({"12": 0.8})
        workspace(hand, "Actions")
        view.change(unit=12)
        hand.take("sculpt")
        face, posed = document.project.face, hand.window.viewport.scene.figure.posed
        at_rest = face.skin.positions[face.landmarks["mouth_corner_L"]]
        nearest = np.linalg.norm(posed.basis.display.points - at_rest, axis=1).argmin()
        corner = hand.pixel(posed.points[nearest])
        hand.drag(hand.window.viewport.canvas, corner, corner + QPoint(12, -10))
        hand.photograph("sculpting")


def pad() -> None:
    """Photograph the pad, with the seven emotions on a circle and a face between them."""
    with opened() as hand:
        workspace(hand, "Actions")
        actions = hand.window.findChild(ActionsPanel)
        hand.click(actions.tabs.tabBar(), actions.tabs.tabBar().tabRect(EXPRESSIONS).center())
        hand.click(actions.blend.arrange)
        hand.rest(PORTRAITS)
        area = actions.blend.pad
        hand.drag(area, area.spot((0.5, 0.5)).toPoint(), area.spot((0.58, 0.86)).toPoint())
        hand.photograph("pad")


def animation() -> None:
    """Photograph the way to three keys with a voice, which eSpeak NG lends, and the curves that come of it."""
    with tempfile.TemporaryDirectory() as folder, opened() as hand:
        voice = Path(folder) / "hello.wav"
        write_sound(spoken_sound("Hello, my name is Ada."), voice)
        QFileDialog.getOpenFileName = staticmethod(lambda *_asked: (str(voice), ""))
        three_keys.walk(hand)
        window = hand.window
        timeline = window.timeline.timeline
        timeline.change(mode="curves", lines=frozenset(f"track {name}" for name in ("1L", "12L", "17", "4L")))
        timeline.choose(Chosen({("12L", 0): (1,)}))
        window.binding.perform("timeline.shape.bezier")
        hand.rest(0.5)
        window.timeline.panel.graph.frame_values()
        hand.photograph("curves")


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
    for taken in (first_face, models, sculpting, pad, animation):
        taken()

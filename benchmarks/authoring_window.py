"""The editor's window for measuring: real mouse events, and frames that are drawn when they are asked for."""

from __future__ import annotations

import tempfile
import time
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path

import numpy as np
from PySide6.QtCore import QEvent, QPointF, Qt
from PySide6.QtGui import QMouseEvent
from PySide6.QtWidgets import QApplication

from app.document import Document
from app.settings import UserSettings
from app.solving import EditingSolve
from facemodel.laying.collection import muscle_of
from facemodel.project import Project
from facemodel.solver import Work
from ui.theme.apply import apply_theme
from ui.theme.roles import DARK
from ui.window.editor import make_window
from ui.window.preparation import Preparation

PATIENCE = 300.0
"""Seconds after which a face that is not solved is given up."""

SIZE = (1280, 800)

Left, None_ = Qt.MouseButton.LeftButton, Qt.MouseButton.NoButton


class AuthoringWindow:
    """A window on a project, solved as for editing.

    Attributes
    ----------
    main : the window
    """

    def __init__(self, project: Project, folder: Path) -> None:
        self._app = QApplication.instance() or QApplication([])
        apply_theme(self._app, DARK)
        self._solve = EditingSolve()
        self._document = Document(project)
        settings = UserSettings(folder / "preferences.json")
        self.main = make_window(self._document, settings, Preparation(), self._solve)
        self.main.resize(*SIZE)
        self.main.show()
        self._wait(lambda: self._document.solution is not None and self.main.viewport.shows_face)
        self.main.context.view.look_from("front")

    @property
    def work(self) -> Work:
        """What the last solve had to do."""
        return self._solve.work

    @property
    def seconds_of_solver(self) -> float:
        """What the last solve took in its own thread."""
        solution = self._document.solved
        return sum(solution.seconds.values()) if solution is not None else 0.0

    def begin_painting(self) -> None:
        """Take the brush in hand, its tables ready."""
        self.main.context.view.change(workspace="tissue")
        bench = self.main.toolbox.bench
        bench.brush.change(radius=12.0, strength=0.6, mirror=False)
        _ = bench.ground.surface(self._document.project.face).geodesics
        self._settle()

    def begin_laying(self, muscle: str) -> None:
        """Take the fibre tool in hand, one muscle selected."""
        self.main.context.view.change(workspace="muscles")
        self.main.context.view.change(muscle=muscle)
        self.main.toolbox.take("fibre")
        self._muscle = muscle
        self._settle()

    def attachment(self) -> tuple[float, float]:
        """Where the first attachment of the selected muscle is seen."""
        place = muscle_of(self._document.project, self._muscle).fibres[0].attachment
        renderer, canvas = self.main.viewport.scene.renderer, self.main.viewport.canvas
        renderer.SetWorldPoint(*place, 1.0)
        renderer.WorldToDisplay()
        x, y, _ = renderer.GetDisplayPoint()
        scale = canvas.devicePixelRatioF()
        return x / scale, canvas.height() - 1 - y / scale

    def path(self, step: int) -> tuple[float, float]:
        """A place on a way over the cheek that never stands still."""
        canvas = self.main.viewport.canvas
        turn = 0.11 * step
        return canvas.width() * (0.56 + 0.03 * np.cos(turn)), canvas.height() * (0.60 + 0.05 * np.sin(1.7 * turn))

    def press(self, x: float, y: float) -> None:
        """The left button goes down."""
        self._send(QEvent.Type.MouseButtonPress, x, y, Left, Left)
        self.draw()

    def move(self, x: float, y: float) -> None:
        """The pointer moves with the button down, and the frame is drawn."""
        self._send(QEvent.Type.MouseMove, x, y, None_, Left)
        self.main.hands.flush()
        self.draw()

    def release(self, x: float, y: float) -> None:
        """The button goes up."""
        self._send(QEvent.Type.MouseButtonRelease, x, y, Left, None_)

    def release_and_wait(self, x: float, y: float) -> None:
        """The button goes up, and the fields are solved."""
        self.release(x, y)
        self.wait_for_fields()

    def undo(self) -> None:
        """Take the last step back, and draw the frame."""
        self._document.undo()
        self.draw()

    def draw(self) -> None:
        """Draw the frame now."""
        canvas = self.main.viewport.canvas
        drawn = canvas.frames
        canvas.repaint()
        if canvas.frames == drawn:
            canvas.update()
            self._wait(lambda: canvas.frames > drawn)

    def wait_for_fields(self) -> None:
        """Until all fields hold again and are drawn."""
        self._wait(lambda: not self._document.stale)
        self.draw()

    def close(self) -> None:
        """Leave without a question."""
        self._document.restore(self._document.project, None)
        self._document._saved = self._document.project
        self.main.close()
        self._app.processEvents()

    def _send(self, kind: QEvent.Type, x: float, y: float, button: Qt.MouseButton, held: Qt.MouseButton) -> None:
        canvas, place = self.main.viewport.canvas, QPointF(x, y)
        over = QPointF(canvas.mapToGlobal(place))
        QApplication.sendEvent(canvas, QMouseEvent(kind, place, over, button, held, Qt.KeyboardModifier.NoModifier))

    def _settle(self) -> None:
        """Until nothing is under way that has been begun beside."""
        self._wait(lambda: not self.main.context.solving.job.running and not self._document.stale)
        for _ in range(3):
            self.draw()
            self._app.processEvents()

    def _wait(self, ready: Callable[[], bool]) -> None:
        end = time.perf_counter() + PATIENCE
        while not ready():
            if time.perf_counter() > end:
                raise TimeoutError("The window did not come to rest.")
            self._app.processEvents()
            time.sleep(0.0005)


@contextmanager
def authoring_window(project: Project) -> Iterator[AuthoringWindow]:
    """A window that is closed when it is no longer needed."""
    with tempfile.TemporaryDirectory() as folder:
        window = AuthoringWindow(project, Path(folder))
        try:
            yield window
        finally:
            window.close()

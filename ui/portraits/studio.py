"""A studio that is built when the first portrait is wanted, and photographs the face from one fixed place."""

from __future__ import annotations

import numpy as np
from PySide6.QtGui import QImage

from facemodel.actions import Expression
from facemodel.project import Project
from facemodel.solution import Solution
from ui.headless.stage import Stage
from ui.theme.apply import current_theme
from ui.viewport.camera import face_frame, look_along, zoom

SIZE = (120, 132)
"""Pixels of a portrait: enough for twice the size it is shown at."""

AZIMUTH, ELEVATION = 0.0, 0.0
"""Degrees that the camera stands to the face's left and above: from the front both sides tell the same."""

NEARER = 1.22
"""The camera comes nearer than the whole face allows: ears and crown say nothing."""


class Studio:
    """One stage, one sitter at a time."""

    def __init__(self) -> None:
        self._stage: Stage | None = None
        self._theme = ""
        self._sitter: Solution | None = None

    @property
    def built(self) -> bool:
        """Whether there is a stage; to build it takes longer than a picture."""
        return self._stage is not None

    def build(self) -> None:
        """Set the stage up; nothing if there is one."""
        if self._stage is None:
            self._stage, self._theme = Stage(SIZE, current_theme().name, samples=0), current_theme().name

    def seats(self, solution: Solution) -> bool:
        """Whether the face with these fields sits there already."""
        return self._sitter is solution

    def seat(self, project: Project, solution: Solution) -> None:
        """Let a face sit down before the camera."""
        self.build()
        assert self._stage is not None
        self._stage.scene.show(project, solution)
        camera = self._stage.scene.renderer.GetActiveCamera()
        look_along(camera, face_frame(project.face), AZIMUTH, ELEVATION, SIZE[0] / SIZE[1])
        zoom(camera, NEARER)
        self._sitter = solution

    def portrait(self, expression: Expression) -> QImage:
        """The face that sits there, in an expression."""
        assert self._stage is not None
        if self._theme != current_theme().name:
            self._theme = current_theme().name
            self._stage.scene.dress(self._theme)
        self._stage.scene.pose(expression)
        pixels = np.ascontiguousarray(self._stage.picture())
        height, width, _ = pixels.shape
        # Qt only borrows the pixels, so they are copied before they go.
        return QImage(pixels.data, width, height, 3 * width, QImage.Format.Format_RGB888).copy()

    def close(self) -> None:
        """Give the graphics memory back."""
        stage, self._stage, self._sitter = self._stage, None, None
        if stage is not None:
            stage.close()

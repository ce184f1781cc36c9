"""Skin under a hand that sculpts: it goes along before the document hears of it."""

from __future__ import annotations

from facemodel.sculpting.correction import Corrections
from facemodel.sculpting.sampler import DrawnChange
from ui.workspaces.workspace import Parts


class SculptInSight:
    """Moves the drawn skin as the tool asks for, until the document has it so or the stroke is taken back.

    If the face is posed anew in the meantime, as when a solve ends, the stroke is laid on it again.
    """

    def __init__(self, parts: Parts) -> None:
        self._document = parts.context.document
        self._scene, self._canvas = parts.viewport.scene, parts.viewport.canvas
        self._changes: list[DrawnChange] = []
        self._corrections: Corrections = {}
        parts.bench.sight.shifted.connect(self._take)
        self._canvas.before_frame.append(self._follow)

    def switch(self, on: bool) -> None:
        """Begin to draw, or put all skin back."""
        if not on and self._changes:
            self._take(None)

    def _take(self, change: DrawnChange | None) -> None:
        figure = self._scene.figure
        if figure is None:
            return
        if change is None:
            self._changes.clear()
            figure.posed.settle()
        else:
            if not self._changes:
                self._corrections = self._document.project.corrections
            if figure.posed.shifts == len(self._changes):
                figure.posed.shift(change)
            self._changes.append(change)
        figure.follow()
        self._canvas.ask_frame()

    def _follow(self) -> None:
        """Before a frame: what is posed may have lost the stroke, or have it in its fields by now."""
        figure = self._scene.figure
        if figure is None or figure.posed.shifts == len(self._changes):
            return
        if self._document.project.corrections is not self._corrections:
            self._changes.clear()
            return
        for change in self._changes[figure.posed.shifts :]:
            figure.posed.shift(change)
        figure.follow()

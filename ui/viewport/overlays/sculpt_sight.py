"""Skin under a hand that sculpts: it goes along before the document hears of it."""

from __future__ import annotations

from facemodel.basis import Basis
from facemodel.sculpting.correction import Corrections
from facemodel.sculpting.sampler import DrawnChange
from ui.viewport.figure import Figure
from ui.workspaces.workspace import Parts


class SculptInSight:
    """Moves the drawn skin as the tool asks for, until the document has it so or the stroke is taken back.

    Another basis that comes in the meantime, as when a solve ends, is drawn with the stroke on it.
    """

    def __init__(self, parts: Parts) -> None:
        self._document = parts.context.document
        self._scene, self._canvas = parts.viewport.scene, parts.viewport.canvas
        self._changes: list[DrawnChange] = []
        self._corrections: Corrections = {}
        self._basis: Basis | None = None
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
                self._corrections, self._basis = self._document.project.corrections, figure.posed.basis
            self._changes.append(change)
            if figure.posed.basis is self._basis:
                figure.posed.shift(change)
        figure.follow()
        self._canvas.ask_frame()

    def _follow(self) -> None:
        """Before a frame: what is drawn now may be another basis."""
        figure = self._scene.figure
        if not self._changes or figure is None or figure.posed.basis is self._basis:
            return
        if self._document.project.corrections is not self._corrections:
            self._changes.clear()
            return
        self._again(figure)

    def _again(self, figure: Figure) -> None:
        self._basis = figure.posed.basis
        for change in self._changes:
            figure.posed.shift(change)
        figure.follow()

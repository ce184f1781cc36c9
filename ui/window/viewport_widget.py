"""The viewport: the scene on its canvas, following document and view, with what lies over the picture."""

from __future__ import annotations

import time
from collections.abc import Mapping
from pathlib import Path

from PIL import Image
from PySide6.QtCore import QEvent, QPoint, QTimer, Signal
from PySide6.QtGui import QCloseEvent, QCursor, QResizeEvent
from PySide6.QtWidgets import QVBoxLayout, QWidget

from app.differences import same_head
from app.document import Document
from app.solo import seen
from app.view import View
from app.view_state import ViewName, ViewState
from facemodel.actions import Expression
from facemodel.contact.contact import contact_of
from facemodel.face import Face
from facemodel.io.disk import replacing
from facemodel.muscles import Muscle
from facemodel.neutral import neutral_basis
from facemodel.project import Project
from facemodel.solve import Solution
from fem.types import FloatArray
from ui.panels.muscle_text import muscle_label
from ui.theme.apply import current_theme
from ui.theme.metrics import GRID
from ui.viewport.interaction import CameraHands
from ui.viewport.look import look_of
from ui.viewport.rigid import turn_head
from ui.viewport.scene import Scene
from ui.widgets.pointer_label import PointerLabel
from ui.window.canvas import FRAME, Canvas
from ui.window.face_pointer import FacePointer
from ui.window.preparation import Preparation

TURNTABLE = 24.0
"""Degrees per second: once round in a quarter of a minute."""

REPORT = 0.25
"""Seconds between two reports of the time per frame; a number that changes faster cannot be read."""


class Viewport(QWidget):
    """Draws what the document shows, once per frame.

    Signals
    -------
    muscle_hovered(object) : the Muscle under the pointer, or None
    timed() : `frame_time` is fresh

    Attributes
    ----------
    frame_time : milliseconds that posing and drawing the last expression took
    """

    muscle_hovered = Signal(object)
    timed = Signal()

    def __init__(self, document: Document, view: View, preparation: Preparation, parent: QWidget) -> None:
        super().__init__(parent)
        self._document = document
        self._view = view
        self._shown: tuple[Face, Solution | None] | None = None
        self._coming: tuple[Face, Solution | None] | None = None
        self._pose_due = self._turn_due = False
        self._rigid: Mapping[str, float] = {}
        self._posed: float | None = None
        self._fresh = False
        self._reported_at = 0.0
        self._over: list[QWidget] = []
        self.frame_time = 0.0
        self._preparation = preparation
        self.canvas = Canvas(self)
        self.scene = Scene(self.canvas, current_theme().name)
        self.scene.apply(view.state)
        self.pointer = PointerLabel(self)
        self.face_pointer = FacePointer(self.canvas, self.scene)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.addWidget(self.canvas)
        self._turntable = QTimer(self, interval=round(1000 * FRAME))
        self._turned_at = 0.0
        self._connect()

    @property
    def shows_face(self) -> bool:
        """Whether the document's own face is drawn, solved or at rest."""
        return self._shown is not None and same_head(self._shown[0], self._document.project.face)

    def show_document(self) -> None:
        """Draw the document's face, with its solution if there is one; until it is prepared the last one stays."""
        project, solution = self._document.project, self._solution
        if self.shows_face and self._shown == (self._shown[0], solution):
            self._shown = (project.face, solution)
            self.scene.update_project(project)
            self._pose(self._document.shown)
        elif self.shows_face and solution is not None:
            self._show_prepared()
        elif self._coming != (project.face, solution):
            self._coming = (project.face, solution)
            self._preparation.prepare(lambda: _ready(project, solution), self._show_prepared)

    def _show_prepared(self) -> None:
        project, solution = self._document.project, self._solution
        self._shown, self._coming = (project.face, solution), None
        self.scene.show(project, solution)
        self._fresh = self._turn_due = True
        self._pose(self._document.shown)

    def turn_head(self, rigid: Mapping[str, float]) -> None:
        """Turn head and eyes, by degrees and millimetres of channels; see `facemodel.animation.channels`."""
        self._rigid, self._turn_due = rigid, True
        self.canvas.ask_frame()

    def glow(self, muscles: frozenset[str]) -> None:
        """Let the skin glow where some muscles, by key, pull."""
        self.scene.glow(muscles)
        self.canvas.ask_frame()

    def save_picture(self, path: Path) -> None:
        """Write what is seen as a PNG, in the pixels of the screen.

        Raises
        ------
        ProjectError
            If it cannot be written; what was there before stays.
        """
        picture = Image.fromarray(self.canvas.picture())
        with replacing(path) as stream:
            picture.save(stream, "PNG")

    def frame_head(self) -> None:
        """Show the whole head from where one looks."""
        state = self._view.state
        self._view.look_from("three-quarter" if state.view == "free" else state.view)

    def frame_selection(self) -> None:
        """Bring the selected muscle, or else the face, near."""
        if self._view.state.muscle:
            self.scene.frame_muscle(self._view.state.muscle)
            self._moved_by_hand()
        else:
            self.frame_head()

    def show_places(self, places: FloatArray) -> None:
        """Bring places (k, 3) of the skin near, as they are seen from outside."""
        self.scene.frame_places(places)
        self._moved_by_hand()

    def lay_over(self, card: QWidget) -> None:
        """Put a card over the lower left corner of the picture."""
        self._over.append(card)
        card.setParent(self)
        card.show()
        card.raise_()
        self.place_cards()

    def take_off(self, card: QWidget) -> None:
        """Remove a card for good."""
        self._over.remove(card)
        card.hide()
        card.deleteLater()
        self.place_cards()

    def closeEvent(self, event: QCloseEvent) -> None:
        """Wait for nobody any more, and let VTK free what it has on the graphics card."""
        self._turntable.stop()
        self._preparation.close()
        self.canvas.close()
        super().closeEvent(event)

    def resizeEvent(self, event: QResizeEvent) -> None:
        """Keep the cards in their corner."""
        super().resizeEvent(event)
        self.place_cards()

    def changeEvent(self, event: QEvent) -> None:
        """Hang the backdrop of another theme."""
        super().changeEvent(event)
        if event.type() == QEvent.Type.PaletteChange and hasattr(self, "scene"):
            self.scene.dress(current_theme().name)
            self.canvas.ask_frame()

    def _connect(self) -> None:
        self.canvas.before_frame.append(self._before_frame)
        self.canvas.drawn.connect(self._note_time)
        self._document.project_changed.connect(self._show_anew)
        self._document.solution_changed.connect(self._show_anew)
        self._document.layers_changed.connect(self._edited)
        self._document.muscles_changed.connect(self._edited)
        self._document.skull_changed.connect(self._edited)
        self._document.units_changed.connect(self._edited)
        self._document.expression_changed.connect(self._pose)
        self._view.changed.connect(self._apply)
        self._view.camera_asked.connect(self._look_from)
        self._turntable.timeout.connect(self._turn)
        self.face_pointer.pointed.connect(self._name)
        self.face_pointer.clicked.connect(lambda muscle: self._view.change(muscle=muscle.key))
        self._hands = CameraHands(
            self.canvas.iren.interactor, self.canvas.renderer, lambda: self.scene.pivot, self._moved_by_hand
        )

    @property
    def _solution(self) -> Solution | None:
        """What the face is drawn with: the last solution, or the one before it where that is asked for."""
        before = self._document.previous_solution if self._view.state.before else None
        return before or self._document.solution

    def _edited(self, *_what: object) -> None:
        self._show_anew(None)

    def _show_anew(self, _now: Project | Solution | None) -> None:
        """A face without a solution is shown once it is known that solving takes a while."""
        if self.shows_face or self._document.solution is not None:
            self.show_document()

    def _pose(self, _expression: Expression) -> None:
        self._pose_due = True
        self.canvas.ask_frame()

    def _before_frame(self) -> None:
        """Pose once per frame, however often expression, head and eyes changed since the last one."""
        if self._turn_due:
            turn_head(self.scene, self._rigid)
        if self._pose_due or self._turn_due:
            self._pose_due = self._turn_due = False
            start = time.perf_counter()
            self.scene.pose(seen(self._document, self._view.state))
            self._posed = 1000 * (time.perf_counter() - start)
        self.scene.before_frame()

    def _note_time(self, drawing: float) -> None:
        posing, self._posed = self._posed, None
        first, self._fresh = self._fresh, False
        if posing is None or first:
            return
        self.frame_time = posing + drawing
        now = time.perf_counter()
        if now - self._reported_at > REPORT:
            self._reported_at = now
            self.timed.emit()

    def _apply(self, now: ViewState, before: ViewState) -> None:
        self.scene.apply(now)
        self.canvas.thin_lines = now.wireframe or (bool(now.layer) and (now.contours or now.glyphs))
        if seen(self._document, now) != seen(self._document, before):
            self._pose(self._document.shown)
        if now.before != before.before:
            self._show_anew(None)
        if now.turntable and not before.turntable:
            self._turned_at = time.perf_counter()
            self._turntable.start()
        elif not now.turntable:
            self._turntable.stop()
        self.canvas.ask_frame()

    def _look_from(self, view: ViewName) -> None:
        self.scene.look_from(view)
        self.canvas.ask_frame()

    def _turn(self) -> None:
        now = time.perf_counter()
        self.scene.turn(TURNTABLE * (now - self._turned_at))
        self._turned_at = now
        self.canvas.ask_frame()

    def _moved_by_hand(self) -> None:
        self._view.change(view="free")
        self.canvas.ask_frame()

    def name_muscle(self, key: str) -> None:
        """Name a muscle, by key, beside the pointer; an empty key ends it."""
        muscle = next((each for each in self._document.project.muscles if each.key == key), None)
        self._name(muscle, self.canvas.mapFromGlobal(QCursor.pos()))

    def _name(self, muscle: Muscle | None, place: QPoint) -> None:
        self.pointer.say("" if muscle is None else muscle_label(muscle), place)
        self.muscle_hovered.emit(muscle)

    def place_cards(self) -> None:
        """Stack the cards that are shown in the lower left corner, the first one at the bottom."""
        floor = self.height() - 2 * GRID
        for card in self._over:
            if not card.isHidden():
                card.adjustSize()
                card.move(2 * GRID, floor - card.height())
                floor -= card.height() + GRID


def _ready(project: Project, solution: Solution | None) -> None:
    """Compute what `Scene.show` needs and those who make it remember."""
    look_of(project.face)
    basis = neutral_basis(project) if solution is None else solution.basis
    contact_of(project.face, basis.display)

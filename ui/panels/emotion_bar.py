"""The emotions: a button each, and the strength of the one that is on."""

from __future__ import annotations

from html import escape

from PySide6.QtWidgets import QGridLayout, QVBoxLayout, QWidget

from app.document import Document
from app.weights import checked_weights, emotion_weights
from facemodel.actions import Emotion, Expression
from facemodel.project import Project
from ui.panels.emotion_match import shown_strength
from ui.portraits import NEUTRAL, Portraits
from ui.theme.metrics import GRID
from ui.widgets.activation_slider import ActivationSlider
from ui.widgets.collapsible import Collapsible
from ui.widgets.face_button import FaceButton
from ui.widgets.strength_button import StrengthButton

COLUMNS = 5


class EmotionBar(QWidget):
    """Binds the emotions of a document to buttons and one strength slider, both ways."""

    def __init__(self, document: Document, portraits: Portraits) -> None:
        super().__init__()
        self._document, self._portraits = document, portraits
        self._emotions: tuple[Emotion, ...] = ()
        self._full: dict[str, Expression] = {}
        self._active = ""
        self.buttons: dict[str, StrengthButton] = {}
        self.neutral = FaceButton("Neutral")
        self.neutral.setToolTip("Relax the whole face (0)")
        self.neutral.clicked.connect(lambda: self._document.reset_expression())
        self.strength = ActivationSlider("Strength")
        self.strength.setEnabled(False)
        self.strength.previewed.connect(lambda strength: self._preview(self._active, strength))
        self.strength.committed.connect(self._commit)
        self.strength.cancelled.connect(lambda: self._document.cancel_preview())
        self._grid, self._more = _grid(), _grid()
        self.variants = Collapsible("Variants")
        self.variants.rows.addLayout(self._more)
        self.variants.fold(True)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(GRID // 2)
        layout.addLayout(self._grid)
        layout.addWidget(self.variants)
        layout.addWidget(self.strength)
        portraits.taken.connect(self._show_portrait)
        self.show_project(document.project)

    def show_project(self, project: Project) -> None:
        """Offer the emotions of a project."""
        emotions = self._emotions = project.emotions
        for button in self.buttons.values():
            button.hide()
            button.deleteLater()
        self._full = {emotion.name: checked_weights(emotion.weights, project) for emotion in emotions}
        self.buttons = {emotion.name: self._button(emotion) for emotion in emotions}
        names = self.buttons.keys()
        variants = [emotion.name for emotion in emotions if emotion.family in names]
        first = [button for name, button in self.buttons.items() if name not in variants]
        for grid, shown in ((self._grid, [*first, self.neutral]), (self._more, [self.buttons[n] for n in variants])):
            for place, button in enumerate(shown):
                grid.addWidget(button, *divmod(place, COLUMNS))
        self.variants.setVisible(bool(variants))
        self.show_expression(self._document.shown)

    def show_expression(self, expression: Expression) -> None:
        """Show which emotion an expression is; the document hears nothing of it."""
        on, varied = 0.0, 0
        for emotion in self._emotions:
            strength = shown_strength(expression, self._full[emotion.name])
            self.buttons[emotion.name].set_strength(strength)
            if strength > 0:
                self._active, on = emotion.name, strength
                varied += emotion.family in self.buttons
        self.variants.heading.set_active(varied)
        held = self.strength.held or self._document.held
        if not held:
            self.strength.setEnabled(on > 0)
        named = on > 0 or self.strength.held
        self.strength.label = f"{self._active.capitalize()} strength" if named else "Strength"
        self.strength.set_weight(on)

    def _show_portrait(self, name: str) -> None:
        button = self.buttons.get(name) if name != NEUTRAL else self.neutral
        if button is not None:
            button.set_picture(self._portraits.picture(name))

    def _button(self, emotion: Emotion) -> StrengthButton:
        varied = emotion.family in {each.name for each in self._emotions}
        button = StrengthButton(emotion.title.split(", ", 1)[-1].capitalize() if varied else emotion.title)
        button.setAccessibleName(emotion.title)
        button.set_picture(self._portraits.picture(emotion.name))
        recipe = " + ".join(name for name in emotion.weights)
        button.setToolTip(f"{escape(f'{emotion.title}: {recipe}')}<br>Click for all of it, drag across for less")
        button.previewed.connect(lambda strength: self._preview(emotion.name, strength))
        button.committed.connect(self._commit)
        button.cancelled.connect(lambda: self._document.cancel_preview())
        button.pressed_fully.connect(lambda on: self._press(emotion.name, on))
        return button

    def _press(self, name: str, on: bool) -> None:
        if on:
            self._document.apply_emotion(name)
        else:
            self._document.reset_expression()

    def _preview(self, name: str, strength: float) -> None:
        self._active = name
        self._document.preview(emotion_weights(name, strength, self._document.project))

    def _commit(self) -> None:
        self._document.commit(self._active.capitalize())
        self.show_expression(self._document.shown)


def _grid() -> QGridLayout:
    """A grid whose columns are of one width, whatever the names below the faces."""
    grid = QGridLayout()
    grid.setSpacing(2)
    for column in range(COLUMNS):
        grid.setColumnStretch(column, 1)
    return grid

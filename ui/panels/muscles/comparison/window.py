"""The window in which the models of the selected muscle stand side by side; it follows selection and changes."""

from __future__ import annotations

from collections.abc import Callable

from PySide6.QtCore import QEvent, QObject, Qt, QTimer, Signal
from PySide6.QtGui import QHideEvent, QShowEvent
from PySide6.QtWidgets import QDialog, QHBoxLayout, QProgressBar, QPushButton, QVBoxLayout, QWidget

from app.actions.context import Context
from app.jobs import Failure, Job
from app.model_comparison import Comparing, ModelComparison, to_compare
from facemodel.errors import RisoriusError
from facemodel.model_fields import ModelFields
from facemodel.muscles.models import comparable_models
from facemodel.muscles.muscle import Model
from fem.types import FloatArray
from ui.panels.muscle_text import muscle_label
from ui.panels.muscles.comparison.card import PICTURE, ModelCard
from ui.panels.muscles.comparison.pictures import PictureAsked, drawn, standpoint
from ui.theme.metrics import GRID
from ui.viewport.colour_map import cividis
from ui.viewport.surface import ByteArray
from ui.widgets.legend_card import Legend, LegendScale
from ui.widgets.plain_label import PlainLabel
from ui.window.delivery import UiThread

SETTLED = 200
"""Milliseconds without another change after which models are compared anew."""

Camera = Callable[[], tuple[FloatArray, FloatArray]]
"""Unit vector to the eye and the camera's upward one, (3,) each, as one looks at the face now."""


class ComparisonWindow(QDialog):
    """Compares in the background, with progress and a way to stop; a click on a card chooses its model.

    Signals
    -------
    chosen(str) : a model, for the selected muscles
    """

    chosen = Signal(str)

    def __init__(self, parent: QWidget, context: Context, camera: Camera) -> None:
        super().__init__(parent)
        self.setWindowTitle("Models side by side")
        self.setWindowFlag(Qt.WindowType.Tool)
        self._context, self._camera = context, camera
        self._thread = UiThread(self)
        self._comparison = ModelComparison()
        self.job: Job[Comparing, ModelFields] = Job(self._comparison, self._thread.deliver)
        self.drawing: Job[PictureAsked, ByteArray] = Job(drawn, self._thread.deliver)
        self._waiting: list[PictureAsked] = []
        self.cards: dict[Model, ModelCard] = {}
        self.title = PlainLabel()
        self.title.setProperty("role", "title")
        self.words = PlainLabel()
        self.words.setProperty("role", "muted")
        self.words.setWordWrap(True)
        self.bar = QProgressBar()
        self.bar.setTextVisible(False)
        self.bar.setFixedHeight(4)
        self.legend = LegendScale()
        self.stop = QPushButton("Cancel")
        self.again = QPushButton("Compare again")
        for button in (self.stop, self.again):
            button.setAutoDefault(False)
        self._row = QHBoxLayout()
        self._settle = QTimer(self, singleShot=True, interval=SETTLED)
        self._lay_out()
        self._connect()
        parent.installEventFilter(self)

    def compare(self) -> None:
        """Begin to compare the muscle that is selected."""
        self._drop()
        try:
            asked = to_compare(self._context.document, self._context.view)
        except RisoriusError as error:
            self._make_cards(())
            self._say(str(error))
            return
        self.title.setText(muscle_label(asked.muscle))
        self._make_cards(comparable_models(asked.muscle))
        for card in self.cards.values():
            card.setChecked(card.model == asked.muscle.model)
            card.show_field(None, own=False)
        self.legend.hide()
        self.job.request(asked)

    def showEvent(self, event: QShowEvent) -> None:
        """Compare what is selected."""
        super().showEvent(event)
        self.compare()

    def hideEvent(self, event: QHideEvent) -> None:
        """Work for nobody no longer, and let go of what is large."""
        super().hideEvent(event)
        self._drop()
        self._comparison.forget()

    def eventFilter(self, _watched: QObject, event: QEvent) -> bool:
        """Go away with the window that it belongs to; minimising that is no leaving."""
        if event.type() == QEvent.Type.Hide and not event.spontaneous():
            self.close()
        return False

    def _connect(self) -> None:
        self._settle.timeout.connect(self.compare)
        document = self._context.document
        for signal in (document.muscles_changed, document.project_changed, document.layers_changed):
            signal.connect(self._change)
        document.skull_changed.connect(self._change)
        self._context.view.changed.connect(self._follow)
        self.job.started.connect(lambda _asked: self._begin())
        self.job.progress.connect(self._go_on)
        self.job.finished.connect(self._take)
        self.job.failed.connect(self._fail)
        self.job.cancelled.connect(lambda: self._say("Cancelled; nothing is shown."))
        self.drawing.finished.connect(self._hang)
        self.drawing.failed.connect(self._fail)
        self.stop.clicked.connect(self._stop)
        self.again.clicked.connect(self.compare)

    def _change(self, *_what: object) -> None:
        if self.isVisible():
            self._settle.start()

    def _follow(self, now: object, before: object) -> None:
        if getattr(now, "muscle", "") != getattr(before, "muscle", ""):
            self._change()

    def _drop(self) -> None:
        """Nobody waits for what is under way."""
        self._settle.stop()
        self._waiting = []
        for job in (self.drawing, self.job):
            if job.running:
                job.cancel()

    def _stop(self) -> None:
        self._drop()
        self._say("Cancelled. Click “Compare again” to begin anew.")

    def _begin(self) -> None:
        self.bar.setValue(0)
        self.bar.show()
        self.stop.show()
        self.again.hide()
        self.words.setText("Comparing …")

    def _go_on(self, text: str, share: float) -> None:
        self.bar.setValue(round(100 * share))
        self.words.setText(f"{text} …")

    def _take(self, fields: ModelFields, asked: Comparing) -> None:
        """Say what was found, and begin to draw it."""
        towards, up = self._camera()
        at = standpoint(fields, towards, up, PICTURE.width() / PICTURE.height())
        for model, field in fields.fields.items():
            self.cards[model].show_field(field, own=model == fields.muscle.model)
        top = max(fields.largest, 1e-6)
        self.legend.become(Legend("Displacement", "mm", 0.0, top, lambda values: cividis(values / top)))
        self.legend.show()
        size = next(iter(self.cards.values())).picture_size()
        face = asked.project.face
        self._waiting = [PictureAsked(face, fields, model, at, size) for model in fields.fields]
        self._draw_next()

    def _draw_next(self) -> None:
        if not self._waiting:
            self._say("At full contraction, from where you look. Click a model to use it.")
            return
        self.words.setText("Drawing …")
        self.drawing.request(self._waiting.pop(0))

    def _hang(self, picture: ByteArray, asked: PictureAsked) -> None:
        self.cards[asked.model].show_picture(picture)
        self._draw_next()

    def _fail(self, failure: Failure) -> None:
        self._say(failure.sentence)

    def _say(self, words: str) -> None:
        """Say how it ended."""
        self.words.setText(words)
        self.bar.hide()
        self.stop.hide()
        self.again.show()

    def _make_cards(self, models: tuple[Model, ...]) -> None:
        if tuple(self.cards) == models:
            return
        for card in self.cards.values():
            card.hide()
            card.deleteLater()
        self.cards = {model: ModelCard(model) for model in models}
        for card in self.cards.values():
            card.clicked.connect(lambda _checked=False, card=card: self._choose(card))
            self._row.addWidget(card)
        QTimer.singleShot(0, self.adjustSize)

    def _choose(self, card: ModelCard) -> None:
        for each in self.cards.values():
            each.setChecked(each is card)
        self.chosen.emit(card.model)

    def _lay_out(self) -> None:
        self._row.setSpacing(GRID)
        foot = QHBoxLayout()
        foot.setSpacing(2 * GRID)
        foot.addWidget(self.legend)
        foot.addStretch(1)
        foot.addWidget(self.stop)
        foot.addWidget(self.again)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(2 * GRID, 2 * GRID, 2 * GRID, 2 * GRID)
        layout.setSpacing(GRID)
        layout.addWidget(self.title)
        layout.addLayout(self._row)
        layout.addWidget(self.words)
        layout.addWidget(self.bar)
        layout.addLayout(foot)
        self.setMinimumWidth(46 * GRID)

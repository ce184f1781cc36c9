"""One action unit: number, a bar with its name, a split into left and right, a reset."""

from __future__ import annotations

from PySide6.QtCore import QRectF, Qt, Signal
from PySide6.QtGui import QColor, QPainter, QPaintEvent
from PySide6.QtWidgets import QGridLayout, QHBoxLayout, QLabel, QToolButton, QWidget

from app.authoring.sculpting import layers_of
from app.document import Document
from app.intensity import letter_of, typed_weight
from app.sides import both_sides
from app.view import View
from facemodel.actions import ActionUnit, Expression
from ui.panels.unit_text import MuscleTitles, unit_title, unit_tooltip
from ui.theme.apply import current_theme
from ui.theme.icons import icon
from ui.theme.metrics import GRID, ROW
from ui.widgets.activation_slider import ActivationSlider
from ui.widgets.plain_label import as_written
from ui.widgets.sculpted_mark import paint_sculpted
from ui.widgets.weight_gestures import WeightScale

NUMBER_WIDTH = 3 * GRID
BUTTON = 22
DOT = 4.0


class UnitRow(QWidget):
    """Binds one action unit of a document to sliders, both ways.

    Signals
    -------
    hovered(object) : frozenset of the keys of the muscles that move what is under the pointer
    """

    hovered = Signal(object)

    def __init__(self, document: Document, view: View, unit: ActionUnit, titles: MuscleTitles) -> None:
        super().__init__()
        self.unit = unit
        self._document = document
        self._view = view
        self._expression: Expression = {}
        self._sculpted = False
        self._titles = titles
        self._single = False
        self._number = QLabel(str(unit.number))
        self.slider = self._slider(unit_title(unit), "both", unit.fields)
        self.sides: tuple[ActivationSlider, ...] = ()
        self.split = _button("arrow-split-vertical", f"Left and right of {unit.name} apart")
        self.split.setCheckable(True)
        self.clear = _button("restore", f"Reset {unit.name}")
        self.clear.clicked.connect(self.slider.reset)
        self._lay_out()
        self.split.toggled.connect(self._unfold)
        self.split.clicked.connect(self._part)
        self.unfold(unit.opposed)
        self.mark_sculpted(bool(layers_of(document.project, unit)))
        self._explain()

    @property
    def weights(self) -> tuple[float, float]:
        """Weights of left and right, twice the same where there are no sides."""
        fields = self.unit.fields
        return self._expression.get(fields[0], 0.0), self._expression.get(fields[-1], 0.0)

    @property
    def changed(self) -> bool:
        """Whether it weighs anything."""
        return any(self.weights)

    def show_expression(self, expression: Expression) -> None:
        """Show the weights of an expression; the document hears nothing of it."""
        was_changed = self.changed
        self._expression = expression
        self.slider.set_weights(*self.weights)
        for slider, weight in zip(self.sides, self.weights, strict=False):
            slider.set_weight(weight)
        if was_changed != self.changed:
            self.clear.setVisible(self.changed)
            self.update()

    def become(self, unit: ActionUnit, titles: MuscleTitles) -> None:
        """Stand for the same unit made of other muscles."""
        self.unit, self._titles = unit, titles
        self._explain()
        for slider in (self.slider, *self.sides):
            slider.scale = weight_scale(unit)

    def mark_sculpted(self, on: bool) -> None:
        """Show whether somebody has sculpted the unit."""
        if on != self._sculpted:
            self._sculpted = on
            self._explain()
            self.update()

    def stand_alone(self) -> None:
        """Be the only row where it stands: number and marks, which tell it from others, are left out."""
        self._single = True
        self._number.hide()
        self._grid.setColumnMinimumWidth(1, 0)
        self._grid.setContentsMargins(0, 1, 0, 1)

    def unfold(self, unfolded: bool) -> None:
        """Show left and right apart, if it has them."""
        self.split.setChecked(unfolded and self.unit.paired)

    def preview(self, fields: tuple[str, ...], weight: float) -> None:
        """Show a weight of some of its fields, and of the other side too while the sides are linked."""
        weights = dict.fromkeys(fields, weight)
        self._document.preview(both_sides(weights, (self.unit,), self._view.state.linked))

    def paintEvent(self, _event: QPaintEvent) -> None:
        """The accent dot of a changed row, and the mark in the margin of one that is sculpted."""
        if self._single:
            return
        painter = QPainter(self)
        if self._sculpted:
            paint_sculpted(painter, QRectF(self.rect()))
        if self.changed:
            painter.setRenderHint(QPainter.RenderHint.Antialiasing)
            painter.setPen(Qt.PenStyle.NoPen)
            painter.setBrush(QColor(current_theme().accent))
            painter.drawEllipse(QRectF(GRID - DOT, (ROW - DOT) / 2, DOT, DOT))

    def _lay_out(self) -> None:
        number = self._number
        number.setProperty("role", "muted")
        number.setFixedWidth(NUMBER_WIDTH)
        number.setAlignment(Qt.AlignmentFlag.AlignRight | Qt.AlignmentFlag.AlignVCenter)
        self._grid = QGridLayout(self)
        self._grid.setContentsMargins(GRID, 1, GRID // 2, 1)
        self._grid.setHorizontalSpacing(2)
        self._grid.setVerticalSpacing(2)
        self._grid.addWidget(number, 0, 0)
        self._grid.setColumnMinimumWidth(1, GRID - 4)
        self._grid.addWidget(self.slider, 0, 2)
        for column, button in ((3, self.split), (4, self.clear)):
            self._grid.addWidget(button, 0, column)
            keep = button.sizePolicy()
            keep.setRetainSizeWhenHidden(True)
            button.setSizePolicy(keep)
        self.split.setVisible(self.unit.paired)
        self.clear.hide()
        self._grid.setColumnStretch(2, 1)

    def _explain(self) -> None:
        """Say on the slider and the number what the unit is made of."""
        told = unit_tooltip(self.unit, self._titles, self._sculpted)
        self.slider.setToolTip(told)
        self._number.setToolTip(told)

    def _unfold(self, unfolded: bool) -> None:
        if unfolded and not self.sides:
            self._make_sides()
        for slider in self.sides:
            slider.setVisible(unfolded)

    def _part(self, unfolded: bool) -> None:
        """A person who asks for the sides of a row wants to move one of them alone."""
        if unfolded:
            self._view.change(linked=False)

    def _make_sides(self) -> None:
        left, right = self.unit.fields
        self.sides = (self._slider("L", "left", (left,)), self._slider("R", "right", (right,)))
        line = QHBoxLayout()
        line.setSpacing(2)
        for slider, side, weight in zip(self.sides, ("left", "right"), self.weights, strict=True):
            slider.setAccessibleName(f"{unit_title(self.unit)}, {side}")
            slider.setToolTip(as_written(f"{unit_title(self.unit)}, the subject's {side}"))
            slider.set_weight(weight)
            line.addWidget(slider)
        self._grid.addLayout(line, 1, 2)
        QWidget.setTabOrder(self.slider, self.split)
        QWidget.setTabOrder(self.split, self.clear)
        QWidget.setTabOrder(self.clear, self.sides[0])
        QWidget.setTabOrder(*self.sides)

    def _point_at(self, fields: tuple[str, ...]) -> None:
        """Name the muscles of some of its fields."""
        sides = {field[-1] for field in fields} if self.unit.paired else {"L", "R"}
        muscles = self._document.project.muscles if fields else ()
        pulling = (m for m in muscles if m.name in self.unit.muscles and (m.side == "M" or m.side in sides))
        self.hovered.emit(frozenset(muscle.key for muscle in pulling))

    def _slider(self, label: str, side: str, fields: tuple[str, ...]) -> ActivationSlider:
        slider = ActivationSlider(label, side)  # type: ignore[arg-type]
        slider.scale = weight_scale(self.unit)
        slider.previewed.connect(lambda weight: self.preview(fields, weight))
        slider.committed.connect(lambda: self._document.commit())
        slider.cancelled.connect(lambda: self._document.cancel_preview())
        slider.hovered.connect(lambda inside: self._point_at(fields if inside else ()))
        return slider


def weight_scale(unit: ActionUnit) -> WeightScale:
    """How far the sliders of a unit go, and how their weights are scored."""
    return WeightScale(unit.limit, lambda weight: letter_of(weight, unit), lambda text: typed_weight(text, unit))


def _button(glyph: str, text: str) -> QToolButton:
    button = QToolButton()
    button.setIcon(icon(glyph, quiet=True))
    button.setAutoRaise(True)
    button.setToolTip(as_written(text))
    button.setAccessibleName(text)
    button.setProperty("role", "small")
    button.setFixedSize(BUTTON, BUTTON)
    button.setFocusPolicy(Qt.FocusPolicy.TabFocus)
    return button

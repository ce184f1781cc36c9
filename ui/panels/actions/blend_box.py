"""The pad that blends between the named expressions, with its numbers."""

from __future__ import annotations

from PySide6.QtCore import QPoint, Signal
from PySide6.QtGui import QShowEvent
from PySide6.QtWidgets import QCheckBox, QHBoxLayout, QVBoxLayout, QWidget

from app.actions.context import Context
from app.authoring.blending import shares
from app.authoring.pad import AT_REST, MIDDLE, arranged, blend_at, emptied, free_place, on_pad, parts_on, with_place
from app.weights import whole_expression
from facemodel.actions import Place
from facemodel.project import Project
from ui.panels.actions.tool_button import tool_button
from ui.panels.live_edit import LiveEdit
from ui.panels.telling import step, told
from ui.portraits import NEUTRAL, Portraits
from ui.theme.metrics import GRID
from ui.widgets.blend_pad import BlendPad, Knot
from ui.widgets.number_bar import NumberBar
from ui.widgets.number_scale import NumberScale

ACROSS = NumberScale(0.0, 1.0, 0.5)

LABEL = "Blend expressions"


class BlendBox(QWidget):
    """Binds pad and numbers to the places of expressions and to the sliders, both ways.

    Signals
    -------
    chosen(str) : an expression was pressed on the pad
    """

    chosen = Signal(str)

    def __init__(self, context: Context, portraits: Portraits) -> None:
        super().__init__()
        self._context, self._portraits = context, portraits
        self._live = LiveEdit(context.document)
        self._picked = ""
        self._pointer: Place = MIDDLE
        self.pad = BlendPad()
        self.pad.setToolTip(
            "Drag the point to blend · drag a face to place it, off the pad to take it away<br>"
            "Double-click shows one alone · arrows step, Shift finer · Esc takes a drag back"
        )
        self.x, self.y = (NumberBar(label, ACROSS) for label in ("Across", "Up"))
        self.rest = QCheckBox("Face at rest in the middle")
        self.rest.setToolTip("Blend towards the neutral face in the middle of the pad")
        self.rest.setChecked(True)
        self.put = tool_button("map-marker-plus-outline", "Place the chosen expression, or take it off", self._put)
        self.arrange = tool_button("vector-circle", "Arrange all expressions on a circle", self._arrange)
        self.empty = tool_button("close-circle-outline", "Take all expressions off the pad", self._empty)
        self._lay_out()
        self._connect()
        self.show_places()

    def show_places(self, *_what: object) -> None:
        """Show what lies on the pad."""
        project = self._context.document.project
        knots = [Knot(e.name, e.title, e.place, self._portraits.picture(e.name)) for e in on_pad(project) if e.place]
        if self.rest.isChecked():
            neutral = Knot(AT_REST, "Neutral", MIDDLE, self._portraits.picture(NEUTRAL), fixed=True)
            knots.insert(0, neutral)
        self.pad.show_knots(knots)
        self.empty.setEnabled(bool(on_pad(project)))
        self.arrange.setEnabled(bool(project.emotions))
        self._show_numbers()
        self._show_pointer()

    def pick(self, name: str) -> None:
        """Let the numbers mean the place of an expression; of none, or one that is not on the pad, the pointer."""
        self._picked = name
        self.pad.pick(name)
        self._show_numbers()

    def carry(self, name: object, over: QPoint | None) -> None:
        """An expression is dragged from the list over a place of the screen."""
        self.pad.carry(str(name), over)

    def let_fall(self, name: object, over: QPoint) -> None:
        """An expression was dragged from the list and let go over a place of the screen."""
        self.pad.carry(str(name), None)
        place = self.pad.place_at(over)
        if place is not None:
            self._place(str(name), place)

    def point(self, x: float, y: float) -> None:
        """Show what is seen at a place of the pad, as long as the hand is there."""
        self._pointer = x, y
        document = self._context.document
        if told(self._context, lambda: document.preview(self._blend(document.project))):
            self._show_numbers()
            self._show_pointer()

    def _blend(self, project: Project) -> dict[str, float]:
        return whole_expression(blend_at(project, self._pointer, self.rest.isChecked()), project)

    def _keep(self) -> None:
        self._context.document.commit(LABEL)
        self._show_pointer()

    def _take_back(self) -> None:
        self._pointer = self.pad.pointer
        self._context.document.cancel_preview()
        self._show_numbers()
        self._show_pointer()

    def _place(self, name: str, place: object) -> None:
        title = name.capitalize()
        at = (float(place[0]), float(place[1])) if isinstance(place, tuple) else None
        label = f"Place {title}" if at else f"Take {title} off the pad"
        step(self._context, lambda project: with_place(project, name, at), label)
        self.pick(name)
        self.chosen.emit(name)

    def _put(self) -> None:
        """Lay the chosen expression on a free place, or take it off."""
        there = self._picked_place() is not None
        self._place(self._picked, None if there else free_place(self._context.document.project))

    def _arrange(self) -> None:
        step(self._context, arranged, "Arrange the pad")

    def _empty(self) -> None:
        step(self._context, emptied, "Empty the pad")

    def _type(self, bar: NumberBar, value: float) -> None:
        """A number of the place that is picked, or else of the pointer."""
        place = self._picked_place()
        x, y = (value, self.y.value) if bar is self.x else (self.x.value, value)
        if place is None:
            self.point(x, y)
        else:
            label = f"Place {self._picked.capitalize()}"
            told(self._context, lambda: self._live.propose(lambda p: with_place(p, self._picked, (x, y)), label))

    def _let_go(self) -> None:
        if self._live.under_way:
            self._live.keep()
        else:
            self._keep()

    def _cancel(self) -> None:
        if self._live.under_way:
            self._live.cancel()
        else:
            self._context.document.cancel_preview()

    def _picked_place(self) -> Place | None:
        return next((e.place for e in on_pad(self._context.document.project) if e.name == self._picked), None)

    def _show_numbers(self) -> None:
        self.put.setEnabled(any(e.name == self._picked for e in self._context.document.project.emotions))
        place = self._picked_place()
        of = self._picked.capitalize() if place is not None else "Pointer"
        for bar, label, value in zip((self.x, self.y), ("across", "up"), place or self._pointer, strict=True):
            bar.label = f"{of} {label}"
            if not bar.held:
                bar.set_value(value)
            bar.update()

    def showEvent(self, event: QShowEvent) -> None:
        """Catch up with the face."""
        super().showEvent(event)
        self._show_pointer()

    def _follow(self, _now: object) -> None:
        """Another expression; nobody pays for it on the way of a slider to the screen who does not look at the pad."""
        if self.isVisible():
            self._show_pointer()

    def _show_pointer(self, *_now: object) -> None:
        """Show how much of each expression is meant, and whether the face shows just that."""
        document = self._context.document
        parts = parts_on(document.project, self.rest.isChecked())
        found = dict(zip(parts, shares([place for place, _ in parts.values()], self._pointer), strict=True))
        meant = False
        if on_pad(document.project):
            wanted = {name: weight for name, weight in self._blend(document.project).items() if weight}
            shown = {name: weight for name, weight in document.shown.items() if weight}
            meant = wanted == shown
        self.pad.show_blend(self._pointer, found, meant)

    def _connect(self) -> None:
        document, pad = self._context.document, self.pad
        for signal in (document.project_changed, document.emotions_changed, document.units_changed):
            signal.connect(self.show_places)
        document.expression_changed.connect(self._follow)
        self._portraits.taken.connect(self.show_places)
        pad.pointed.connect(self.point)
        pad.kept.connect(self._keep)
        pad.dropped.connect(self._take_back)
        pad.placed.connect(self._place)
        pad.chosen.connect(self.pick)
        pad.chosen.connect(self.chosen)
        self.rest.toggled.connect(self.show_places)
        for bar in (self.x, self.y):
            bar.previewed.connect(lambda value, bar=bar: self._type(bar, value))
            bar.committed.connect(self._let_go)
            bar.cancelled.connect(self._cancel)

    def _lay_out(self) -> None:
        numbers = QHBoxLayout()
        numbers.setSpacing(GRID // 2)
        numbers.addWidget(self.x)
        numbers.addWidget(self.y)
        below = QHBoxLayout()
        below.setSpacing(2)
        below.addWidget(self.rest, 1)
        below.addWidget(self.put)
        below.addWidget(self.arrange)
        below.addWidget(self.empty)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(GRID, 0, GRID, GRID)
        layout.setSpacing(GRID // 2)
        layout.addWidget(self.pad)
        layout.addLayout(numbers)
        layout.addLayout(below)

"""The central fibres of a muscle as a list: their order, their ends and the points where they bend, as numbers."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

import numpy as np
from PySide6.QtWidgets import QHBoxLayout, QLabel, QPushButton, QToolButton, QVBoxLayout, QWidget

from facemodel.laying.fibres import (
    bent,
    beside,
    fibre_of,
    removed_fibre,
    reordered,
    with_end,
    with_via,
    without_via,
)
from facemodel.muscles import Fibre, Muscle
from facemodel.muscles.curve import path
from fem.types import FloatArray
from ui.panels.actions.tool_button import tool_button
from ui.panels.muscles.editing import Change, MuscleEdit
from ui.panels.muscles.place_row import PlaceRow
from ui.theme.metrics import GRID
from ui.widgets.collapsible import Collapsible


class FibreRow(QWidget):
    """One central fibre.

    Parameters
    ----------
    edit : changes the selected muscle
    number : of the fibre, from 0
    bends : intermediate points that it has
    last : whether it is the last one of its muscle
    """

    def __init__(self, edit: MuscleEdit, number: int, bends: int, last: bool) -> None:
        super().__init__()
        self._edit, self._number = edit, number
        self.length = QLabel()
        self.length.setProperty("role", "muted")
        self.buttons: dict[str, QToolButton] = {}
        self.origin = self._place("Origin", "Where it comes from on the bone", partial(_with_end, end="origin"))
        self.bends = tuple(self._bend(place) for place in range(bends))
        self.attachment = self._place("Attachment", "Where it ends in the skin", partial(_with_end, end="attachment"))
        layout = QVBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, GRID // 2)
        layout.setSpacing(2)
        layout.addLayout(self._head(last))
        for row in (self.origin, *self.bends, self.attachment):
            layout.addWidget(row)

    def show_fibre(self, fibre: Fibre) -> None:
        """Show where a fibre is."""
        run = path(fibre)
        self.length.setText(f"{np.linalg.norm(np.diff(run, axis=0), axis=1).sum():.1f} mm")
        for row, place in zip((self.origin, *self.bends, self.attachment), fibre.points, strict=True):
            row.show_place(place)

    def _head(self, last: bool) -> QHBoxLayout:
        number = self._number
        line = QHBoxLayout()
        line.setSpacing(0)
        line.addWidget(QLabel(f"Fibre {number + 1}"))
        line.addSpacing(GRID)
        line.addWidget(self.length, 1)
        bend, remove = partial(_bent, number=number), partial(removed_fibre, number=number)
        earlier, later = (partial(reordered, number=number, to=number + step) for step in (-1, 1))
        deeds: tuple[tuple[str, str, str, Change, str], ...] = (
            ("bend", "vector-curve", "Bend it: one more point in its middle", bend, "Bend"),
            ("up", "arrow-up", "Earlier in the fan", earlier, "Order fibres of"),
            ("down", "arrow-down", "Later in the fan", later, "Order fibres of"),
            ("remove", "close", "Take this fibre out", remove, "Remove fibre of"),
        )
        for name, glyph, hint, change, label in deeds:
            self.buttons[name] = self._button(glyph, hint, change, label)
            line.addWidget(self.buttons[name])
        self.buttons["up"].setEnabled(number > 0)
        self.buttons["down"].setEnabled(not last)
        self.buttons["remove"].setEnabled(not (last and number == 0))
        return line

    def _button(self, glyph: str, hint: str, change: Change, label: str) -> QToolButton:
        button = tool_button(glyph, hint, lambda: self._edit.now(change, label, alone=True))
        button.setProperty("role", "small")
        return button

    def _bend(self, place: int) -> PlaceRow:
        number = self._number
        straighten = self._button(
            "close", "Take this bend out", partial(without_via, number=number, place=place), "Straighten"
        )
        change = partial(_with_via, place=place)
        return self._place(f"Bend {place + 1}", "A point that it goes through", change, straighten)

    def _place(
        self,
        caption: str,
        hint: str,
        change: Callable[[Muscle, int, FloatArray], Muscle],
        button: QToolButton | None = None,
    ) -> PlaceRow:
        row = PlaceRow(caption, hint, button)
        verb = "Bend" if button is not None else f"Move {caption.lower()} of"
        row.previewed.connect(
            lambda point: self._edit.propose(lambda muscle: change(muscle, self._number, point), verb, alone=True)
        )
        row.committed.connect(self._edit.keep)
        row.cancelled.connect(self._edit.cancel)
        return row


class FibreList(Collapsible):
    """All central fibres of the muscle that was selected last."""

    def __init__(self, edit: MuscleEdit) -> None:
        super().__init__("Fibres")
        self._edit = edit
        self._made_for: tuple[int, ...] | None = None
        self.fibres: list[FibreRow] = []
        self.add = QPushButton("Add a fibre beside the last")
        self.add.setProperty("role", "quiet")
        self.add.setToolTip("Or draw one: with the fibre tool (N), hold Shift, press on the bone and drag to the skin")
        self.add.clicked.connect(lambda: edit.now(self._grown, "Add fibre to", alone=True))
        self.rows.addWidget(self.add)

    def show_muscle(self, muscle: Muscle) -> None:
        """Show the fibres of a muscle; rows are made anew only where there are others."""
        asked = tuple(len(fibre.via) for fibre in muscle.fibres)
        if asked != self._made_for:
            self._make(asked)
        self.heading.set_active(len(muscle.fibres))
        for row, fibre in zip(self.fibres, muscle.fibres, strict=True):
            row.show_fibre(fibre)

    def _make(self, bends: tuple[int, ...]) -> None:
        self._made_for = bends
        for row in self.fibres:
            row.hide()
            row.deleteLater()
        self.fibres = [FibreRow(self._edit, k, count, k == len(bends) - 1) for k, count in enumerate(bends)]
        for place, row in enumerate(self.fibres):
            self.rows.insertWidget(place, row)

    def _grown(self, muscle: Muscle) -> Muscle:
        return beside(muscle, self._edit.context.document.project.face)


def _with_end(muscle: Muscle, number: int, point: FloatArray, end: str) -> Muscle:
    return with_end(muscle, number, end, point)  # type: ignore[arg-type]


def _with_via(muscle: Muscle, number: int, point: FloatArray, place: int) -> Muscle:
    return with_via(muscle, number, place, point)


def _bent(muscle: Muscle, number: int) -> Muscle:
    """A muscle with one more point in the middle of a fibre, where it is."""
    run = path(fibre_of(muscle, number))
    return bent(muscle, number, run[len(run) // 2])[0]

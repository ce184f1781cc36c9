"""The ring of a sphincter as numbers: where it lies, how long its half axes are, and how much of it there is."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

import numpy as np
from PySide6.QtWidgets import QHBoxLayout, QLabel

from facemodel.laying.rings import Axis, Sector, sector_of, with_axis, with_centre, with_length, with_sector
from facemodel.muscles import Muscle
from fem.types import FloatArray
from ui.panels.muscles.editing import MuscleEdit
from ui.panels.muscles.place_row import CAPTION, PlaceRow
from ui.widgets.collapsible import Collapsible
from ui.widgets.narrow_choice import narrow_choice
from ui.widgets.number_bar import NumberBar
from ui.widgets.number_scale import NumberScale

LENGTH = NumberScale(1.0, 80.0, 20.0, "mm", bend=1.6)

HALVES: dict[Sector, str] = {
    "whole": "The whole ring",
    "left": "Half towards the left",
    "right": "Half towards the right",
    "up": "Upper half",
    "down": "Lower half",
}


class RingForm(Collapsible):
    """Binds the ring of the muscle that was selected last to numbers."""

    def __init__(self, edit: MuscleEdit) -> None:
        super().__init__("Ring")
        self._edit = edit
        self.lengths = {axis: self._length(axis) for axis in ("long", "short")}
        self.centre = self._place("Middle", "The middle of the ring", with_centre)
        self.tips = {
            axis: self._place(f"{axis.capitalize()} tip", f"The end of the {axis} half axis", _to_tip(axis))
            for axis in ("long", "short")
        }
        self.half = narrow_choice("Part of the ring", "All of the ring, or the half of it that pulls")
        for sector, title in HALVES.items():
            self.half.addItem(title, sector)
        self.half.activated.connect(lambda _row: self._take_half())
        for row in (*self.lengths.values(), self.centre, *self.tips.values()):
            self.rows.addWidget(row)
        line = QHBoxLayout()
        words = QLabel("Part")
        words.setProperty("role", "muted")
        words.setFixedWidth(CAPTION)
        line.addWidget(words)
        line.addWidget(self.half, 1)
        self.rows.addLayout(line)

    def show_muscle(self, muscle: Muscle) -> None:
        """Show the ring of a muscle."""
        ring = muscle.ring
        assert ring is not None
        axes = {"long": ring.long_axis, "short": ring.short_axis}
        for axis, bar in self.lengths.items():
            if not bar.held:
                bar.set_value(float(np.linalg.norm(axes[axis])))
        self.centre.show_place(ring.centre)
        for axis, row in self.tips.items():
            row.show_place(ring.centre + axes[axis])
        self.half.setCurrentIndex(self.half.findData(sector_of(muscle)))

    def _take_half(self) -> None:
        self._edit.now(partial(with_sector, sector=self.half.currentData()), "Part of", alone=True)

    def _length(self, axis: Axis) -> NumberBar:
        bar = NumberBar(f"{axis.capitalize()} half axis", LENGTH)
        bar.setToolTip(
            f"Length of the {axis} half axis, in the direction that it has<br>Drag · double-click types · Shift finer"
        )
        bar.previewed.connect(
            lambda value: self._edit.propose(partial(with_length, axis=axis, length=value), "Stretch", alone=True)
        )
        bar.committed.connect(self._edit.keep)
        bar.cancelled.connect(self._edit.cancel)
        return bar

    def _place(self, caption: str, hint: str, change: Callable[[Muscle, FloatArray], Muscle]) -> PlaceRow:
        row = PlaceRow(caption, hint)
        verb = "Move" if change is with_centre else "Stretch"
        row.previewed.connect(lambda point: self._edit.propose(lambda muscle: change(muscle, point), verb, alone=True))
        row.committed.connect(self._edit.keep)
        row.cancelled.connect(self._edit.cancel)
        return row


def _to_tip(axis: Axis) -> Callable[[Muscle, FloatArray], Muscle]:
    return lambda muscle, point: with_axis(muscle, axis, point)

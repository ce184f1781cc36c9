"""Fields about the clip as a whole: what is played, and how new keys come to be."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from PySide6.QtWidgets import QComboBox

from app.timeline.actions import SHAPE_TITLES
from app.timeline.chosen import Chosen
from app.timeline.moving import Edited
from app.timeline.readings import Reading
from app.timeline.timeline import Timeline
from facemodel.animation.clip import FASTEST, SLOWEST, Animation
from facemodel.animation.editing.layers import CLOSEST
from facemodel.animation.editing.marks import played, with_rate
from ui.timeline.inspector.field import FieldBar, TimeBar
from ui.timeline.inspector.page import Page
from ui.widgets.number_bar import NumberBar
from ui.widgets.number_scale import NumberScale

SPACING = NumberScale(CLOSEST, 4.0, 0.25, "s", bend=2.0)
"""Seconds between the knots of a layer."""


class ClipPage(Page):
    """The clip."""

    def __init__(self, timeline: Timeline) -> None:
        super().__init__(timeline, "Clip")
        self.add(TimeBar(timeline, "Start", _of("start"), _with_start))
        self.add(TimeBar(timeline, "End", _of("end"), _with_end))
        rate = NumberScale(SLOWEST, FASTEST, 30.0, "fps")
        self.add(FieldBar(timeline, "Rate", rate, _of("rate"), lambda a, c, value: (with_rate(a, value), c)))
        self.gap()
        self.caption("New keys")
        self.shape = QComboBox()
        self.shape.setAccessibleName("How curves go on from new keys")
        self.shape.addItem("As the curve did there", None)
        for name, title in SHAPE_TITLES.items():
            self.shape.addItem(title, name)
        self.shape.activated.connect(lambda place: timeline.change(shape=self.shape.itemData(place)))
        self.add(self.shape)
        self.spacing = NumberBar("Knots of new layers", SPACING)
        self.spacing.previewed.connect(lambda value: timeline.change(spacing=value))
        self.add(self.spacing)
        self.refresh()

    def refresh(self) -> None:
        """Say what is so now."""
        super().refresh()
        state = self.timeline.state
        self.shape.setCurrentIndex(max(self.shape.findData(state.shape), 0))
        if not self.spacing.held:
            self.spacing.set_value(state.spacing)


def _of(name: str) -> Callable[[Animation, Chosen], Reading]:
    return lambda animation, _chosen: Reading(float(getattr(animation, name)))


def _with_start(animation: Animation, chosen: Chosen, time: float) -> Edited:
    return played(animation, min(time, animation.end - 1.0 / animation.rate), animation.end), chosen


def _with_end(animation: Animation, chosen: Chosen, time: float) -> Edited:
    return replace(animation, end=max(time, animation.start + 1.0 / animation.rate)), chosen

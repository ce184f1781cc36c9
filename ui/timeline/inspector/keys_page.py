"""Fields about keys: time, value, how the curve goes on, and the handles of a single one."""

from __future__ import annotations

from PySide6.QtWidgets import QComboBox

from app.timeline import deeds
from app.timeline.readings import (
    channel_of_keys,
    handle_of_key,
    start_of,
    value_of_keys,
    with_handle_of_key,
    with_start,
    with_value_of_keys,
)
from app.timeline.timeline import Timeline
from facemodel.animation.channels import Channel
from facemodel.animation.curve import SHAPES
from facemodel.animation.editing.eases import EASES
from facemodel.animation.editing.selection import curve_of_row
from ui.timeline.inspector.field import FieldBar, TimeBar
from ui.timeline.inspector.page import Page, choice_button
from ui.widgets.number_scale import NumberScale

GLYPHS = {"step": "stairs", "linear": "vector-line", "smooth": "chart-bell-curve", "bezier": "vector-bezier"}
HINTS = {
    "step": "Wait, then jump",
    "linear": "Go straight",
    "smooth": "Go smoothly, never past the keys",
    "bezier": "Follow the handles",
}
LONGEST_HANDLE = 2.0
"""Seconds that a handle reaches on its bar."""


class KeysPage(Page):
    """What the chosen keys are."""

    def __init__(self, timeline: Timeline) -> None:
        super().__init__(timeline, "Keys")
        units = timeline.document.project.units
        channel = channel_of_keys(timeline.chosen, units)
        self.add(TimeBar(timeline, "Time", start_of, with_start(units)))
        if channel is not None:
            self.add(FieldBar(timeline, "Value", scale_of(channel), value_of_keys, with_value_of_keys(units)))
        self.gap()
        self.shapes = {
            name: choice_button(GLYPHS[name], HINTS[name], lambda name=name: deeds.shape(timeline, name), False)
            for name in SHAPES
        }
        self.add(*self.shapes.values())
        self.ease = QComboBox()
        self.ease.setAccessibleName("Ease")
        self.ease.addItem("Ease…")
        for name, ease in EASES.items():
            self.ease.addItem(ease.title, name)
        self.ease.activated.connect(self._take_ease)
        self.add(self.ease)
        self._add_handles(channel)
        self.refresh()

    def refresh(self) -> None:
        """Say how many there are, and how their curves go on."""
        super().refresh()
        chosen, animation = self.timeline.chosen, self.timeline.animation
        count = chosen.key_count
        self.heading.setText(f"{count} KEYS" if count > 1 else "KEY")
        known = {
            SHAPES[int(code)]
            for row, places in chosen.keys.items()
            for code in curve_of_row(animation, row).shapes[list(places)]
        }
        for name, button in self.shapes.items():
            button.setChecked(known == {name})
        single = count == 1
        for field in self.fields[-4:] if len(self.fields) >= 5 else ():
            field.setVisible(single)
        flags = [
            (bool(curve_of_row(animation, row).weighted[place]), bool(curve_of_row(animation, row).broken[place]))
            for row, places in chosen.keys.items()
            for place in places
        ]
        self.weighted.setChecked(bool(flags) and all(weighs for weighs, _ in flags))
        self.broken.setChecked(bool(flags) and all(breaks for _, breaks in flags))

    def _add_handles(self, channel: Channel | None) -> None:
        timeline = self.timeline
        self.gap()
        weigh, breaks = "Let the length of the handles count", "Let the two handles turn on their own"
        self.weighted = choice_button("weight", weigh, lambda: self._flag(weighted=self.weighted.isChecked()), False)
        self.broken = choice_button("call-split", breaks, lambda: self._flag(broken=self.broken.isChecked()), False)
        self.add(self.weighted, self.broken)
        reach = 1.0 if channel is None else channel.high
        unit = "" if channel is None else channel.unit
        seconds, rise = NumberScale(0.0, LONGEST_HANDLE, 0.0, "s"), NumberScale(-reach, reach, 0.0, unit)
        for number, (label, scale) in enumerate(
            (("In, time", seconds), ("In, value", rise), ("Out, time", seconds), ("Out, value", rise))
        ):
            self.add(FieldBar(timeline, label, scale, handle_of_key(number), with_handle_of_key(number)))

    def _flag(self, weighted: bool | None = None, broken: bool | None = None) -> None:
        deeds.flag(self.timeline, weighted, broken)

    def _take_ease(self, place: int) -> None:
        name = self.ease.itemData(place)
        self.ease.setCurrentIndex(0)
        if name:
            deeds.ease(self.timeline, name)


def scale_of(channel: Channel) -> NumberScale:
    """The range of a channel's values."""
    if not channel.rigid:
        return NumberScale(channel.low, channel.high, 0.0)
    return NumberScale(channel.low, channel.high, 0.0, channel.unit)

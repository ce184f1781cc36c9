"""Fields about a displacement layer."""

from __future__ import annotations

from collections.abc import Callable

from app.timeline.chosen import Chosen
from app.timeline.layers import bake_layers, remove_layer
from app.timeline.moving import Edited
from app.timeline.readings import Reading
from app.timeline.timeline import Timeline
from facemodel.animation.clip import Animation
from facemodel.animation.displacement import Displacement
from facemodel.animation.editing.layers import with_layer_changed
from ui.timeline.inspector.clip_page import SPACING
from ui.timeline.inspector.field import FieldBar
from ui.timeline.inspector.marks_pages import NameLine
from ui.timeline.inspector.page import Page, push_button
from ui.widgets.number_scale import NumberScale


class LayerPage(Page):
    """A layer over a captured curve."""

    def __init__(self, timeline: Timeline) -> None:
        super().__init__(timeline, "Layer")
        (line,) = timeline.state.lines
        _, self._channel, number = line.split(" ")
        self._number = int(number)
        layer = self._layer(timeline.animation)
        self.add(NameLine(layer.name if layer else "", self._rename))
        self.add(FieldBar(timeline, "Knot spacing", SPACING, self._read("spacing"), self._write("spacing")))
        weight = NumberScale(0.0, 1.0, 1.0)
        self.add(FieldBar(timeline, "Weight", weight, self._read("weight"), self._write("weight")))
        self.gap()
        self.add(
            push_button("Bake", lambda: bake_layers(timeline, [self._channel]), "Make all layers part of the capture"),
            push_button("Remove", lambda: remove_layer(timeline, self._channel, self._number), "Remove this layer"),
        )

    def _layer(self, animation: Animation) -> Displacement | None:
        track = animation.track(self._channel)
        return None if track is None or self._number > len(track.layers) else track.layers[self._number - 1]

    def _read(self, name: str) -> Callable[[Animation, Chosen], Reading | None]:
        def read(animation: Animation, _chosen: Chosen) -> Reading | None:
            layer = self._layer(animation)
            return None if layer is None else Reading(float(getattr(layer, name)))

        return read

    def _write(self, name: str) -> Callable[[Animation, Chosen, float], Edited]:
        def write(animation: Animation, chosen: Chosen, value: float) -> Edited:
            return with_layer_changed(animation, self._channel, self._number, **{name: value}), chosen

        return write

    def _rename(self, name: str) -> None:
        made = with_layer_changed(self.timeline.animation, self._channel, self._number, name=name)
        self.timeline.edit(made, "Rename layer")

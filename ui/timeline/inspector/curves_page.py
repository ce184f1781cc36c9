"""Parameters of what is done to whole curves, seen at once; kept or taken back as one step."""

from __future__ import annotations

from app.timeline.timeline import LiveChange, Timeline
from app.timeline.whole import OPERATIONS, Operation, Parameter, Target, target_of
from facemodel.animation.clip import Animation
from facemodel.animation.timecode import written
from ui.timeline.inspector.page import Page, push_button
from ui.widgets.number_bar import NumberBar
from ui.widgets.number_scale import NumberScale


class CurvesPage(Page):
    """One operation on the curves that were meant when it was opened."""

    def __init__(self, timeline: Timeline) -> None:
        operation = OPERATIONS[timeline.state.page]
        super().__init__(timeline, operation.title)
        self._operation: Operation = operation
        self._target: Target = target_of(timeline)
        self._values = operation.usual
        if "rate" in self._values:
            self._values["rate"] = timeline.rate
        self._live: LiveChange | None = LiveChange(timeline, operation.title)
        self._shown: Animation = timeline.animation
        self.caption(operation.hint)
        self.what = self.caption(self._about())
        self.gap()
        self.bars = {each.name: self._bar(each) for each in operation.parameters}
        self.gap()
        self.add(
            push_button("Apply", self._keep, "Keep it (Enter)"), push_button("Cancel", self._drop, "Take it back (Esc)")
        )
        self._try()

    def refresh(self) -> None:
        """What somebody else has changed meanwhile ends the preview: it is as if it had been kept."""
        if self._live is not None and self.timeline.animation is not self._shown:
            self._live = None
            self.timeline.change(page="")

    def close_page(self) -> None:
        """What is seen is taken back unless it was kept."""
        live, self._live = self._live, None
        self.over = True
        if live is not None and self.timeline.animation is self._shown:
            live.cancel()

    def _bar(self, parameter: Parameter) -> NumberBar:
        scale = NumberScale(
            parameter.least, parameter.most, parameter.usual, parameter.unit, parameter.whole, parameter.bend
        )
        bar = NumberBar(parameter.label, scale)
        bar.set_value(self._values[parameter.name])
        bar.previewed.connect(lambda value: self._change(parameter.name, value))
        self.add(bar)
        return bar

    def _change(self, name: str, value: float) -> None:
        self._values[name] = value
        self._try()

    def _try(self) -> None:
        if self._live is not None:
            self._live.show(self._operation.apply(self._live.base, self._values, self._target))
            self._shown = self.timeline.animation

    def _keep(self) -> None:
        self._live, self.over = None, True
        self.timeline.change(page="")

    def _drop(self) -> None:
        self.close_page()
        self.timeline.change(page="")

    def _about(self) -> str:
        count = len(self._target.channels)
        what = f"{count} tracks" if count != 1 else "1 track"
        if not self._operation.asks_span:
            return what
        style, rate = self.timeline.state.style, self.timeline.rate
        return f"{what}, from {' to '.join(written(time, rate, style) for time in self._target.span)}"

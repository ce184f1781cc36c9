"""Fields about marks: key expressions, markers and named ranges."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import replace

from PySide6.QtWidgets import QLineEdit

from app.timeline.chosen import Chosen
from app.timeline.moving import Edited
from app.timeline.readings import Reading, start_of, with_start
from app.timeline.timeline import Timeline
from facemodel.animation.clip import Animation, NamedRange
from facemodel.animation.editing.expressions import renamed_expression
from facemodel.animation.editing.marks import with_marker, with_range, without_range
from ui.timeline.inspector.field import TimeBar
from ui.timeline.inspector.page import Page, push_button


class NameLine(QLineEdit):
    """A name that is taken when typing is over."""

    def __init__(self, name: str, take: Callable[[str], None]) -> None:
        super().__init__(name)
        self.setAccessibleName("Name")
        self.setPlaceholderText("Name")
        self.editingFinished.connect(lambda: take(self.text().strip()) if self.isModified() else None)


class ExpressionPage(Page):
    """Key expressions."""

    def __init__(self, timeline: Timeline) -> None:
        times = sorted(timeline.chosen.expressions)
        super().__init__(timeline, "Key expression" if len(times) == 1 else f"{len(times)} key expressions")
        if len(times) == 1:
            mark = next(each for each in timeline.animation.expressions if each.time == times[0])
            self.add(NameLine(mark.name, lambda name: self._rename(times[0], name)))
        self.add(TimeBar(timeline, "Time", start_of, with_start(timeline.document.project.units)))
        self.gap()
        self.add(push_button("Go there", lambda: timeline.playhead.go(times[0]), "Look at this expression"))

    def _rename(self, time: float, name: str) -> None:
        self.timeline.edit(renamed_expression(self.timeline.animation, time, name), "Rename key expression")


class MarkerPage(Page):
    """Markers."""

    def __init__(self, timeline: Timeline) -> None:
        times = sorted(timeline.chosen.markers)
        super().__init__(timeline, "Marker" if len(times) == 1 else f"{len(times)} markers")
        if len(times) == 1:
            marker = next(each for each in timeline.animation.markers if each.time == times[0])
            self.add(NameLine(marker.name, lambda name: self._rename(times[0], name)))
        self.add(TimeBar(timeline, "Time", start_of, with_start(timeline.document.project.units)))

    def _rename(self, time: float, name: str) -> None:
        self.timeline.edit(with_marker(self.timeline.animation, time, name), "Rename marker")


class RangePage(Page):
    """A named range."""

    def __init__(self, timeline: Timeline) -> None:
        super().__init__(timeline, "Named range")
        name = sorted(timeline.chosen.ranges)[0]
        self._name = name
        self.add(NameLine(name, self._rename))
        for label, is_end in (("Start", False), ("End", True)):
            self.add(TimeBar(timeline, label, self._read(is_end), self._write(is_end)))
        self.gap()
        self.add(push_button("Play this range", self._play, "Make this range what is played, and play it"))

    @property
    def _range(self) -> NamedRange | None:
        return _named(self.timeline.animation, self._name)

    def _read(self, is_end: bool) -> Callable[[Animation, Chosen], Reading | None]:
        def read(animation: Animation, _chosen: Chosen) -> Reading | None:
            each = _named(animation, self._name)
            return None if each is None else Reading(each.end if is_end else each.start)

        return read

    def _write(self, is_end: bool) -> Callable[[Animation, Chosen, float], Edited]:
        def write(animation: Animation, chosen: Chosen, time: float) -> Edited:
            each = _named(animation, self._name)
            if each is None:
                return animation, chosen
            start, end = (each.start, time) if is_end else (time, each.end)
            return with_range(animation, self._name, start, end), chosen

        return write

    def _rename(self, name: str) -> None:
        each, animation = self._range, self.timeline.animation
        if each is not None and name and name != self._name:
            made = with_range(without_range(animation, self._name), name, each.start, each.end)
            self.timeline.edit(made, "Rename range", chosen=Chosen(ranges=frozenset((name,))))

    def _play(self) -> None:
        each = self._range
        if each is not None:
            self.timeline.edit(replace(self.timeline.animation, start=each.start, end=each.end), "Play range")
            self.timeline.playhead.go(each.start)
            self.timeline.playhead.play()


def _named(animation: Animation, name: str) -> NamedRange | None:
    return next((each for each in animation.ranges if each.name == name), None)

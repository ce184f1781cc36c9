"""What part of the timeline is seen: a stretch of time, and how far its lines are scrolled; shared by its widgets."""

from __future__ import annotations

from psygnal import SignalInstance
from PySide6.QtCore import QObject, Signal

from app.timeline.lines import Kind, Line, lines_of
from app.timeline.state import TimelineState
from app.timeline.timeline import Timeline
from ui.timeline.row_layout import HEIGHTS, HIGHEST, LOWEST, RowLayout
from ui.timeline.time_scale import TimeScale, fitted

HAS_CURVES: frozenset[Kind] = frozenset(("group", "track", "layer"))
"""Lines beside the graph: what is not a curve is no use there."""


class TimelineView(QObject):
    """Holds scale, scroll and the laid out lines of a timeline.

    Signals
    -------
    moved() : another stretch of time or of the lines is seen
    relaid() : there are other lines
    content() : what is drawn on the lines is different
    framed() : a stretch of time was brought into view, and values are to be, too

    Parameters
    ----------
    timeline : what is seen
    """

    moved = Signal()
    relaid = Signal()
    content = Signal()
    framed = Signal()

    def __init__(self, timeline: Timeline) -> None:
        super().__init__()
        self.timeline = timeline
        self.width, self.height = 800, 200
        self.top = 0
        self.scale = TimeScale()
        self._whole = True
        self._track_height = HEIGHTS["track"]
        self.layout = RowLayout(())
        self._lay_out()
        timeline.changed.connect(self._follow_state)
        document = timeline.document
        document.animation_changed.connect(self._follow)
        document.units_changed.connect(self._follow)
        document.project_changed.connect(self._begin)

    @property
    def signals(self) -> tuple[SignalInstance, ...]:
        """After which other things may be possible than before."""
        return (self.timeline.changed, self.timeline.playhead.playing_changed)

    @property
    def lines(self) -> tuple[Line, ...]:
        """The lines from top to bottom."""
        return tuple(placed.line for placed in self.layout.rows)

    @property
    def lowest(self) -> int:
        """How far the lines can be scrolled."""
        return max(self.layout.height - self.height, 0)

    def see(self, scale: TimeScale) -> None:
        """See another stretch of time."""
        if scale != self.scale:
            self.scale, self._whole = scale, False
            self.moved.emit()

    def scroll(self, top: float) -> None:
        """See the lines from a height of the whole list."""
        kept = round(min(max(top, 0), self.lowest))
        if kept != self.top:
            self.top = kept
            self.moved.emit()

    def stretch(self, factor: float) -> None:
        """Draw tracks and layers higher or lower."""
        height = round(min(max(self._track_height * factor, LOWEST), HIGHEST))
        if height != self._track_height:
            self._track_height = height
            self._lay_out()
            self.content.emit()

    def resize(self, width: int, height: int) -> None:
        """Have so many pixels; until another stretch is chosen, all that is played stays in view."""
        self.width, self.height = max(width, 1), max(height, 1)
        if self._whole and width > 1:
            self.show_all()
        self.scroll(self.top)
        self.moved.emit()

    def show_all(self) -> None:
        """Bring all that is played into view."""
        animation = self.timeline.animation
        self.frame(animation.start, animation.end)
        self._whole = True

    def frame(self, start: float, end: float) -> None:
        """Bring a stretch of time into view."""
        self.see(fitted(start, end, self.width))
        self.framed.emit()

    def follow(self, x: float) -> None:
        """Go along with a hand that has gone over an edge, as far as it is beyond."""
        beyond = min(x, 0.0) + max(x - self.width, 0.0)
        if beyond:
            self.see(self.scale.panned(-beyond))

    def reveal(self, time: float) -> None:
        """Turn the page if a time is out of sight."""
        begin, end = self.scale.begin, self.scale.end(self.width)
        if not begin <= time <= end:
            margin = 0.1 * (end - begin)
            self.see(TimeScale(time - margin, self.scale.per_second).held())

    def _lay_out(self) -> None:
        project = self.timeline.document.project
        state = self.timeline.state
        lines = lines_of(project.animation, project.units, state)
        if state.mode == "curves":
            lines = tuple(line for line in lines if line.kind in HAS_CURVES)
        before = self.layout
        self.layout = RowLayout(lines, self._track_height, bool(project.animation.expressions))
        if [(p.line, p.height) for p in before.rows] != [(p.line, p.height) for p in self.layout.rows]:
            self.relaid.emit()
            self.scroll(self.top)

    def _follow(self, *_what: object) -> None:
        self._lay_out()
        self.content.emit()

    def _follow_state(self, now: TimelineState, before: TimelineState) -> None:
        if (now.sought, now.flipped, now.mode) != (before.sought, before.flipped, before.mode):
            self._lay_out()
        self.content.emit()

    def _begin(self, *_project: object) -> None:
        self._lay_out()
        self.show_all()
        self.content.emit()

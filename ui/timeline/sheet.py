"""The sheet: all lines over time on one surface."""

from __future__ import annotations

from PySide6.QtCore import QPointF, QRectF
from PySide6.QtGui import QMouseEvent, QPainter

from app.timeline.chosen import NOTHING, Chosen
from app.timeline.gestures import Spot
from app.timeline.gestures.box import Box
from ui.timeline.hands import Grip
from ui.timeline.hits import Hit, event_scale, hit, inside
from ui.timeline.line_paint import LinePainter
from ui.timeline.paint.events import EventScale
from ui.timeline.paint.ground import Pane, paint_grid, paint_outside
from ui.timeline.row_layout import Placed
from ui.timeline.sheet_grips import SheetGrips
from ui.timeline.time_canvas import Cursor, TimeCanvas
from ui.timeline.view import TimelineView

CURSORS = {
    "region": Cursor.SplitHCursor,
    "bound": Cursor.SplitHCursor,
    "handle": Cursor.SizeAllCursor,
}
"""What the pointer looks like over what a drag does something special with."""


class Sheet(TimeCanvas):
    """Shows the lines of a timeline and lets hands work on them.

    Parameters
    ----------
    view : what part of the timeline is seen
    painter : paints the lines
    """

    def __init__(self, view: TimelineView, painter: LinePainter) -> None:
        super().__init__(view)
        self._lines = painter
        self._values: EventScale | None = None
        self._grips = SheetGrips(self.timeline, self._inside, self.show_box)
        self.setAccessibleName("Keys over time")
        painter.refreshed.connect(self.refresh)

    def hit(self, place: QPointF) -> Hit:
        """What lies under a point."""
        placed = self.view.layout.at(place.y() + self.view.top)
        return hit(self.pane(), placed.line, self.area(placed), place) if placed is not None else Hit()

    def area(self, placed: Placed) -> QRectF:
        """Where a line is on the sheet."""
        return QRectF(0, placed.top - self.view.top, self.width(), placed.height)

    def grasp(self, found: Hit, spot: Spot) -> Grip:
        """What a press on something takes hold of."""
        placed = None if found.line is None else self.view.layout.of(found.line.key)
        if found.kind == "handle" and placed is not None:
            # The scale as it is now: while the peak is dragged it must not run away under the hand.
            self._values = event_scale(self.pane(), found.chosen, self.area(placed))
        return self._grips.grasp(found, spot)

    def value_at(self, place: QPointF) -> float:
        """The amplitude at a point, while the handle of an event is held."""
        return 0.0 if self._values is None else self._values.value(place.y())

    def cursor_over(self, found: Hit) -> Cursor:
        """What the pointer looks like over something."""
        return CURSORS.get(found.kind, Cursor.ArrowCursor)

    def mouseReleaseEvent(self, event: QMouseEvent) -> None:
        """Let go."""
        super().mouseReleaseEvent(event)
        if not self.hands.busy:
            self._values = None

    def draw(self, painter: QPainter, pane: Pane) -> None:
        """Draw the lines in sight."""
        paint_grid(painter, pane, self.height())
        for placed in self.view.layout.between(self.view.top, self.view.top + self.height()):
            self._lines.paint(painter, pane, placed.line, self.area(placed))
        paint_outside(painter, pane, self.height())

    def _inside(self, box: Box) -> Chosen:
        """What lies in a box."""
        left, top, right, bottom = box
        pane, found = self.pane(), NOTHING
        for placed in self.view.layout.between(top + self.view.top, bottom + self.view.top):
            area = QRectF(left, top, right - left, bottom - top)
            found = found.joined(inside(pane, placed.line, self.area(placed), area))
        return found

"""The graph: several curves on one pair of axes, to be bent by keys and handles."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QPointF, QRectF, Qt
from PySide6.QtGui import QMouseEvent, QPainter, QResizeEvent, QWheelEvent

from app.timeline.chosen import NOTHING, Chosen
from app.timeline.gestures import Gesture, Spot
from app.timeline.gestures.box import Box, ChooseInBox
from app.timeline.gestures.chosen_things import MoveChosen
from app.timeline.gestures.handles import DragHandle
from facemodel.animation.editing.selection import Row
from ui.theme.apply import current_theme
from ui.timeline.graph_curves import GraphCurve, graph_curves
from ui.timeline.hands import Grip
from ui.timeline.hits import FINGER, Hit
from ui.timeline.navigation import NOTCH, STEP
from ui.timeline.paint.graph import handle_places, key_places, paint_graph
from ui.timeline.paint.ground import Pane
from ui.timeline.paint.tracks import track_run
from ui.timeline.time_canvas import Cursor, TimeCanvas
from ui.timeline.value_scale import ValueScale, fitted_values
from ui.timeline.view import TimelineView

Keys = Qt.KeyboardModifier

SHARES = np.linspace(0.0, 1.0, 401)
"""Places across the graph at which the extent of a curve is taken."""


class Graph(TimeCanvas):
    """Shows curves and lets hands bend them.

    Parameters
    ----------
    view : what part of the timeline is seen
    """

    def __init__(self, view: TimelineView) -> None:
        super().__init__(view)
        self.values = ValueScale()
        self._fitted = False
        self._factor = 1.0
        self.setAccessibleName("Curves")
        view.framed.connect(self.frame_values)

    @property
    def curves(self) -> tuple[GraphCurve, ...]:
        """What is shown."""
        return graph_curves(self.timeline, self.view.lines, current_theme())

    def see_values(self, scale: ValueScale) -> None:
        """See other values."""
        if scale != self.values:
            self.values = scale
            self.refresh()

    def frame_values(self) -> None:
        """Bring the values of what is chosen, or of all curves in sight, into view."""
        low, high = _extent(self.pane(), self.curves)
        self.see_values(fitted_values(low, high, self.height()))

    def hit(self, place: QPointF) -> Hit:
        """The handle, key or curve under a point."""
        pane = self.pane()
        for curve in self.curves:
            for key, ahead, at in handle_places(pane, curve, self.values):
                if (at - place).manhattanLength() <= FINGER:
                    chosen = Chosen({curve.row: (key,)})
                    return Hit("handle", chosen=chosen, place=key, at_end=ahead)
        best: tuple[float, Hit] | None = None
        for curve in (each for each in self.curves if not each.track.locked):
            for key, at in key_places(pane, curve, self.values):
                away = (at - place).manhattanLength()
                if away <= FINGER + 2 and (best is None or away < best[0]):
                    time = float(curve.keys.times[key])
                    best = away, Hit("keys", chosen=Chosen({curve.row: (key,)}), time=time)
        return best[1] if best is not None else Hit()

    def grasp(self, found: Hit, spot: Spot) -> Grip:
        """What a press on something takes hold of."""
        if not found.chosen:
            return self._empty()
        ((row, (key,)),) = found.chosen.keys.items()
        self._factor = self._factor_of(row)
        if found.kind == "handle":
            return Grip(lambda _: DragHandle(self.timeline, row, key, found.at_end))
        chosen = self.timeline.chosen
        known = chosen.holds(found.chosen)
        several = spot.shift or spot.control
        if not known:
            self.timeline.choose(chosen.joined(found.chosen) if several else found.chosen)

        def begin(first: Spot) -> Gesture:
            return MoveChosen(self.timeline, found.time, first, copies=first.alt, rises=True)

        def click(_: Spot) -> None:
            if known:
                self.timeline.choose(chosen.toggled(found.chosen) if several else found.chosen)

        return Grip(begin, click)

    def value_at(self, place: QPointF) -> float:
        """The value at a point, in the unit of the curve that is held."""
        return self.values.value(place.y()) / self._factor

    def cursor_over(self, found: Hit) -> Cursor:
        """What the pointer looks like over something."""
        return Cursor.SizeAllCursor if found.kind == "handle" else Cursor.ArrowCursor

    def draw(self, painter: QPainter, pane: Pane) -> None:
        """Draw curves, keys and handles."""
        paint_graph(painter, pane, self.curves, self.values, self.height())

    def wheelEvent(self, event: QWheelEvent) -> None:
        """As on the sheet; with Shift values scroll, with Alt they are zoomed."""
        along = (event.angleDelta().y() or event.angleDelta().x()) / NOTCH
        if event.modifiers() & Keys.AltModifier:
            self.see_values(self.values.zoomed(STEP**along, event.position().y()))
            event.accept()
        elif event.modifiers() == Keys.ShiftModifier:
            self.see_values(self.values.panned(40.0 * along))
            event.accept()
        else:
            super().wheelEvent(event)

    def mouseMoveEvent(self, event: QMouseEvent) -> None:
        """Go on with what is held; the middle button moves values too."""
        before = self.navigator.last
        super().mouseMoveEvent(event)
        if before is not None and self.navigator.last is not None:
            gone = event.position().y() - before.y()
            if self.navigator.zooms:
                self.see_values(self.values.zoomed(STEP ** (-gone / 20.0), self.navigator.about.y()))
            else:
                self.see_values(self.values.panned(gone))

    def resizeEvent(self, event: QResizeEvent) -> None:
        """The first time all values are brought into view."""
        super().resizeEvent(event)
        if not self._fitted and event.size().height() > 40:
            self._fitted = True
            self.frame_values()

    def _empty(self) -> Grip:
        def begin(first: Spot) -> Gesture:
            return ChooseInBox(self.timeline, first, self._inside, self.show_box)

        def click(spot: Spot) -> None:
            if not (spot.shift or spot.control):
                self.timeline.choose(NOTHING)

        return Grip(begin, click)

    def _inside(self, box: Box) -> Chosen:
        """The keys in a box."""
        area, pane = QRectF(box[0], box[1], box[2] - box[0], box[3] - box[1]), self.pane()
        found: dict[Row, tuple[int, ...]] = {}
        for curve in self.curves:
            places = tuple(key for key, at in key_places(pane, curve, self.values) if area.contains(at))
            if places:
                found[curve.row] = places
        return Chosen(found)

    def _factor_of(self, row: Row) -> float:
        return next((curve.factor for curve in self.curves if curve.row == row), 1.0)


def _extent(pane: Pane, curves: tuple[GraphCurve, ...]) -> tuple[float, float]:
    """Lowest and highest value of the chosen keys, or of all curves in sight; rest and full if there is nothing."""
    ends: list[float] = []
    for curve in curves:
        places = list(pane.chosen.keys.get(curve.row, ()))
        if places:
            ends += (curve.factor * curve.keys.values[places]).tolist()
    if len(ends) > 1 and max(ends) > min(ends):
        return min(ends), max(ends)
    for curve in curves:
        times = pane.scale.begin + pane.scale.seconds(pane.width) * SHARES
        low, high = track_run(curve.track, times)
        ends += [float(curve.factor * low.min()), float(curve.factor * high.max())]
    low, high = min(ends, default=0.0), max(ends, default=1.0)
    return (low, high) if high - low > 1e-3 else (low, low + 1.0)

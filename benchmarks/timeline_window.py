"""The editor's window with a long capture on its timeline: real mouse events, and frames drawn for them."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from tempfile import TemporaryDirectory

from PySide6.QtCore import QEvent, QPoint, QPointF, Qt
from PySide6.QtGui import QMouseEvent
from PySide6.QtWidgets import QApplication, QWidget

from benchmarks.authoring_window import AuthoringWindow
from facemodel.animation.evaluation import Evaluator
from facemodel.project import Project

Left, None_ = Qt.MouseButton.LeftButton, Qt.MouseButton.NoButton

MARGIN = 60
"""Pixels from the edges of the ruler within which the hand scrubs."""


class TimelineWindow(AuthoringWindow):
    """A window with the timeline open, all of a clip in sight.

    Parameters
    ----------
    channel : whose layer is edited; its track is captured
    """

    def __init__(self, project: Project, folder: Path, channel: str) -> None:
        super().__init__(project, folder)
        self._desk = self.main.timeline
        self._desk.dock.open()
        self._settle()
        self._desk.view.show_all()
        self._evaluator = Evaluator(project.animation, project.units)
        self._step = 0
        self._desk.timeline.playhead.key({channel: 0.5})
        self._desk.timeline.change(sought="")
        self._desk.view.scroll(self._top_of(f"layer {channel} 1"))
        self._place = self._key_place(f"layer {channel} 1")
        self._settle()

    def begin_scrubbing(self) -> None:
        """Take hold of the playhead."""
        self._send_to(self._desk.panel.ruler, QEvent.Type.MouseButtonPress, QPoint(MARGIN, 10), Left, Left)

    def scrub(self) -> None:
        """Drag the playhead on, until the frame is drawn."""
        ruler = self._desk.panel.ruler
        place = QPoint(MARGIN + self._next(7) % (ruler.width() - 2 * MARGIN), 10)
        self._drawn_after(lambda: self._send_to(ruler, QEvent.Type.MouseMove, place, None_, Left))

    def end_scrubbing(self) -> None:
        """Let go of the playhead where the key is."""
        ruler = self._desk.panel.ruler
        place = QPoint(self._place.x(), 10)
        self._drawn_after(lambda: self._send_to(ruler, QEvent.Type.MouseMove, place, None_, Left))
        self._send_to(ruler, QEvent.Type.MouseButtonRelease, place, Left, None_)

    def begin_editing(self) -> None:
        """Take hold of the key of the layer."""
        self._send_to(self._desk.panel.sheet, QEvent.Type.MouseButtonPress, self._place, Left, Left)

    def edit(self) -> None:
        """Drag the key along, until the frame is drawn."""
        place = self._place + QPoint(8 + self._next(3) % 40, 0)
        sheet = self._desk.panel.sheet
        self._drawn_after(lambda: self._send_to(sheet, QEvent.Type.MouseMove, place, None_, Left))

    def end_editing(self) -> None:
        """Put the key down."""
        self._send_to(self._desk.panel.sheet, QEvent.Type.MouseButtonRelease, self._place, Left, None_)

    def pose(self) -> None:
        """Draw a frame of the clip in the viewport, and nothing else."""
        weights = self._evaluator.pose(0.37 * self._next(1)).weights
        viewport = self.main.viewport

        def show() -> None:
            viewport.scene.pose(weights)
            viewport.canvas.update()

        self._drawn_after(show)

    def _drawn_after(self, act: Callable[[], None]) -> None:
        canvas = self.main.viewport.canvas
        drawn = canvas.frames
        act()
        self._wait(lambda: canvas.frames > drawn)

    def _next(self, stride: int) -> int:
        self._step += stride
        return self._step

    def _top_of(self, key: str) -> int:
        placed = self._desk.view.layout.of(key)
        assert placed is not None, key
        return placed.top - placed.height

    def _key_place(self, key: str) -> QPoint:
        view = self._desk.view
        placed = view.layout.of(key)
        assert placed is not None, key
        x = round(view.scale.x(self._desk.timeline.playhead.time))
        return QPoint(x, placed.top - view.top + placed.height // 2)

    def _send_to(
        self, widget: QWidget, kind: QEvent.Type, place: QPoint, button: Qt.MouseButton, held: Qt.MouseButton
    ) -> None:
        over = QPointF(widget.mapToGlobal(place))
        event = QMouseEvent(kind, QPointF(place), over, button, held, Qt.KeyboardModifier.NoModifier)
        QApplication.sendEvent(widget, event)


@contextmanager
def timeline_window(project: Project, channel: str) -> Iterator[TimelineWindow]:
    """A window that is closed when it is no longer needed."""
    with TemporaryDirectory() as folder:
        window = TimelineWindow(project, Path(folder), channel)
        try:
            yield window
        finally:
            window.close()

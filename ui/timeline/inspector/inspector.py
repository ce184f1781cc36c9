"""The column at the right of the timeline: the page about what is chosen, or the one that was asked for."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from PySide6.QtCore import QTimer
from PySide6.QtWidgets import QFrame, QScrollArea, QVBoxLayout, QWidget

from app.timeline.state import TimelineState
from app.timeline.timeline import Timeline
from ui.theme.metrics import GRID
from ui.timeline.inspector.page import Page
from ui.timeline.inspector.subjects import subject_of

WIDTH = 29 * GRID

Make = Callable[[Timeline], Page]

SETTLE = 30
"""Milliseconds for which things may change further before fields follow."""


class Inspector(QScrollArea):
    """Shows one page at a time.

    Parameters
    ----------
    timeline : what it is about
    pages : make the page of a subject, by the first word of its name
    """

    def __init__(self, timeline: Timeline, pages: Mapping[str, Make]) -> None:
        super().__init__()
        self._timeline, self._pages = timeline, pages
        self._subject = ""
        self._roomy = True
        self.page: Page | None = None
        self.setFixedWidth(WIDTH)
        self.setFrameShape(QFrame.Shape.NoFrame)
        self.setWidgetResizable(True)
        self._timer = QTimer(self, singleShot=True, interval=SETTLE)
        self._timer.timeout.connect(self.refresh)
        timeline.changed.connect(self._follow_state)
        document = timeline.document
        for signal in (document.animation_changed, document.project_changed, document.units_changed):
            signal.connect(lambda *_what: self._timer.start())
        self.refresh()

    def refresh(self) -> None:
        """Show the page about what is chosen now."""
        if not self.isVisibleTo(self.parentWidget()) and self.page is not None:
            return
        subject = subject_of(self._timeline)
        held = self.page is not None and any(field.held for field in self.page.fields)
        if self.page is None or self.page.over or (subject != self._subject and not held):
            self._open(subject)
        else:
            self.page.refresh()
            if held:
                # What a hand holds is not taken away from under it.
                self._timer.start()

    @property
    def shown(self) -> bool:
        """Whether it is to be seen: as a person wants it, else as there is room."""
        wanted = self._timeline.state.fields
        return self._roomy if wanted is None else wanted

    def suit(self, roomy: bool) -> None:
        """Take note of whether there is room."""
        self._roomy = roomy
        self.setVisible(self.shown)

    def showEvent(self, event: object) -> None:
        """Catch up with what happened while nobody looked."""
        super().showEvent(event)
        self.refresh()

    def _open(self, subject: str) -> None:
        if self.page is not None:
            self.page.close_page()
        self._subject = subject
        self.page = self._pages[subject.partition(" ")[0]](self._timeline)
        holder = QWidget()
        column = QVBoxLayout(holder)
        column.setContentsMargins(0, 0, 0, 0)
        column.addWidget(self.page)
        self.setWidget(holder)

    def _follow_state(self, now: TimelineState, before: TimelineState) -> None:
        self.setVisible(self.shown)
        if (now.chosen, now.page, now.lines, now.style) != (before.chosen, before.page, before.lines, before.style):
            self._timer.start()

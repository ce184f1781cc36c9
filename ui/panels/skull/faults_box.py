"""What is wrong between skull and skin: told with numbers, and brought near by a button."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import QSize, Signal
from PySide6.QtWidgets import QHBoxLayout, QToolButton, QVBoxLayout, QWidget

from app.bone_watch import BoneWatch
from facemodel.skull.findings import Findings
from fem.types import FloatArray, IntArray
from ui.theme.icons import icon
from ui.theme.metrics import GRID, ICON
from ui.widgets.glyph import Glyph
from ui.widgets.plain_label import PlainLabel

WELL, WRONG, PENDING = ("check", "ok"), ("alert-circle-outline", "error"), ("dots-horizontal", "muted")
"""Glyphs and their colour."""


class FaultsBox(QWidget):
    """Follows what is found out about the skull.

    Signals
    -------
    place_asked(object) : the places (k, 3) of the skin that are to be brought near
    """

    place_asked = Signal(object)

    def __init__(self, watch: BoneWatch) -> None:
        super().__init__()
        self._watch = watch
        self.lines = {name: _Line() for name in ("pierced", "no length", "through")}
        layout = QVBoxLayout(self)
        layout.setContentsMargins(GRID, 0, GRID, 0)
        layout.setSpacing(GRID // 2)
        for line in self.lines.values():
            line.asked.connect(self._bring_near)
            layout.addWidget(line)
        watch.changed.connect(self._show)
        self._show()

    def _show(self) -> None:
        found = self._watch.found
        if found is None:
            for line in self.lines.values():
                line.say("Looking at the bone …", np.zeros(0, dtype=np.int64), pending=True)
            return
        self.lines["pierced"].say(found.complaint or "No bone comes through the skin.", found.pierced)
        self.lines["no length"].say(_no_length(found), found.no_length)
        self.lines["through"].say(_through(found), found.through_bone)

    def _bring_near(self, vertices: IntArray) -> None:
        """The first place, which is the worst, with those of its like about it."""
        found = self._watch.found
        if found is not None and len(vertices):
            skin: FloatArray = found.face.skin.positions
            about = np.linalg.norm(skin[vertices] - skin[vertices[0]], axis=1) < ABOUT
            self.place_asked.emit(skin[vertices[about]])


ABOUT = 25.0
"""Millimetres about the worst place that are looked at with it."""


def _no_length(found: Findings) -> str:
    count = int(found.faults.no_length.sum())
    if not count:
        return "No spring is without length."
    return f"{_springs(count)} without length at {_vertices(len(found.no_length))}; not solved."


def _through(found: Findings) -> str:
    count = int(found.faults.through.sum())
    if not count:
        return "No spring goes through bone."
    goes = "goes" if count == 1 else "go"
    return f"{_springs(count)} {goes} through bone at {_vertices(len(found.through_bone))}; not solved."


def _springs(count: int) -> str:
    return "1 spring" if count == 1 else f"{count} springs"


def _vertices(count: int) -> str:
    return "1 vertex" if count == 1 else f"{count} vertices"


class _Line(QWidget):
    """One kind of fault: a glyph, words, and a button that shows where."""

    asked = Signal(object)

    def __init__(self) -> None:
        super().__init__()
        self._vertices: IntArray = np.zeros(0, dtype=np.int64)
        self.glyph = Glyph("dots-horizontal")
        self.words = PlainLabel()
        self.words.setWordWrap(True)
        self.show_me = QToolButton()
        self.show_me.setIcon(icon("image-filter-center-focus"))
        self.show_me.setIconSize(QSize(ICON, ICON))
        self.show_me.setToolTip("Show where")
        self.show_me.setAccessibleName("Show where")
        self.show_me.clicked.connect(lambda: self.asked.emit(self._vertices))
        layout = QHBoxLayout(self)
        layout.setContentsMargins(0, 0, 0, 0)
        layout.setSpacing(GRID)
        layout.addWidget(self.glyph)
        layout.addWidget(self.words, 1)
        layout.addWidget(self.show_me)

    def say(self, words: str, vertices: IntArray, pending: bool = False) -> None:
        """Show a sentence and whether there is a fault."""
        self._vertices = vertices
        self.words.setText(words)
        self.glyph.become(*(PENDING if pending else WRONG if len(vertices) else WELL))
        self.show_me.setVisible(len(vertices) > 0)

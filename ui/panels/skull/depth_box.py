"""How deep the bone lies: as a map on the skin, and at the landmarks beside what tables say."""

from __future__ import annotations

import numpy as np
from PySide6.QtCore import Qt, Signal
from PySide6.QtWidgets import QCheckBox, QLabel, QVBoxLayout, QWidget

from app.bone_watch import BoneWatch
from app.tools.sight import Sight
from app.view import View
from facemodel.skull.findings import Findings
from ui.panels.skull.depth_table import DepthTable
from ui.theme.metrics import GRID


class DepthBox(QWidget):
    """Switches the map, and lists what is wanted and what is.

    Signals
    -------
    place_asked(object) : the places (k, 3) of the skin that are to be brought near
    """

    place_asked = Signal(object)

    def __init__(self, watch: BoneWatch, view: View, sight: Sight) -> None:
        super().__init__()
        self._watch, self._view = watch, view
        self.map = QCheckBox("Colour the skin by the depth of the bone")
        self.map.toggled.connect(lambda on: view.change(depth_map=on))
        self.words = QLabel()
        self.words.setProperty("role", "muted")
        self.words.setWordWrap(True)
        self.table = DepthTable()
        self.table.pointed.connect(sight.landmark_changed.emit)
        self.table.asked.connect(self._bring_near)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(GRID, 0, GRID, 0)
        layout.setSpacing(GRID // 2)
        for widget in (self.map, self.words, self.table):
            layout.addWidget(widget)
        layout.setAlignment(Qt.AlignmentFlag.AlignTop)
        view.changed.connect(self._show_map)
        watch.changed.connect(self._show)
        self._show_map()
        self._show()

    def _show_map(self, *_now: object) -> None:
        self.map.blockSignals(True)
        self.map.setChecked(self._view.state.depth_map)
        self.map.blockSignals(False)

    def _show(self) -> None:
        found = self._watch.found
        self.words.setText("" if found is None else told(found))
        self.table.show_landmarks(() if found is None else found.landmarks)

    def _bring_near(self, name: str) -> None:
        found = self._watch.found
        for each in found.landmarks if found is not None else ():
            if found is not None and each.name == name:
                self.place_asked.emit(found.face.skin.positions[[each.vertex]])


def told(found: Findings) -> str:
    """How well the depths meet the tables, in a sentence."""
    if not found.landmarks:
        return "This face has no landmarks whose depth is known."
    off = np.array([each.off for each in found.landmarks])
    worst = found.landmarks[int(np.abs(off).argmax())]
    return (
        f"The depths miss the tables by {np.sqrt((off**2).mean()):.1f} mm rms; "
        f"most at the {worst.title}, {worst.off:+.1f} mm."
    )

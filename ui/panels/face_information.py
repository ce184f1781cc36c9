"""Face information: the figures of the face in hand."""

from __future__ import annotations

from PySide6.QtCore import Qt
from PySide6.QtWidgets import QGridLayout, QLabel, QScrollArea, QVBoxLayout, QWidget

from app.document import Document
from ui.panels.face_figures import face_figures
from ui.theme.metrics import GRID
from ui.widgets.plain_label import PlainLabel


class FaceInformation(QScrollArea):
    """Follows a document; the figures can be selected and copied."""

    def __init__(self, document: Document) -> None:
        super().__init__()
        self._document = document
        self.setWidgetResizable(True)
        self.setMinimumWidth(32 * GRID)
        self.setHorizontalScrollBarPolicy(Qt.ScrollBarPolicy.ScrollBarAlwaysOff)
        document.project_changed.connect(self._refresh)
        document.solution_changed.connect(self._refresh)
        self._refresh()

    def _refresh(self, _now: object = None) -> None:
        inside = QWidget()
        inside.setProperty("role", "panel")
        layout = QVBoxLayout(inside)
        layout.setContentsMargins(GRID, GRID, GRID, 2 * GRID)
        layout.setSpacing(GRID)
        for title, lines in face_figures(self._document.project, self._document.solution):
            layout.addWidget(_heading(title))
            layout.addLayout(_table(lines))
        layout.addWidget(_heading("Provenance"))
        origin = _copyable(self._document.project.face.provenance)
        origin.setWordWrap(True)
        layout.addWidget(origin)
        layout.addStretch(1)
        self.setWidget(inside)


def _heading(text: str) -> QLabel:
    heading = QLabel(text.upper())
    heading.setProperty("role", "heading")
    heading.setContentsMargins(0, GRID, 0, 0)
    return heading


def _table(lines: tuple[tuple[str, str], ...]) -> QGridLayout:
    grid = QGridLayout()
    grid.setHorizontalSpacing(2 * GRID)
    grid.setVerticalSpacing(GRID // 2)
    grid.setColumnStretch(0, 1)
    for row, (name, value) in enumerate(lines):
        label = QLabel(name)
        label.setProperty("role", "muted")
        figure = _copyable(value)
        figure.setAlignment(Qt.AlignmentFlag.AlignRight)
        grid.addWidget(label, row, 0)
        grid.addWidget(figure, row, 1)
    return grid


def _copyable(text: str) -> QLabel:
    label = PlainLabel(text)
    label.setTextInteractionFlags(Qt.TextInteractionFlag.TextSelectableByMouse)
    return label

"""Which skull it is: the one of the shipped face, or one that is imported."""

from __future__ import annotations

from PySide6.QtWidgets import QHBoxLayout, QLabel, QPushButton, QVBoxLayout, QWidget

from app.actions.context import Context
from app.authoring.skull import has_template
from app.tools.tool import Bench
from ui.panels.skull.deeds import import_skull, use_template
from ui.panels.tissue.choices import Buttons
from ui.theme.metrics import GRID
from ui.widgets.plain_label import PlainLabel


class BoneBox(QWidget):
    """Says how much bone there is, imports another skull, and brings the shipped one back."""

    def __init__(self, context: Context, bench: Bench) -> None:
        super().__init__()
        self._document, self._bench = context.document, bench
        self.words = QLabel()
        self.words.setProperty("role", "muted")
        self.words.setWordWrap(True)
        self.buttons = Buttons(
            (
                (
                    "Import skull…",
                    "Take a skull from an OBJ, PLY or STL file and fit it to the head by landmarks",
                    lambda: import_skull(context, bench),
                ),
                (
                    "Template skull",
                    "Go back to the skull that the face is shipped with, where and as it was",
                    lambda: use_template(context),
                ),
            ),
            2,
        )
        self.step = PlainLabel()
        self.step.setProperty("role", "muted")
        self.stop = QPushButton("Cancel")
        self.stop.clicked.connect(bench.importing.stop)
        line = QHBoxLayout()
        line.addWidget(self.step, 1)
        line.addWidget(self.stop)
        layout = QVBoxLayout(self)
        layout.setContentsMargins(GRID, 0, GRID, 0)
        layout.setSpacing(GRID // 2)
        layout.addWidget(self.words)
        layout.addWidget(self.buttons)
        layout.addLayout(line)
        bench.importing.progress.connect(self._tell)
        bench.importing.failed.connect(context.host.show_error)
        self._document.project_changed.connect(self._show)
        self._document.skull_changed.connect(self._show)
        self._document.layers_changed.connect(self._show)
        self._show()
        self._tell("")

    def _show(self, *_now: object) -> None:
        project = self._document.project
        skull = project.face.skull
        cranium, jaw = len(skull.cranium.triangles), len(skull.mandible.triangles)
        of_jaw = f"{counted(jaw)} of them jaw" if jaw else "none of them jaw"
        self.words.setText(f"{counted(cranium + jaw)} triangles of bone, {of_jaw}.")
        self.buttons.by_name["Template skull"].setEnabled(has_template(project))

    def _tell(self, text: str) -> None:
        """What is being done to a file that is read."""
        self.step.setText(f"{text} …" if text else "")
        self.step.setVisible(bool(text))
        self.stop.setVisible(bool(text))
        self.buttons.by_name["Import skull…"].setEnabled(not text)


def counted(number: int) -> str:
    """A number with thin spaces between thousands."""
    return f"{number:,}".replace(",", "\N{NARROW NO-BREAK SPACE}")

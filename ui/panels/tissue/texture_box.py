"""The layer in hand as a picture: out to other painting programs, and in again."""

from __future__ import annotations

from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from PySide6.QtCore import Qt
from PySide6.QtGui import QGuiApplication
from PySide6.QtWidgets import QVBoxLayout, QWidget

from app.actions.context import Context, FileQuestion
from app.actions.paths import folder, with_suffix
from app.commands import paint_deltas
from app.tools.tool import Bench
from facemodel.errors import RisoriusError
from facemodel.io.texture import export_layer, import_layer
from facemodel.painting.layers import PaintLayer
from ui.panels.tissue.choices import Buttons
from ui.theme.metrics import GRID

KIND, SUFFIX = "PNG picture", ".png"


@contextmanager
def patience() -> Iterator[None]:
    """Let the pointer say that this takes a moment."""
    QGuiApplication.setOverrideCursor(Qt.CursorShape.WaitCursor)
    try:
        yield
    finally:
        QGuiApplication.restoreOverrideCursor()


class TextureBox(QWidget):
    """Asks for a file, and writes or reads the layer in hand through the texture coordinates of the face."""

    def __init__(self, context: Context, bench: Bench) -> None:
        super().__init__()
        self._context, self._bench = context, bench
        self.buttons = Buttons(
            (
                ("Import…", "Take the layer from a picture in the face's texture coordinates", self._import),
                ("Export…", "Write the layer as a picture with 16 bits, to be painted elsewhere", self._export),
            ),
            2,
        )
        layout = QVBoxLayout(self)
        layout.setContentsMargins(GRID, 0, GRID, 0)
        layout.addWidget(self.buttons)

    @property
    def _layer(self) -> PaintLayer:
        return self._bench.brush.state.paint_layer

    def _import(self) -> None:
        path = self._asked("Import", writes=False)
        if path is None:
            return
        document = self._context.document
        try:
            delta = import_layer(document.project.face, self._layer, path)
            document.run(paint_deltas((delta,), f"Import {self._layer.title.lower()}"))
        except RisoriusError as error:
            self._context.host.show_error(str(error))
            return
        count = len(delta)
        self._context.host.show_message(f"“{path.name}” changed {count} {'vertex' if count == 1 else 'vertices'}.")

    def _export(self) -> None:
        path = self._asked("Export", writes=True)
        if path is None:
            return
        try:
            with patience():
                loss = export_layer(self._context.document.project.face, self._layer, with_suffix(path, SUFFIX))
        except RisoriusError as error:
            self._context.host.show_error(str(error))
            return
        lost = len(loss.vertices)
        coarse = f"; it is too coarse for {lost} vertices, which share their texels with others" if lost else ""
        self._context.host.show_message(f"Wrote “{path.name}”{coarse}.")

    def _asked(self, verb: str, writes: bool) -> Path | None:
        start = folder(self._context)
        if writes:
            start /= f"{self._context.document.project.face.key}-{self._layer.key}{SUFFIX}"
        title = f"{verb} {self._layer.title.lower()}"
        return self._context.host.ask_path(FileQuestion(title, KIND, SUFFIX, start, writes))

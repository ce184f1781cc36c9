"""Text that may hold a name that somebody gave: it is shown as it is written, even where it looks like markup."""

from __future__ import annotations

from html import escape

from PySide6.QtCore import Qt
from PySide6.QtGui import Qt as TextOf
from PySide6.QtWidgets import QLabel, QWidget


class PlainLabel(QLabel):
    """A label in which nothing is markup."""

    def __init__(self, text: str = "", parent: QWidget | None = None) -> None:
        super().__init__(text, parent)
        self.setTextFormat(Qt.TextFormat.PlainText)


def as_written(tip: str) -> str:
    """A tooltip in which nothing is markup; Qt makes up its own mind about each of them, by its letters."""
    return f"<p>{escape(tip)}</p>" if TextOf.mightBeRichText(tip) else tip

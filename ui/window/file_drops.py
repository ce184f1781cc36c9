"""Files that are dropped on the window: projects are opened, what a timeline takes in comes into it."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from pathlib import Path

from PySide6.QtCore import QEvent, QObject
from PySide6.QtGui import QDropEvent
from PySide6.QtWidgets import QWidget

from app.actions.context import Context
from app.actions.files import SUFFIX, open_path

Open = Callable[[Path], None]


class FileDrops(QObject):
    """Welcomes files on a window.

    Parameters
    ----------
    window : what they are dropped on
    context : where projects are opened
    others : what opens files with other endings, which are written small and with their dot
    """

    def __init__(self, window: QWidget, context: Context, others: Mapping[str, Open]) -> None:
        super().__init__(window)
        self._openers: Mapping[str, Open] = {**others, SUFFIX: lambda path: open_path(context, path)}
        window.setAcceptDrops(True)
        window.installEventFilter(self)

    def eventFilter(self, _window: QObject, event: QEvent) -> bool:
        """Take a drag that carries a file of a known kind, and open the first one that is dropped."""
        if isinstance(event, QDropEvent) and (path := self._known(event)) is not None:
            event.acceptProposedAction()
            if event.type() == QEvent.Type.Drop:
                self._openers[path.suffix.lower()](path)
            return True
        return False

    def _known(self, event: QDropEvent) -> Path | None:
        """The first file that a drag carries and that can be opened."""
        urls = event.mimeData().urls()
        paths = [Path(url.toLocalFile()) for url in urls if url.isLocalFile()]
        return next((path for path in paths if path.suffix.lower() in self._openers), None)

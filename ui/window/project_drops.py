"""Projects that are dropped on the window are opened."""

from __future__ import annotations

from pathlib import Path

from PySide6.QtCore import QEvent, QObject
from PySide6.QtGui import QDragEnterEvent, QDropEvent
from PySide6.QtWidgets import QWidget

from app.actions.context import Context
from app.actions.files import SUFFIX, open_path


class ProjectDrops(QObject):
    """Welcomes projects on a window.

    Parameters
    ----------
    window : what they are dropped on
    context : where they are opened
    """

    def __init__(self, window: QWidget, context: Context) -> None:
        super().__init__(window)
        self._context = context
        window.setAcceptDrops(True)
        window.installEventFilter(self)

    def eventFilter(self, _window: QObject, event: QEvent) -> bool:
        """Take a drag that carries a project, and open the first one that is dropped."""
        if isinstance(event, QDropEvent) and (paths := _projects(event)):
            event.acceptProposedAction()
            if not isinstance(event, QDragEnterEvent) and event.type() == QEvent.Type.Drop:
                open_path(self._context, paths[0])
            return True
        return False


def _projects(event: QDropEvent) -> list[Path]:
    """The projects that a drag carries."""
    urls = event.mimeData().urls()
    paths = [Path(url.toLocalFile()) for url in urls if url.isLocalFile()]
    return [path for path in paths if path.suffix.lower() == SUFFIX]

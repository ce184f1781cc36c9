"""Unsaved work while the editor runs, and the offer of what a killed one has left."""

from __future__ import annotations

from datetime import datetime
from pathlib import Path

from PySide6.QtCore import QObject, QTimer

from app.actions.files import may_leave
from app.autosave import Autosave
from app.journal import Recoverable
from facemodel.errors import ProjectError
from ui.window.delivery import UiThread
from ui.window.main_window import MainWindow
from ui.window.recovery_offer import RecoveryOffer


class Safekeeping(QObject):
    """Keeps the journal of a window's document for as long as the window is open, and says so at its bottom.

    Parameters
    ----------
    window : whose document is kept safe
    folder : of the journals; the one beside the preferences if not given
    """

    def __init__(self, window: MainWindow, folder: Path | None = None) -> None:
        super().__init__(window)
        self._window = window
        self._document = window.context.document
        self._autosave = Autosave(self._document, UiThread(self).deliver, folder)
        self._autosave.written.connect(self._tell_time)
        self._autosave.failed.connect(self._tell_failure)
        self._document.saved_changed.connect(self._forget_time)
        window.closed.connect(self._autosave.close)

    def offer_soon(self) -> None:
        """Offer what killed sessions have left, once the window is up; nothing is asked if there is nothing."""
        QTimer.singleShot(0, self, self._offer)

    def _offer(self) -> None:
        found = self._autosave.recoverable()
        if not found:
            return
        offer = RecoveryOffer(self._window, found)
        offer.declined.connect(self._autosave.decline)
        offer.accepted_entry.connect(self._bring_back)
        offer.open()

    def _bring_back(self, entry: Recoverable) -> None:
        if not may_leave(self._window.context):
            return
        host = self._window.context.host
        try:
            self._autosave.accept(entry)
        except ProjectError as error:
            host.show_error(str(error))
            return
        host.show_message(f"Brought back “{entry.name}”; save it to keep it.")

    def _tell_time(self, when: datetime) -> None:
        if self._document.dirty:
            self._window.status.show_kept(
                f"autosaved {when:%H:%M}", "Changes that are not saved come back if Risorius or the computer fails"
            )

    def _tell_failure(self, sentence: str) -> None:
        self._window.status.show_kept("not autosaved", sentence)
        self._window.status.notify(sentence)

    def _forget_time(self) -> None:
        if not self._document.dirty:
            self._window.status.show_kept("", "")

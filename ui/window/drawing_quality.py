"""How finely the viewport draws: as it was asked for, or as finely as it moves fluidly."""

from __future__ import annotations

from PySide6.QtCore import QObject, Signal

from app.quality import LEVELS, QUALITY_TITLES, Level, Pacing, finest
from app.settings import UserSettings
from app.view import View
from app.view_state import ViewState
from ui.window.canvas import Canvas


class DrawingQuality(QObject):
    """Chooses how finely a canvas draws, by what the view asks for and how long its frames take.

    What is asked for is remembered in the settings.

    Parameters
    ----------
    canvas : what draws
    view : what is asked for, and where is told what is drawn
    settings : where it is remembered

    Signals
    -------
    changed(str) : one sentence; the level has become another without being asked for
    """

    changed = Signal(str)

    def __init__(self, canvas: Canvas, view: View, settings: UserSettings) -> None:
        super().__init__(canvas)
        self._canvas, self._view, self._settings = canvas, view, settings
        self._software = True
        preferences = settings.preferences
        view.change(quality=preferences.quality, least_rate=preferences.least_rate)
        self._pacing = self._begin()
        canvas.driver_known.connect(self._meet_driver)
        canvas.moved.connect(self._note_motion)
        canvas.rested.connect(self._note_rest)
        view.changed.connect(self._follow)

    def _begin(self) -> Pacing:
        """Begin anew with what is asked for; a driver without a graphics card is trusted with little at first."""
        state = self._view.state
        if state.quality != "automatic":
            pacing = Pacing(finest(state.quality, "balanced"), state.quality, state.least_rate)
        elif self._software:
            pacing = Pacing("balanced", "fast", state.least_rate)
        else:
            pacing = Pacing("full", "full", state.least_rate)
        self._take(pacing)
        return pacing

    def _take(self, pacing: Pacing) -> None:
        self._canvas.moving, self._canvas.resting = pacing.moving, pacing.resting
        self._view.change(level=pacing.moving)

    def _meet_driver(self, software: bool) -> None:
        self._software = software
        self._pacing = self._begin()

    def _note_motion(self, whole: float, drawing: float) -> None:
        took, before = self._pacing.took, self._pacing.moving
        if self._view.state.quality == "automatic" and self._pacing.moved(whole, drawing):
            self._tell(before, f"{max(took, self._pacing.took):.0f} ms a frame were too slow")

    def _note_rest(self, drawing: float) -> None:
        before = self._pacing.moving
        if self._view.state.quality == "automatic" and self._pacing.rested(drawing):
            self._tell(before, "frames are quick enough for it")

    def _tell(self, before: Level, why: str) -> None:
        """Draw at the level found, and say so if it is seen in motion."""
        self._take(self._pacing)
        now = self._pacing.moving
        if now != before:
            self._pacing.begin_anew()
            way = "down" if LEVELS.index(now) < LEVELS.index(before) else "up"
            self.changed.emit(f"Drawing quality went {way} to {QUALITY_TITLES[now]}: {why}.")

    def _follow(self, now: ViewState, before: ViewState) -> None:
        if (now.quality, now.least_rate) == (before.quality, before.least_rate):
            return
        self._settings.change(quality=now.quality, least_rate=now.least_rate)
        if now.quality != before.quality:
            self._pacing = self._begin()
        else:
            self._pacing = Pacing(self._pacing.resting, self._pacing.moving, now.least_rate)
        self._canvas.ask_frame()

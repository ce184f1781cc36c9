"""How a film is to look."""

from __future__ import annotations

from dataclasses import replace

from PySide6.QtCore import Signal
from PySide6.QtWidgets import QCheckBox, QWidget

from app.film import ANTIALIAS, DEFAULT_FILM, Film
from app.view_state import VIEW_TITLES
from ui.headless.picture import LARGEST
from ui.panels.export.form import Form, choice, choose
from ui.widgets.number_bar import NumberBar
from ui.widgets.number_scale import NumberScale

SIZES = {
    "1280x720": "HD, 1280 × 720",
    "1920x1080": "Full HD, 1920 × 1080",
    "3840x2160": "4K, 3840 × 2160",
    "1080x1080": "Square, 1080 × 1080",
    "1080x1920": "Upright, 1080 × 1920",
    "640x360": "Small, 640 × 360",
    "own": "Own size",
}
"""What videos usually measure."""

SMALLEST = 16
"""Pixels per side."""

FRAMING = {"head": "Whole head", "face": "Face alone"}
BACKDROPS = {"dark": "Dark", "light": "Light"}


class FilmBox(QWidget):
    """Size, view, turntable, antialiasing, backdrop and sound.

    Signals
    -------
    changed() : something else is chosen
    """

    changed = Signal()

    def __init__(self) -> None:
        super().__init__()
        self.size_choice = choice("Size", SIZES)
        self.wide = NumberBar("Width", NumberScale(SMALLEST, LARGEST, DEFAULT_FILM.size[0], "px", True, 2.0))
        self.high = NumberBar("Height", NumberScale(SMALLEST, LARGEST, DEFAULT_FILM.size[1], "px", True, 2.0))
        self.view = choice("View", dict(VIEW_TITLES))
        self.framing = choice("Framing", FRAMING)
        self.turns = NumberBar("Turns", NumberScale(-3.0, 3.0, 0.0))
        self.turns.setToolTip("How often the head turns round in the film, as on a turntable")
        self.antialias = choice("Antialiasing", dict(ANTIALIAS), "More samples are smoother and take longer")
        self.backdrop = choice("Backdrop", BACKDROPS)
        self.sound = QCheckBox("With sound")
        self.sound.setChecked(True)
        form = Form()
        form.head("Picture")
        form.row("Size", self.size_choice)
        form.row("", self.wide, self.high)
        form.row("View", self.view, self.framing)
        form.row("Turntable", self.turns)
        form.row("Smoothing", self.antialias)
        form.row("Backdrop", self.backdrop)
        form.row("Sound", self.sound)
        self.setLayout(form)
        self.show_film(DEFAULT_FILM)
        self._connect()

    def _connect(self) -> None:
        self.size_choice.activated.connect(self._take_size)
        for bar in (self.wide, self.high):
            bar.previewed.connect(self._note_own)
        for box in (self.view, self.framing, self.antialias, self.backdrop):
            box.activated.connect(lambda _index: self.changed.emit())
        self.turns.previewed.connect(lambda _value: self.changed.emit())
        self.sound.toggled.connect(lambda _on: self.changed.emit())

    @property
    def film(self) -> Film:
        """What is chosen."""
        return Film(
            size=(round(self.wide.value), round(self.high.value)),
            view=self.view.currentData(),
            close=self.framing.currentData() == "face",
            turns=self.turns.value,
            antialias=self.antialias.currentData(),
            audible=self.sound.isChecked(),
            theme=self.backdrop.currentData(),
        )

    def show_film(self, film: Film) -> None:
        """Show what a film is like."""
        for bar, side in zip((self.wide, self.high), film.size, strict=True):
            bar.set_value(float(side))
        self._note_size()
        choose(self.view, film.view)
        choose(self.framing, "face" if film.close else "head")
        self.turns.set_value(film.turns)
        choose(self.antialias, film.antialias)
        choose(self.backdrop, film.theme)
        self.sound.setChecked(film.audible)

    def offer_sound(self, there: bool, reason: str) -> None:
        """Say whether the clip has a sound that this format takes, and if not why."""
        self.sound.setEnabled(there)
        self.sound.setText("With sound" if there else reason)

    def _take_size(self, _index: int) -> None:
        named = self.size_choice.currentData()
        if named != "own":
            width, _, height = named.partition("x")
            self.show_film(replace(self.film, size=(int(width), int(height))))
        self.changed.emit()

    def _note_own(self, _value: float) -> None:
        self._note_size()
        self.changed.emit()

    def _note_size(self) -> None:
        """Name the size if it has a name."""
        named = f"{self.wide.value:.0f}x{self.high.value:.0f}"
        choose(self.size_choice, named if named in SIZES else "own")

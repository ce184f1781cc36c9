"""Portraits of the named expressions, kept up to date in the moments when nobody is busy with anything else."""

from __future__ import annotations

from collections.abc import Callable, Mapping

from PySide6.QtCore import QEvent, QObject, Qt, QTimer, Signal
from PySide6.QtGui import QGuiApplication, QImage

from app.document import Document
from facemodel.actions import Expression, expand
from facemodel.basis import Basis
from ui.portraits.studio import Studio
from ui.theme.apply import current_theme

NEUTRAL = ""
"""Name of the portrait of the face at rest."""

REST = 700
"""Milliseconds for which nothing must have changed before portraits are taken: what a hand still changes is not worth
a picture."""

BREATH = 15
"""Milliseconds between two portraits, in which the window paints and listens."""

Source = Callable[[], Mapping[str, Expression]]
"""Further expressions by name, as weights of fields."""

Wanted = tuple[tuple[tuple[str, float], ...], Basis, str]
"""All that a portrait shows: the weights, the fields, and the theme of the backdrop."""


class Portraits(QObject):
    """Keeps one picture for every named expression of a document, and one of the face at rest.

    They are taken in the thread of the window, as every system allows, one at a time and each in the time of a frame or
    two; while a button or a weight is held none is taken.

    Signals
    -------
    taken(str) : there is another picture of an expression

    Parameters
    ----------
    document : whose expressions they are
    window : that shows them, and ends with them
    """

    taken = Signal(str)

    def __init__(self, document: Document, window: QObject | None = None) -> None:
        super().__init__(window)
        if window is not None:
            window.installEventFilter(self)
        self._document = document
        self._studio = Studio()
        self._pictures: dict[str, tuple[Wanted, QImage]] = {}
        self._closed = False
        self._sources: list[Source] = []
        self._hindrances: list[Callable[[], bool]] = []
        self._timer = QTimer(self, singleShot=True)
        self._timer.timeout.connect(self._take_one)
        for signal in (
            document.project_changed,
            document.solution_changed,
            document.units_changed,
            document.emotions_changed,
        ):
            signal.connect(self.refresh)

    def picture(self, name: str) -> QImage | None:
        """The last picture of an expression, perhaps of how it was a moment ago; none before the first."""
        kept = self._pictures.get(name)
        return kept[1] if kept is not None else None

    @property
    def complete(self) -> bool:
        """Whether every picture shows what there is now."""
        return not self._missing()

    def follow(self, source: Source, hindrance: Callable[[], bool]) -> None:
        """Take portraits of further expressions too, by names of their own, while nothing hinders it."""
        self._sources.append(source)
        self._hindrances.append(hindrance)

    def refresh(self, *_what: object) -> None:
        """Take anew, soon, what no longer shows what there is."""
        if not self._closed:
            self._timer.start(REST)

    def eventFilter(self, _window: QObject, event: QEvent) -> bool:
        """Another theme has another backdrop."""
        if event.type() == QEvent.Type.PaletteChange:
            self.refresh()
        return False

    def close(self) -> None:
        """Take no more pictures."""
        self._closed = True
        self._timer.stop()
        self._studio.close()

    def _wanted(self) -> dict[str, tuple[Expression, Wanted]]:
        """By name what portraits are to show."""
        project, solution = self._document.project, self._document.solution
        if solution is None:
            return {}
        found: dict[str, tuple[Expression, Wanted]] = {}
        expressions = {NEUTRAL: {}, **{emotion.name: emotion.weights for emotion in project.emotions}}
        fields_of = {name: expand(weights, project.units) for name, weights in expressions.items()}
        for source in self._sources:
            fields_of |= source()
        for name, fields in fields_of.items():
            found[name] = fields, (tuple(sorted(fields.items())), solution.basis, current_theme().name)
        return found

    def _missing(self) -> dict[str, Expression]:
        """What there is no picture of as it is now."""
        wanted = self._wanted()
        kept = {name: each for name, each in self._pictures.items() if name in wanted}
        self._pictures = kept
        return {
            name: expression
            for name, (expression, shown) in wanted.items()
            if name not in kept or not _same(kept[name][0], shown)
        }

    def _take_one(self) -> None:
        """Take one picture, or do one thing that it needs, and come back for the next."""
        missing = self._missing()
        if not missing or self._closed:
            return
        if self._busy:
            self._timer.start(REST)
            return
        solution = self._document.solution
        assert solution is not None
        if not self._studio.built:
            self._studio.build()
        elif not self._studio.seats(solution):
            self._studio.seat(self._document.project, solution)
        else:
            name, expression = next(iter(missing.items()))
            self._pictures[name] = self._wanted()[name][1], self._studio.portrait(expression)
            self.taken.emit(name)
        self._timer.start(BREATH)

    @property
    def _busy(self) -> bool:
        """Whether a hand is at work, or something else that must not wait."""
        pressed = QGuiApplication.mouseButtons() != Qt.MouseButton.NoButton
        return pressed or self._document.held or any(hinders() for hinders in self._hindrances)


def _same(one: Wanted, other: Wanted) -> bool:
    return one[0] == other[0] and one[1] is other[1] and one[2] == other[2]

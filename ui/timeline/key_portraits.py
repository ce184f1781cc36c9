"""Portraits of key expressions, taken by the same studio as those of named ones."""

from __future__ import annotations

from collections.abc import Mapping

from PySide6.QtGui import QImage

from app.timeline.timeline import Timeline
from facemodel.actions import Expression
from facemodel.animation.clip import KeyExpression
from facemodel.animation.editing.expressions import expression_weights
from ui.portraits import Portraits

FINEST = 2
"""Decimals of a weight that can be told apart on a portrait."""


class KeyPortraits:
    """Finds the portrait of a key expression; a moved one keeps its own, since they are named by what they show.

    Parameters
    ----------
    timeline : whose key expressions they are
    portraits : the studio
    """

    def __init__(self, timeline: Timeline, portraits: Portraits) -> None:
        self._timeline, self._portraits = timeline, portraits
        self._last: dict[float, QImage] = {}
        self._names: dict[float, str] = {}
        portraits.follow(self._wanted, lambda: timeline.playhead.playing)
        timeline.document.animation_changed.connect(self._follow)
        timeline.document.project_changed.connect(self._follow)
        self._name()

    def picture(self, time: float) -> QImage | None:
        """The portrait of the key expression at a time, perhaps of how it was a moment ago."""
        found = self._portraits.picture(self._names[time]) if time in self._names else None
        if found is not None:
            self._last[time] = found
        return found or self._last.get(time)

    def _follow(self, *_what: object) -> None:
        before = dict(self._names)
        self._name()
        if before != self._names:
            self._last = {time: each for time, each in self._last.items() if time in self._names}
            self._portraits.refresh()

    def _name(self) -> None:
        self._names = {mark.time: _name_of(self._weights(mark)) for mark in self._timeline.animation.expressions}

    def _wanted(self) -> Mapping[str, Expression]:
        return {_name_of(weights): weights for weights in map(self._weights, self._timeline.animation.expressions)}

    def _weights(self, mark: KeyExpression) -> Expression:
        project = self._timeline.document.project
        found = {**project.expression, **expression_weights(project.animation, mark.time)}
        return {name: round(weight, FINEST) for name, weight in found.items() if round(weight, FINEST)}


def _name_of(weights: Expression) -> str:
    return "key " + " ".join(f"{name}={weight:g}" for name, weight in sorted(weights.items()))

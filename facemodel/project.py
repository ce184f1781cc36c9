"""A project: a face, its muscles, its action units and the expression in hand.  A frozen value."""

from __future__ import annotations

from dataclasses import dataclass, field, replace
from typing import Literal

from facemodel.actions import ActionUnit, Emotion, Expression
from facemodel.animation.clip import STILL, Animation
from facemodel.face import Face
from facemodel.muscles import Muscle
from facemodel.sculpting.correction import Corrections


@dataclass(frozen=True)
class Settings:
    """How the face is solved and sampled.

    Attributes
    ----------
    element : ``hct9`` or ``hct12``
    density : segments into which each element's edge is cut for drawing
    """

    element: Literal["hct9", "hct12"] = "hct12"
    density: int = 3


@dataclass(frozen=True, eq=False)
class Project:
    """Everything a user saves.

    Attributes
    ----------
    face, muscles, units, emotions : what is solved, and its named expressions
    expression : the sliders
    settings : how it is solved and drawn
    corrections : by field name, what a hand has sculpted on top of the solved field
    animation : what happens over time
    """

    face: Face
    muscles: tuple[Muscle, ...]
    units: tuple[ActionUnit, ...]
    emotions: tuple[Emotion, ...]
    expression: Expression = field(default_factory=dict)
    settings: Settings = field(default_factory=Settings)
    corrections: Corrections = field(default_factory=dict)
    animation: Animation = STILL

    def posed(self, expression: Expression) -> Project:
        """The same project with another expression in hand."""
        return replace(self, expression=dict(expression))

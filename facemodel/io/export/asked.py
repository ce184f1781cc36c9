"""What may be asked of an export beside its format."""

from __future__ import annotations

from dataclasses import dataclass
from typing import Literal

from facemodel.animation.take import Take, take
from facemodel.project import Project

Shaping = Literal["units", "clip"]
"""Which shapes an animated model is given: its action units, which other programs can go on with, or shapes made for
this clip alone, which are few."""


@dataclass(frozen=True)
class Asked:
    """How a model is exported.

    Attributes
    ----------
    animated : with the animation of the project, if it has one and the format holds any
    rate : frames per second; the animation's own if not given
    span : from when to when, seconds of the clip, both counted; what is played if not given
    shaping : which shapes an animated model has
    most : how many shapes a clip is given at most; as many as it takes if not given
    """

    animated: bool = True
    rate: float | None = None
    span: tuple[float, float] | None = None
    shaping: Shaping = "units"
    most: int | None = None

    def take(self, project: Project) -> Take | None:
        """The frames of a project; none where a still model is asked for, or nothing moves."""
        if not self.animated or not project.animation.moves:
            return None
        return take(project, self.rate, self.span)


AS_IT_IS = Asked()
"""All that the project has."""

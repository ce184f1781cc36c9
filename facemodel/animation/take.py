"""A take: a clip frame by frame as the face shows it, for films and exports."""

from __future__ import annotations

from dataclasses import dataclass

from facemodel.actions import Expression
from facemodel.animation.clip import FASTEST, SLOWEST
from facemodel.animation.evaluation import Sampled, sampled
from facemodel.errors import ProjectError
from facemodel.kinematics import Rigid
from facemodel.project import Project

MOST_FRAMES = 200_000
"""Almost an hour at 60 frames per second; more are asked for by mistake."""


@dataclass(frozen=True, eq=False)
class Take:
    """What the face of a project does in each frame.

    Attributes
    ----------
    project : whose animation it is; its sliders hold what is not animated
    sampled : the frames
    """

    project: Project
    sampled: Sampled

    def __len__(self) -> int:
        return len(self.sampled.times)

    @property
    def rate(self) -> float:
        """Frames per second."""
        return self.sampled.rate

    @property
    def start(self) -> float:
        """Seconds of the clip at its first frame."""
        return float(self.sampled.times[0])

    @property
    def duration(self) -> float:
        """Seconds for which its frames are seen, the last one as long as the others."""
        return len(self) / self.rate

    def expression(self, frame: int) -> Expression:
        """Weights by field in a frame, as the editor shows them: animated ones over those of the sliders."""
        return {**self.project.expression, **self.sampled.pose(frame).weights}

    def rigid(self, frame: int) -> Rigid:
        """How head and eyes are turned in a frame, beside what the action units do."""
        return self.sampled.pose(frame).rigid


def take(project: Project, rate: float | None = None, span: tuple[float, float] | None = None) -> Take:
    """The clip of a project frame by frame.

    Parameters
    ----------
    project : whose animation it is
    rate : frames per second; the animation's own if not given
    span : from when to when, seconds, both counted; what is played if not given

    Raises
    ------
    ProjectError
        If there is no frame, or there are more than anybody wants.
    """
    own = rate or project.animation.rate
    start, end = span or (project.animation.start, project.animation.end)
    if not SLOWEST <= own <= FASTEST:
        raise ProjectError(f"{own:g} frames per second are not possible; choose {SLOWEST:g} to {FASTEST:g} of them.")
    if not end >= start:
        raise ProjectError(f"There is no frame from {start:g} s to {end:g} s; let the range end after its begin.")
    if (end - start) * own > MOST_FRAMES:
        raise ProjectError(f"There are too many frames from {start:g} s to {end:g} s; choose a shorter range.")
    return Take(project, sampled(project.animation, project.units, own, (start, end)))

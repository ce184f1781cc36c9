"""Recordings of trackers as captures: weights as they are, landmarks as what a face has to do to follow them."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

from facemodel.animation.capture import Capture
from facemodel.animation.landmarks import LandmarkTrack, captured
from facemodel.basis import Basis
from facemodel.cache import solve_cached
from facemodel.io.weights import read_recording
from facemodel.project import Project
from facemodel.sculpting.corrected import Corrector
from facemodel.solution import Progress, silent


def capture_from(
    path: Path,
    project: Project,
    basis: Callable[[], Basis],
    rate: float | None = None,
    neutral: float | None = None,
    progress: Progress = silent,
) -> Capture:
    """A capture from a file of any kind that can be read.

    Parameters
    ----------
    project : whose face is to do what was recorded
    basis : lends its fields; asked for if there are landmarks to follow
    rate : frames per second; noted times are then not looked at
    neutral : when the face was at rest, seconds, where it is landmarks; the calmest moment at the start if not given
    progress : is told how far it is, and may raise `Cancelled`

    Raises
    ------
    ProjectError
        If there is no such file, it is of another kind, or damaged; the place and the remedy are named.
    FaceError
        If there are landmarks, and the face has none to compare them with.
    """
    found = read_recording(path, project.units, rate)
    if isinstance(found, LandmarkTrack):
        return captured(found, project.face, basis(), project.units, neutral, progress)
    return found


def solved_basis(project: Project, progress: Progress = silent) -> Basis:
    """The fields of a project, from the cache if they were solved before, with what is sculpted on them."""
    return Corrector()(solve_cached(project, progress), project).basis

"""Errors that reach a user: one sentence that says what is wrong, where, and what to do."""

from __future__ import annotations


class RisoriusError(Exception):
    """Base of all errors whose message is meant for the person at the screen."""


class ProjectError(RisoriusError):
    """A project or exchange file cannot be read or written."""


class UnknownNameError(RisoriusError):
    """An action unit, emotion, muscle, face or view that does not exist was named."""


class FaceError(RisoriusError):
    """A face is not fit for solving: not manifold, no chart, or left loose by its supports."""


class MuscleError(RisoriusError):
    """A muscle cannot be laid as it was asked for; the face and its other muscles stay as they were."""


class PaintError(RisoriusError):
    """A layer cannot be painted, filled or read from a file as it was asked for; the layers stay as they were."""


class SkullError(RisoriusError):
    """Bone or jaw cannot be placed or chosen as it was asked for; the skull stays as it was."""


class AnimationError(RisoriusError):
    """What happens over time cannot be changed as it was asked for; it stays as it was."""

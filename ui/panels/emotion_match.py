"""Which emotion a face shows, and how strongly."""

from __future__ import annotations

import math

from app.weights import emotion_weights
from facemodel.actions import Emotion, Expression
from facemodel.project import Project

SAME_WEIGHT = 1e-6
"""Weights nearer than this are the same: sliders step by 0.001, rounding errs by 1e-16."""


def shown_strength(expression: Expression, emotion: Emotion, project: Project) -> float:
    """How strongly an expression is this emotion and nothing else; 0 where it is something else."""
    full = emotion_weights(emotion.name, 1.0, project)
    strongest = max(full, key=lambda name: full[name])
    if full[strongest] == 0:
        return 0.0
    strength = expression.get(strongest, 0.0) / full[strongest]
    names = set(full) | set(expression)
    same = all(
        math.isclose(expression.get(name, 0.0), strength * full.get(name, 0.0), abs_tol=SAME_WEIGHT) for name in names
    )
    return strength if same else 0.0

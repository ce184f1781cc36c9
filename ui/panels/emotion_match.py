"""Which emotion a face shows, and how strongly."""

from __future__ import annotations

import math

from facemodel.actions import Expression

SAME_WEIGHT = 1e-6
"""Weights nearer than this are the same: sliders step by 0.001, rounding errs by 1e-16."""


def shown_strength(expression: Expression, full: Expression) -> float:
    """How strongly an expression is an emotion and nothing else; 0 where it is something else.

    Parameters
    ----------
    expression : what is shown
    full : the weights of the emotion at strength 1, by field
    """
    strongest = max(full, key=lambda name: full[name], default="")
    strength = expression.get(strongest, 0.0) / full[strongest] if full.get(strongest) else 0.0
    same = strength > 0 and all(
        math.isclose(expression.get(name, 0.0), strength * full.get(name, 0.0), abs_tol=SAME_WEIGHT)
        for name in set(full) | set(expression)
    )
    return strength if same else 0.0

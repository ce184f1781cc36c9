"""When two projects are the same, and for what.

Faces and muscles are frozen and shared between projects, so they are the same when they are the same objects.
"""

from __future__ import annotations

from facemodel.project import Project


def same_solution(one: Project, other: Project) -> bool:
    """Whether both have the same displacement fields: everything that is solved is the same."""
    return (
        one.face is other.face
        and one.muscles == other.muscles
        and one.units == other.units
        and one.settings == other.settings
    )


def same_but_expression(one: Project, other: Project) -> bool:
    """Whether at most the expression differs."""
    return same_solution(one, other) and one.emotions == other.emotions


def same_content(one: Project, other: Project) -> bool:
    """Whether both would be saved alike."""
    return same_but_expression(one, other) and one.expression == other.expression

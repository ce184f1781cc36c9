"""Solving the face, its figures, and which face it is."""

from __future__ import annotations

from app.actions.action import Action
from facemodel.faces import face_keys

SOLVING_ACTIONS = (
    Action(
        "solve.now",
        "Solve now",
        lambda context: context.solving.solve(),
        menu=("Solve",),
        shortcut="F5",
        hint="Solve all action units of this face with finite elements",
        enabled=lambda context: context.solving.wanted,
    ),
    Action(
        "solve.cancel",
        "Cancel solving",
        lambda context: context.solving.cancel(),
        menu=("Solve",),
        shortcut="Ctrl+.",
        hint="Stop solving; the last good face stays",
        enabled=lambda context: context.solving.job.running,
    ),
    Action(
        "face.information",
        "Face information",
        lambda context: context.host.show_face_information(),
        menu=("Face",),
        shortcut="Ctrl+I",
        hint="Show the size, the chart and the solution of this face in figures",
    ),
)


def face_actions() -> tuple[Action, ...]:
    """One action for each face that the expression can go to."""
    return tuple(
        Action(
            f"face.switch.{key}",
            key.capitalize(),
            lambda context, key=key: context.document.switch_face(key),  # type: ignore[misc]
            menu=("Face", "Change face"),
            hint=f"Show this expression on the face {key.capitalize()}",
            kind="choice",
            enabled=lambda context, key=key: context.document.project.face.key != key,  # type: ignore[misc]
            checked=lambda context, key=key: context.document.project.face.key == key,  # type: ignore[misc]
        )
        for key in face_keys()
    )

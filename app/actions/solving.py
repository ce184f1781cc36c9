"""Solving the face, its figures, and which face it is."""

from __future__ import annotations

from app.actions.action import Action
from app.actions.context import Context
from app.authoring.fitted_muscles import carried_to
from facemodel.faces import face_keys
from facemodel.projects import new_project

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


def _switch(context: Context, key: str) -> None:
    """Go to another individual; with the muscles in hand, if they are to go along."""
    document = context.document
    if not context.view.state.carry:
        document.switch_face(key)
        return
    other = new_project(key)
    fitted = carried_to(document.project, other)
    document.edit(fitted.project, f"{other.face.title}, muscles along")
    context.host.show_message(" ".join(fitted.fit.sentences))


CARRY = Action(
    "face.carry",
    "Muscles and units go along",
    lambda context: context.view.toggle("carry"),
    menu=("Face", "Change face"),
    group=1,
    hint="Fit the muscles in hand to the other head by landmarks, in place of its own",
    kind="toggle",
    checked=lambda context: context.view.state.carry,
)


def face_actions() -> tuple[Action, ...]:
    """One action for each face that the expression can go to, and whether muscles go along."""
    return (*(_face(key) for key in face_keys()), CARRY)


def _face(key: str) -> Action:
    return Action(
        f"face.switch.{key}",
        key.capitalize(),
        lambda context: _switch(context, key),
        menu=("Face", "Change face"),
        hint=f"Show this expression on the face {key.capitalize()}",
        kind="choice",
        enabled=lambda context: context.document.project.face.key != key,
        checked=lambda context: context.document.project.face.key == key,
    )

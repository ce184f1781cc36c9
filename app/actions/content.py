"""Actions that come from the project: its emotions, action units and muscles."""

from __future__ import annotations

from app.actions.action import Action
from app.actions.context import Context
from app.weights import emotion_weights
from facemodel.actions import ActionUnit, Emotion
from facemodel.muscles import Muscle
from facemodel.project import Project

SIDES = {"L": " (left)", "R": " (right)", "M": ""}


def content_actions(project: Project) -> tuple[Action, ...]:
    """One action for each emotion, action unit and muscle of a project."""
    return (
        *(_emotion(emotion, place) for place, emotion in enumerate(project.emotions, start=1)),
        *(_unit(unit) for unit in project.units),
        *(_muscle(muscle) for muscle in project.muscles),
    )


def _emotion(emotion: Emotion, place: int) -> Action:
    recipe = " + ".join(emotion.weights)

    def shown(context: Context) -> bool:
        if emotion not in context.document.project.emotions:
            return False
        weights = emotion_weights(emotion.name, 1.0, context.document.project)
        return {name for name in weights.items() if name[1]} == set(context.document.shown.items())

    return Action(
        f"emotion.{emotion.name}",
        emotion.title,
        lambda context: context.document.apply_emotion(emotion.name),
        menu=("Face", "Emotion"),
        shortcut=f"Alt+{place}" if place <= 9 else "",
        hint=f"Show {emotion.name}: {recipe}",
        kind="choice",
        checked=shown,
    )


def _unit(unit: ActionUnit) -> Action:
    return Action(
        f"unit.{unit.number}",
        f"AU {unit.number} {unit.name}",
        lambda context: context.host.focus_unit(unit.number),
        hint=unit.note or f"Go to the slider of action unit {unit.number}, {unit.name}",
    )


def _muscle(muscle: Muscle) -> Action:
    return Action(
        f"muscle.{muscle.key}",
        f"{muscle.title}{SIDES[muscle.side]}",
        lambda context: context.view.change(muscle=muscle.key, muscles=True),
        hint=f"Select the muscle {muscle.title}{SIDES[muscle.side]} and draw the muscles",
        kind="choice",
        checked=lambda context: context.view.state.muscle == muscle.key,
    )

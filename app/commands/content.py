"""Steps that edit what a project consists of: muscles, action units, emotions, and the weights that hang on them."""

from __future__ import annotations

from dataclasses import dataclass, field, replace

from app.commands.command import ITEM_BYTES, Command, array_bytes
from app.commands.keyed import KeyedDelta, keyed_delta
from app.commands.weights import Delta, reweighted
from facemodel.actions import ActionUnit, Emotion
from facemodel.muscles import Muscle
from facemodel.project import Project


@dataclass(frozen=True, eq=False)
class EditContent:
    """Change, add, remove or reorder muscles, action units and emotions.

    One step holds all that one intent changes: a muscle that is renamed takes the action units along that
    contract it, a unit that is deleted leaves the emotions and the expression.

    Attributes
    ----------
    label : what a person calls it
    muscles, units, emotions : what is different, by key, number and name
    before, after : the changed weights of the expression alone
    gesture : steps with the same gesture in a row are one step; empty for a step of its own
    """

    label: str
    muscles: KeyedDelta[Muscle] = field(default_factory=KeyedDelta)
    units: KeyedDelta[ActionUnit] = field(default_factory=KeyedDelta)
    emotions: KeyedDelta[Emotion] = field(default_factory=KeyedDelta)
    before: Delta = field(default_factory=dict)
    after: Delta = field(default_factory=dict)
    gesture: str = ""

    @property
    def cost(self) -> int:
        """Bytes that only this command keeps alive."""
        deltas = (self.muscles, self.units, self.emotions)
        items = sum(len(delta.before) + len(delta.after) + sum(map(len, delta.orders or ())) for delta in deltas)
        return ITEM_BYTES * (items + len(self.after)) + array_bytes((self.muscles.before, self.muscles.after))

    @property
    def changes(self) -> bool:
        """Whether it does anything."""
        return any(d.changes for d in (self.muscles, self.units, self.emotions)) or self.before != self.after

    def do(self, project: Project) -> Project:
        """The project with the new values."""
        return replace(
            project,
            muscles=self.muscles.do(project.muscles, muscle_name),
            units=self.units.do(project.units, unit_name),
            emotions=self.emotions.do(project.emotions, emotion_name),
            expression=reweighted(project.expression, self.after),
        )

    def undo(self, project: Project) -> Project:
        """The project with the old values."""
        return replace(
            project,
            muscles=self.muscles.undo(project.muscles, muscle_name),
            units=self.units.undo(project.units, unit_name),
            emotions=self.emotions.undo(project.emotions, emotion_name),
            expression=reweighted(project.expression, self.before),
        )

    def joined(self, later: Command) -> Command | None:
        """Both as one step if they belong to one gesture."""
        if not isinstance(later, EditContent) or not self.gesture or later.gesture != self.gesture:
            return None
        before, after = {**later.before, **self.before}, {**self.after, **later.after}
        moved = [name for name in after if before[name] != after[name]]
        return EditContent(
            later.label,
            self.muscles.then(later.muscles),
            self.units.then(later.units),
            self.emotions.then(later.emotions),
            {name: before[name] for name in moved},
            {name: after[name] for name in moved},
            self.gesture,
        )


def edit_content(before: Project, after: Project, label: str, gesture: str = "") -> EditContent:
    """The step from one project to another that differs in content and expression alone."""
    old, new = before.expression, after.expression
    moved = [name for name in {**old, **new} if old.get(name) != new.get(name)]
    return EditContent(
        label,
        keyed_delta(before.muscles, after.muscles, muscle_name),
        keyed_delta(before.units, after.units, unit_name),
        keyed_delta(before.emotions, after.emotions, emotion_name),
        {name: old.get(name) for name in moved},
        {name: new.get(name) for name in moved},
        gesture,
    )


def muscle_name(muscle: Muscle) -> str:
    """What a muscle is told apart by."""
    return muscle.key


def unit_name(unit: ActionUnit) -> str:
    """What an action unit is told apart by."""
    return str(unit.number)


def emotion_name(emotion: Emotion) -> str:
    """What an emotion is told apart by."""
    return emotion.name

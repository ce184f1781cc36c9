"""Steps that put another project in the place of the one there is, and several steps as one."""

from __future__ import annotations

from dataclasses import dataclass

from app.commands.command import Command, array_bytes
from facemodel.project import Project


@dataclass(frozen=True, eq=False)
class ReplaceProject:
    """Put another project in the place of this one: another face, atlas or basis settings."""

    label: str
    before: Project
    after: Project
    gesture: str = ""

    @property
    def cost(self) -> int:
        """Bytes of the arrays of the face that would be freed without this command."""
        return 0 if self.before.face is self.after.face else array_bytes(self.before.face)

    @property
    def changes(self) -> bool:
        """Whether it does anything."""
        return self.before is not self.after

    def do(self, project: Project) -> Project:
        """The new project."""
        return self.after

    def undo(self, project: Project) -> Project:
        """The old project."""
        return self.before

    def joined(self, later: Command) -> Command | None:
        """Never one step with another."""
        return None


@dataclass(frozen=True, eq=False)
class Several:
    """Several steps done one after the other, as one.

    Attributes
    ----------
    label : what a person calls them together
    steps : in the order in which they are done
    gesture : steps with the same gesture in a row are one step; empty for a step of its own
    """

    label: str
    steps: tuple[Command, ...]
    gesture: str = ""

    @property
    def cost(self) -> int:
        """Bytes that only these steps keep alive."""
        return sum(step.cost for step in self.steps)

    @property
    def changes(self) -> bool:
        """Whether any of them does anything."""
        return any(step.changes for step in self.steps)

    def do(self, project: Project) -> Project:
        """The project with all of them done."""
        for step in self.steps:
            project = step.do(project)
        return project

    def undo(self, project: Project) -> Project:
        """The project with all of them undone, the last one first."""
        for step in reversed(self.steps):
            project = step.undo(project)
        return project

    def joined(self, later: Command) -> Command | None:
        """Both as one step if they belong to one gesture, each kind of step with its own."""
        if not self.gesture or later.gesture != self.gesture:
            return None
        kept: list[Command] = list(self.steps)
        for step in later.steps if isinstance(later, Several) else (later,):
            both = ((place, one.joined(step)) for place, one in enumerate(kept))
            place, one = next(((place, one) for place, one in both if one is not None), (len(kept), step))
            kept[place : place + 1] = [one]
        return Several(later.label, tuple(step for step in kept if step.changes), self.gesture)

"""What a hand in the panel does to the selected muscles: seen while it moves, one step when it lets go."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial

from app.actions.context import Context
from app.tools.locks import locked_among, refuse_locked
from facemodel.laying.collection import muscle_of, with_muscle
from facemodel.laying.sides import partner
from facemodel.muscles import Muscle
from facemodel.project import Project
from facemodel.sameness import same
from ui.panels.live_edit import LiveEdit
from ui.panels.muscles.selection import chosen, in_step, titles
from ui.panels.telling import told

Change = Callable[[Muscle], Muscle]


class MuscleEdit:
    """Changes every selected muscle alike, or the one that was selected last alone.

    Parameters
    ----------
    context : document, view and window
    refused : called when something cannot be done, which the status line then says; what is shown is to be put right
    """

    def __init__(self, context: Context, refused: Callable[[], None]) -> None:
        self.context = context
        self._live = LiveEdit(context.document, context.solving)
        self._refused = refused

    @property
    def muscles(self) -> tuple[Muscle, ...]:
        """The selected muscles, the one selected last first."""
        return chosen(self.context.document.project, self.context.view.state)

    @property
    def locked(self) -> tuple[Muscle, ...]:
        """Those that are locked, and the locked partners that would change with the selected ones."""
        return locked_among(self.context.document.project, self.context.view.state, self.muscles)

    def propose(self, change: Change, what: str, *, alone: bool = False) -> None:
        """Change the muscles as the hand means it now.

        Parameters
        ----------
        change : what becomes of each of them
        what : what the step will call it, as in “Width of …”
        alone : only the muscle selected last is meant, for a place is on one side only
        """
        muscles = self.muscles[:1] if alone else self.muscles
        keys = [muscle.key for muscle in muscles]

        def act() -> None:
            self.refuse_locked(muscles)
            self._live.propose(partial(_changed, keys=keys, change=change), f"{what} {titles(muscles)}")

        self.told(act)

    def keep(self) -> None:
        """The hand let go: what it asked for last is one step."""
        self._live.keep()

    def cancel(self) -> None:
        """All is as it was before the hand took hold."""
        self._live.cancel()

    def now(self, change: Change, what: str, *, alone: bool = False) -> None:
        """Change the muscles at once, in one step; the parameters are those of `propose`."""
        muscles = self.muscles[:1] if alone else self.muscles

        def act() -> None:
            self.refuse_locked(muscles)
            project = _changed(self.context.document.project, [muscle.key for muscle in muscles], change)
            self.context.document.edit(project, f"{what} {titles(muscles)}")

        self.told(act)

    def refuse_locked(self, muscles: tuple[Muscle, ...]) -> None:
        """Nothing, unless one of some muscles is locked; then `MuscleError`."""
        refuse_locked(self.context.document.project, self.context.view.state, muscles)

    def told(self, act: Callable[[], None]) -> None:
        """Do something; what is wrong with it is told, and what is shown is what stands."""
        if not told(self.context, act):
            self._refused()


def _changed(project: Project, keys: list[str], change: Change) -> Project:
    """A project with some muscles changed; of two in step the first one is, and the other follows."""
    done: set[str] = set()
    for key in keys:
        muscle = muscle_of(project, key)
        other = partner(project.muscles, muscle)
        if other is not None and other.key in done and in_step(project, muscle):
            continue
        done.add(key)
        made = change(muscle)
        if not same(made, muscle):
            project = with_muscle(project, made)
    return project

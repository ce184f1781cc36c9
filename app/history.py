"""What was done, in order: undo, redo, and where the saved state lies."""

from __future__ import annotations

from app.commands import Command

MOST_STEPS = 1000
"""More than a day's work; labels of so many steps are still listed at once."""

MOST_BYTES = 256 * 2**20
"""What steps may keep alive: a dozen replaced faces, or any number of moved sliders."""


class History:
    """Commands done and undone.  It only remembers; whoever owns the project does and undoes.

    Parameters
    ----------
    most_steps, most_bytes : the oldest steps are forgotten beyond these; the newest is always kept
    saved : whether what it begins with is saved
    """

    def __init__(self, most_steps: int = MOST_STEPS, most_bytes: int = MOST_BYTES, saved: bool = True) -> None:
        self._most_steps = most_steps
        self._most_bytes = most_bytes
        self._done: list[Command] = []
        self._undone: list[Command] = []
        self._saved: int | None = 0 if saved else None
        self._undone_before: list[Command] = []

    @property
    def to_undo(self) -> Command | None:
        """The step that undo takes back."""
        return self._done[-1] if self._done else None

    @property
    def to_redo(self) -> Command | None:
        """The step that redo does again."""
        return self._undone[-1] if self._undone else None

    @property
    def done(self) -> tuple[str, ...]:
        """Labels of the steps that can be undone, oldest first."""
        return tuple(step.label for step in self._done)

    @property
    def at_saved(self) -> bool:
        """Whether what stands is what was saved."""
        return self._saved == len(self._done)

    @property
    def cost(self) -> int:
        """Bytes kept alive by all steps."""
        return sum(step.cost for step in (*self._done, *self._undone))

    def push(self, command: Command) -> None:
        """Remember a step that was done; what was undone before is forgotten.

        A step that belongs to the gesture of the last one becomes one with it, and vanishes if both together
        do nothing.  The saved state is never joined away.
        """
        if self._saved is not None and self._saved > len(self._done):
            self._saved = None
        joined = self._done[-1].joined(command) if self._done and not self._undone and not self.at_saved else None
        if joined is None:
            self._undone_before = self._undone
        self._undone = []
        if joined is not None:
            self._done.pop()
        if joined is None or joined.changes:
            self._done.append(joined or command)
        self._forget()

    def step_back(self) -> None:
        """Note that the last step was undone."""
        self._undone_before = []
        self._undone.append(self._done.pop())

    def step_forth(self) -> None:
        """Note that the next step was done again."""
        self._done.append(self._undone.pop())

    def drop_last(self) -> None:
        """Note that the last step never was; what could be done again before it can be again."""
        self._done.pop()
        self._undone, self._undone_before = self._undone_before, []

    def mark_saved(self) -> None:
        """Note that what stands is saved."""
        self._saved = len(self._done)

    def _forget(self) -> None:
        while len(self._done) > 1 and (len(self._done) > self._most_steps or self.cost > self._most_bytes):
            del self._done[0]
            self._saved = None if not self._saved else self._saved - 1

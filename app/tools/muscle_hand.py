"""What tools for laying muscles share: handles are dragged, what is in the hand is shown, letting go is one step."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from typing import ClassVar

from app.tools.grips import dragged_to, handle_distance
from app.tools.laying import ghost, put_in, with_image
from app.tools.locks import refuse_locked
from app.tools.pointer import Pointer
from app.tools.select import fibre_distance
from app.tools.sight import Ghost, Grip
from app.tools.tool import Bench, Tool
from app.view_state import Workspace
from facemodel.errors import MuscleError
from facemodel.laying.collection import muscle_of
from facemodel.laying.handles import Part, dragged, handles
from facemodel.laying.places import Snap
from facemodel.muscles import Muscle
from facemodel.project import Project

FINGER = 1.5
"""A handle is taken from so many times the reach of the pointer: it is small, and meant when the hand is near."""

NOUNS: Mapping[Part, str] = {
    "origin": "Move origin of",
    "attachment": "Move attachment of",
    "via": "Bend",
    "radius": "Widen",
    "reach": "Widen",
    "share": "Change share of",
    "factor": "Change K of",
    "box": "Change box of",
    "force": "Strengthen",
    "centre": "Move",
    "long": "Stretch",
    "short": "Stretch",
}


@dataclass(frozen=True, eq=False)
class Drag:
    """A gesture under way.

    Attributes
    ----------
    label : what the step will be called
    made : the muscle that the hand means with the pointer where it is; none where it means nothing
    """

    label: str
    made: Callable[[Pointer], Muscle | None]


class MuscleHand(Tool):
    """Press on a handle of a selected muscle drags it; what else a press begins is up to each tool.

    Attributes
    ----------
    bone_snap, skin_snap : where origins and attachments come to lie that are dragged
    """

    workspaces: ClassVar[frozenset[Workspace]] = frozenset(("muscles",))
    asks_skull: ClassVar[bool] = True

    def __init__(self, bench: Bench) -> None:
        super().__init__(bench)
        self.bone_snap: Snap = "surface"
        self.skin_snap: Snap = "vertex"
        self._drag: Drag | None = None
        self._muscle: Muscle | None = None
        self._wrong: MuscleError | None = None

    def begun(self, pointer: Pointer) -> Drag | None:
        """What a press begins where no handle is; nothing by default."""
        return None

    def press(self, pointer: Pointer) -> None:
        """Take hold of a handle, or begin what the tool is for."""
        refuse_locked(self._project, self.bench.view.state, self._meant(pointer)[:1])
        self._drag = self._held(pointer) or self.begun(pointer)
        self._muscle, self._wrong = None, None
        self.busy = self._drag is not None

    def move(self, pointer: Pointer) -> None:
        """Show the muscle as it would be, with what it acts on, or why it cannot be so."""
        assert self._drag is not None
        try:
            muscle = self._drag.made(pointer)
        except MuscleError as error:
            self._wrong = error
            self.bench.sight.ghost_changed.emit(Ghost((), complaint=str(error)))
            return
        if muscle is not None:
            self._muscle, self._wrong = muscle, None
            shown = with_image(self._project, muscle, self.bench.view.state.linked)
            self.bench.sight.ghost_changed.emit(ghost(shown, self._project.face))

    def release(self, pointer: Pointer) -> None:
        """Lay the muscle as it was shown last, as one step, and select it.

        Raises
        ------
        MuscleError
            If it cannot be laid there; all is then as it was.
        """
        drag, muscle, wrong = self._drag, self._muscle, self._wrong
        self.cancel()
        if wrong is not None:
            raise wrong
        if drag is None or muscle is None:
            return
        project = put_in(self._project, muscle, self.bench.view.state.linked)
        self.bench.document.edit(project, f"{drag.label} {muscle.title}")
        if muscle.key not in self.bench.view.state.selected:
            self.bench.view.change(muscle=muscle.key)

    def hover(self, pointer: Pointer) -> None:
        """Show which handle would be taken."""
        self.bench.sight.grip_changed.emit(self._grip(pointer))

    def leave(self) -> None:
        """Nothing would be taken."""
        self.bench.sight.grip_changed.emit(None)

    def cancel(self) -> None:
        """Let go; the muscle is where it was."""
        self.busy, self._drag, self._muscle, self._wrong = False, None, None, None
        self.bench.sight.ghost_changed.emit(None)

    @property
    def _project(self) -> Project:
        return self.bench.document.project

    def _seen(self) -> list[Muscle]:
        """Selected muscles that are drawn, the one selected last first."""
        state = self.bench.view.state
        keys = sorted(state.selected - state.hidden, key=lambda key: key != state.muscle)
        there = {muscle.key for muscle in self._project.muscles}
        return [muscle_of(self._project, key) for key in keys if key in there]

    def _own(self) -> list[Muscle]:
        """Those of them that may be changed."""
        return [muscle for muscle in self._seen() if muscle.key not in self.bench.view.state.locked]

    def _meant(self, pointer: Pointer) -> list[Muscle]:
        """The muscles, locked or not, that a press there would change."""
        grip = self._grip(pointer) or self._grip(pointer, self._seen())
        return [grip.muscle] if grip else []

    def _near(self, pointer: Pointer) -> list[Muscle]:
        """Selected muscles on whose fibres the pointer is."""
        if pointer.ray is None:
            return []
        reach = FINGER * pointer.reach
        return [muscle for muscle in self._seen() if fibre_distance(muscle, pointer.ray) <= reach]

    def _grip(self, pointer: Pointer, muscles: list[Muscle] | None = None) -> Grip | None:
        """The nearest handle within reach; of those that may be changed unless others are asked for."""
        reach, best = FINGER * pointer.reach, None
        for muscle in self._own() if muscles is None else muscles:
            for handle in handles(muscle, self._project.face):
                away = handle_distance(pointer, handle)
                if away < reach:
                    reach, best = away, Grip(muscle, handle)
        return best

    def _held(self, pointer: Pointer) -> Drag | None:
        grip = None if "control" in pointer.modifiers else self._grip(pointer)
        return None if grip is None else self._moving(grip)

    def _moving(self, grip: Grip) -> Drag:
        def made(pointer: Pointer) -> Muscle | None:
            snap = {"origin": self.bone_snap, "attachment": self.skin_snap}.get(grip.handle.part, "surface")
            to = dragged_to(grip.handle, pointer, free=snap == "free")
            if to is None:
                return None
            face = self._project.face
            return dragged(grip.muscle, grip.handle, to, face, bone=self.bone_snap, skin=self.skin_snap)

        return Drag(NOUNS[grip.handle.part], made)

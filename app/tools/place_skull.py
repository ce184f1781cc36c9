"""Move, turn and scale the skull by handles; the bone follows the hand, and what it let go of is one step."""

from __future__ import annotations

from typing import ClassVar

from app.authoring.skull import with_pose
from app.tools.gizmo import Gizmo, Mode, Part, Pull, gizmo_of
from app.tools.pointer import Pointer
from app.tools.tool import Bench, Tool
from app.view_state import Workspace
from facemodel.face import Pose
from facemodel.skull.placement import checked

FINGER = 1.4
"""A handle is taken from so many times the reach of the pointer."""

LABELS: dict[Mode, str] = {"move": "Move skull", "turn": "Turn skull", "scale": "Scale skull"}

HANDS = "Shift is finer, Ctrl goes in steps, Esc puts it back"


class PlaceTool(Tool):
    """What the three tools have in common; each shows handles of its own."""

    mode: ClassVar[Mode]
    workspaces: ClassVar[frozenset[Workspace]] = frozenset(("skull",))
    asks_skin: ClassVar[bool] = False

    def __init__(self, bench: Bench) -> None:
        super().__init__(bench)
        self._pull: Pull | None = None
        self._pose: Pose | None = None

    @property
    def usable(self) -> bool:
        """Not while another skull is fitted, in whose place the own one is not seen."""
        return not self.bench.fitting.on

    def press(self, pointer: Pointer) -> None:
        """Take hold of a handle."""
        found = self._under(pointer)
        if found is None or pointer.ray is None:
            return
        gizmo, part = found
        self._pull = Pull(gizmo, part, self.bench.document.project.face.skull.placement.pose, pointer.ray)
        self._pose = None
        self.busy = True
        self.bench.sight.part_changed.emit(part)

    def move(self, pointer: Pointer) -> None:
        """The bone follows."""
        if self._pull is None or pointer.ray is None:
            return
        held = pointer.modifiers
        self._pose = checked(self._pull.pose(pointer.ray, steps="control" in held, fine="shift" in held))
        self.bench.sight.pose_changed.emit(self._pose)

    def release(self, pointer: Pointer) -> None:
        """Leave the skull where it was shown last, as one step."""
        pose = self._pose
        self.busy, self._pull, self._pose = False, None, None
        if pose is not None:
            document = self.bench.document
            after = with_pose(document.project, pose, self.bench.view.state.origins_follow)
            document.edit(after, LABELS[self.mode])
        self.bench.sight.pose_changed.emit(None)
        self.hover(pointer)

    def hover(self, pointer: Pointer) -> None:
        """Show which handle would be taken."""
        found = self._under(pointer)
        self.bench.sight.part_changed.emit(None if found is None else found[1])

    def leave(self) -> None:
        """Nothing would be taken."""
        self.bench.sight.part_changed.emit(None)

    def cancel(self) -> None:
        """Let go; the skull is where it was."""
        self.busy, self._pull, self._pose = False, None, None
        self.bench.sight.pose_changed.emit(None)
        self.bench.sight.part_changed.emit(None)

    def _under(self, pointer: Pointer) -> tuple[Gizmo, Part] | None:
        """The handles, and the one under the pointer."""
        projector = self.bench.projector
        if pointer.ray is None or projector is None:
            return None
        gizmo = gizmo_of(self.bench.document.project.face.skull, self.mode, projector.millimetres)
        part = gizmo.part_under(pointer.ray, FINGER * pointer.reach)
        return None if part is None else (gizmo, part)


class MoveSkull(PlaceTool):
    """Arrows along the axes of the head, and a middle that goes anywhere."""

    id: ClassVar[str] = "move-skull"
    title: ClassVar[str] = "Move skull"
    shortcut: ClassVar[str] = "Shift+G"
    hint: ClassVar[str] = f"Drag an arrow to move the skull along it, the middle to move it freely · {HANDS}"
    mode: ClassVar[Mode] = "move"


class TurnSkull(PlaceTool):
    """Rings about the axes of the head."""

    id: ClassVar[str] = "turn-skull"
    title: ClassVar[str] = "Turn skull"
    shortcut: ClassVar[str] = "R"
    hint: ClassVar[str] = f"Drag a ring to turn the skull about its own middle · {HANDS}"
    mode: ClassVar[Mode] = "turn"


class ScaleSkull(PlaceTool):
    """Boxes along the skull's own axes, and a middle that scales all alike."""

    id: ClassVar[str] = "scale-skull"
    title: ClassVar[str] = "Scale skull"
    shortcut: ClassVar[str] = "Shift+S"
    hint: ClassVar[str] = f"Drag a box to scale the skull along it, the middle to scale it as a whole · {HANDS}"
    mode: ClassVar[Mode] = "scale"

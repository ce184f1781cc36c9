"""What a tool is: press, moves, release; one gesture is one step to undo, and Esc leaves no trace of it."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import ClassVar

from app.bone_watch import BoneWatch
from app.document import Document
from app.jobs import Deliver
from app.muscle_pulls import MusclePulls
from app.skull_fitting import SkullFitting
from app.skull_import import SkullImport
from app.skull_snap import SkullSnap
from app.tools.bones import Bones
from app.tools.brush_state import HandBrush
from app.tools.ground import Ground
from app.tools.pointer import Pointer, Projector
from app.tools.region import Regions
from app.tools.sculpt_state import HandSculpt
from app.tools.sight import Sight
from app.view import View
from app.view_state import Workspace

EVERYWHERE: frozenset[Workspace] = frozenset(("expression", "actions", "muscles", "skull", "tissue"))


@dataclass(eq=False)
class Bench:
    """What lies before a tool.

    Attributes
    ----------
    document : what is worked on
    view : what is selected and shown
    brush : how it is painted
    sculpt : how it is sculpted
    regions : selected and locked parts of the skin
    bones : selected bone
    fitting : the skull from elsewhere that is being fitted
    watch : what is found out about the skull of the document
    importing : brings skulls from files to be fitted
    snapping : lays the skull where the tissue is as deep as tables say
    sight : what is drawn while working
    pulls : where muscles pull
    ground : the skin to paint on
    projector : how the viewport sees the skin; none without one
    deliver : brings a call to the thread of the window; none without one, and nothing is then done in the background
    """

    document: Document
    view: View
    brush: HandBrush = field(default_factory=HandBrush)
    sculpt: HandSculpt = field(default_factory=HandSculpt)
    regions: Regions = field(default_factory=Regions)
    bones: Bones = field(default_factory=Bones)
    fitting: SkullFitting = field(default_factory=SkullFitting)
    sight: Sight = field(default_factory=Sight)
    pulls: MusclePulls = field(default_factory=MusclePulls)
    ground: Ground = field(default_factory=Ground)
    projector: Projector | None = None
    deliver: Deliver | None = None
    watch: BoneWatch = field(init=False)
    importing: SkullImport = field(init=False)
    snapping: SkullSnap = field(init=False)

    def __post_init__(self) -> None:
        self.watch = BoneWatch(self.document)
        self.importing = SkullImport(self.document, self.fitting)
        self.snapping = SkullSnap(self.document)

    def clear(self) -> None:
        """Stop whatever is done in the background; nobody will hear of it any more."""
        self.importing.stop()
        self.snapping.stop()
        self.watch.leave()


class Tool:
    """A tool in the hand; what it is not for it leaves alone.

    Attributes
    ----------
    id, title : unique name, and the one for people
    shortcut : key in Qt's portable spelling
    hint : one line for the status bar while it is in hand
    workspaces : where it is offered
    asks_skin, asks_skull : whether the pointer is to tell the place on the skin, and that on the skull
    busy : whether a gesture is under way

    Parameters
    ----------
    bench : what it works on
    """

    id: ClassVar[str]
    title: ClassVar[str]
    shortcut: ClassVar[str] = ""
    hint: ClassVar[str] = ""
    workspaces: ClassVar[frozenset[Workspace]] = EVERYWHERE
    asks_skin: ClassVar[bool] = True
    asks_skull: ClassVar[bool] = False

    def __init__(self, bench: Bench) -> None:
        self.bench = bench
        self.busy = False

    @property
    def brush(self) -> HandBrush | HandSculpt:
        """The brush whose size, strength and mirror are changed while the tool is in hand."""
        return self.bench.brush

    @property
    def advice(self) -> str:
        """One line for the status bar as things are now."""
        return self.hint

    @property
    def usable(self) -> bool:
        """Whether there is anything to use it on; else it is not offered."""
        return True

    def press(self, pointer: Pointer) -> None:
        """The left button goes down: a gesture may begin, which makes the tool busy."""

    def move(self, pointer: Pointer) -> None:
        """The pointer moves while a gesture is under way."""

    def release(self, pointer: Pointer) -> None:
        """The button goes up: what was done becomes one step."""

    def hover(self, pointer: Pointer) -> None:
        """The pointer moves and no button is down."""

    def leave(self) -> None:
        """The pointer leaves the viewport."""

    def cancel(self) -> None:
        """End the gesture under way; all is exactly as it was before it."""

"""What tools have drawn over the face while they work.  Each part has its own signal, so that it alone is redrawn."""

from __future__ import annotations

from dataclasses import dataclass

from psygnal import Signal

from app.tools.pointer import Hit, Surface
from facemodel.laying.handles import Handle
from facemodel.laying.influence import Arrows
from facemodel.muscles import Muscle
from fem.types import FloatArray, IntArray


@dataclass(frozen=True, eq=False)
class Ring:
    """The cursor of a brush: a circle on the skin, and a second one where its mirror image paints.

    Attributes
    ----------
    hit : its middle
    mirrored : the middle of its image; none without mirror
    radius : millimetres on the skin
    core : share of the radius within which it paints fully
    """

    hit: Hit
    mirrored: Hit | None
    radius: float
    core: float


@dataclass(frozen=True, eq=False)
class Working:
    """Values of a layer that are painted but not yet committed: only those that moved since the last ones.

    Attributes
    ----------
    layer : key of the painted layer, see `facemodel.painting.layers`
    vertices : (k,) skin vertices
    values : (k,) in the unit of the layer
    """

    layer: str
    vertices: IntArray
    values: FloatArray


@dataclass(frozen=True, eq=False)
class Ghost:
    """Muscles as they would be if the hand let go now.

    Attributes
    ----------
    muscles : those that are laid or dragged; with the linked partner
    influence : (N,) 0 to 1, how strongly the first one acts on every vertex of the skin; none while it has no length
    most : what it does where it does most, N/mm^2, or mm where it displaces
    arrows : its forces
    complaint : why it could not be laid like this; empty if it could
    """

    muscles: tuple[Muscle, ...]
    influence: FloatArray | None = None
    most: float = 0.0
    arrows: Arrows | None = None
    complaint: str = ""


@dataclass(frozen=True, eq=False)
class Grip:
    """A handle that would be taken if the button went down now."""

    muscle: Muscle
    handle: Handle


@dataclass(frozen=True, eq=False)
class Ball:
    """What a brush on bone would select: all within a radius of a place of the bone at rest.

    Attributes
    ----------
    centre : (3,) millimetres
    radius : millimetres
    surface : the bone under the pointer
    """

    centre: FloatArray
    radius: float
    surface: Surface


class Sight:
    """The drawn things of the tool in hand; the viewport listens, and draws each of them when it comes."""

    ring_changed = Signal(object)
    """(Ring | None)"""
    working_changed = Signal(object)
    """(Working) values to draw at a few vertices; after a gesture the document has them, or they are put back."""
    ghost_changed = Signal(object)
    """(Ghost | None)"""
    grip_changed = Signal(object)
    """(Grip | None)"""
    shifted = Signal(object)
    """(DrawnChange: skin that goes farther than the project has it | None: all of it is back)"""
    outline_changed = Signal(object)
    """((k, 2) pixels of the lasso so far | None)"""
    pose_changed = Signal(object)
    """(Pose of the skull while it is moved | None where the project has it)"""
    part_changed = Signal(object)
    """(Part of the handles about the skull that would be taken, or is held | None)"""
    ball_changed = Signal(object)
    """(Ball about the pointer on the bone | None)"""
    axis_changed = Signal(object)
    """(ends (2, 3) of the jaw's axis while they are dragged | None where the project has them)"""
    end_changed = Signal(object)
    """(number of the end of the jaw's axis that would be taken, or is held | None)"""
    landmark_changed = Signal(str)
    """(name of the landmark of the skin that is asked about, empty for none)"""
    pointed_changed = Signal(str)
    """(key of the muscle under the pointer, empty for none)"""

    def __init__(self) -> None:
        self._pointed = ""

    def point_at(self, muscle: str) -> None:
        """Tell which muscle is under the pointer, if it is another one than before."""
        if muscle != self._pointed:
            self._pointed = muscle
            self.pointed_changed.emit(muscle)

    def clear(self) -> None:
        """Nothing is drawn any more."""
        self.ring_changed.emit(None)
        self.ghost_changed.emit(None)
        self.grip_changed.emit(None)
        self.outline_changed.emit(None)
        self.pose_changed.emit(None)
        self.part_changed.emit(None)
        self.ball_changed.emit(None)
        self.axis_changed.emit(None)
        self.end_changed.emit(None)
        self.landmark_changed.emit("")
        self.point_at("")

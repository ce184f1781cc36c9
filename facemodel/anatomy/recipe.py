"""The recipe of a face's anatomy: muscles and tissue in words of landmarks and millimetres.

All lengths are those of a face whose outer corners of the eyes lie `facemodel.anatomy.placement.EYES_APART` apart;
other faces scale them.  Offsets are (lateral, up, forward) from a landmark of the left side.
"""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

from facemodel.muscles.muscle import Model

Layer = Literal["stretching", "bending", "bending_across", "stiffness", "sliding", "volume"]
Around = Literal["eye", "lids", "eyeball", "mouth", "lips", "cheek"]
Sector = Literal["whole", "above", "below", "half"]

Offset = tuple[float, float, float]


@dataclass(frozen=True)
class Spot:
    """A place said in words: offset (lateral, up, forward) in millimetres from a landmark of the left side."""

    landmark: str
    offset: Offset = (0.0, 0.0, 0.0)


@dataclass(frozen=True)
class Course:
    """A central fibre: its origin on the bone, its attachment on the skin, and how often it touches bone between."""

    origin: Spot
    attachment: Spot
    over: int = 0


@dataclass(frozen=True)
class Band:
    """A muscle of fibres, in order across it.

    Attributes
    ----------
    name, title, group : as `facemodel.muscles.Muscle` has them
    courses : its central fibres
    width, kappa : of the fibres
    strength : N/mm^2 where its influence is one; full contraction of the action unit it is best known for
    midline : whether one muscle serves both sides
    """

    name: str
    title: str
    group: str
    courses: tuple[Course, ...]
    width: float
    kappa: float
    strength: float
    midline: bool = False


@dataclass(frozen=True)
class Ring:
    """A sphincter, or the levator of a lid, around an opening.

    Attributes
    ----------
    name, title, group, model : as `facemodel.muscles.Muscle` has them
    around : what its centre and axes are measured on, see `facemodel.anatomy.rings`
    shift : of its centre (lateral, up, forward), millimetres
    reach : half its long axis over half the width of the opening
    height : half its short axis, millimetres
    relative : share of half the height of the opening that is added to it
    sector : the part of the ring that is there: all, above or below its long axis, or one half to each side
    strength : as of a `Band`
    width, focus, inward, forward : of the ring; for the model ``mouth`` the last two are factors on its profiles
    """

    name: str
    title: str
    group: str
    model: Model
    around: Around
    shift: Offset
    reach: float
    height: float
    relative: float
    sector: Sector
    width: float
    strength: float
    focus: float = 0.0
    inward: float = 1.0
    forward: float = 0.0


@dataclass(frozen=True)
class Crease:
    """A line along the skin where muscles insert and it folds.

    Attributes
    ----------
    name, title, group : as `facemodel.muscles.Muscle` has them
    spots : on the skin from one end to the other; the flesh stands on the left hand of one who goes along it
    width : of the crease
    strength : as of a `Band`
    """

    name: str
    title: str
    group: str
    spots: tuple[Spot, ...]
    width: float
    strength: float


@dataclass(frozen=True)
class Region:
    """A soft-edged part of the skin about landmarks, or about the margin of ``lids`` or ``lips``.

    Attributes
    ----------
    name : what people call it
    about : landmarks, without side for both sides; or one margin
    inner, outer : millimetres within which it is all there, and beyond which it is not
    factors : by layer what its values are multiplied with; for ``volume``, which is nothing elsewhere, what it is
        there, whatever regions before it made of it
    """

    name: str
    about: tuple[str, ...]
    inner: float
    outer: float
    factors: dict[Layer, float] = field(default_factory=dict)


@dataclass(frozen=True)
class Tissue:
    """What skin and tissue are made of.

    Attributes
    ----------
    stretching : N/mm
    bending : N mm
    stiffness : N/mm^3, along the normal
    sliding : how many times softer along the surface
    regions : where they are otherwise
    """

    stretching: float
    bending: float
    stiffness: float
    sliding: float
    regions: tuple[Region, ...]


@dataclass(frozen=True)
class Anatomy:
    """The whole recipe."""

    bands: tuple[Band, ...]
    rings: tuple[Ring, ...]
    creases: tuple[Crease, ...]
    tissue: Tissue
    provenance: str = ""

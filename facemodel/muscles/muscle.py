"""What a muscle is, whatever model turns it into forces or displacements."""

from __future__ import annotations

from dataclasses import dataclass, field
from typing import Literal

import numpy as np

from facemodel.muscles.profile import Profiles
from fem.types import FloatArray

Model = Literal[
    "fibre", "quadrilateral", "cosine", "sphincter", "mouth", "cosine_ring", "lid", "pressure", "fold", "jaw"
]
MuscleSide = Literal["L", "R", "M"]


@dataclass(frozen=True, eq=False)
class Fibre:
    """One muscle vector, from its origin on the skull to its attachment on the skin; (3,) in millimetres.

    Of a fold, whose model lies along the skin, both ends are on the skin.

    A fibre with intermediate points ``via``, in order from the origin, is bent: it runs through them on the
    smooth curve of `facemodel.muscles.curve`.
    """

    origin: FloatArray
    attachment: FloatArray
    via: tuple[FloatArray, ...] = ()

    @property
    def points(self) -> FloatArray:
        """Origin, intermediate points and attachment, (k + 2, 3)."""
        return np.array([self.origin, *self.via, self.attachment])


@dataclass(frozen=True, eq=False)
class Sphincter:
    """The ring of a sphincter on the skin: an ellipse by its centre and two half axes; (3,) in millimetres.

    It pulls towards its line of closure, the middle ``focus`` of the long axis (0 a point, 1 the whole
    axis), with the share ``inward``, and along the outward normal, long axis cross short axis, with the
    share ``forward``. A ``sector`` that is not zero keeps the half of the ring that lies towards it, so
    that two halves make a whole.
    """

    centre: FloatArray
    long_axis: FloatArray
    short_axis: FloatArray
    sector: FloatArray = field(default_factory=lambda: np.zeros(3))
    focus: float = 0.0
    inward: float = 1.0
    forward: float = 0.0


@dataclass(frozen=True, eq=False)
class Cosine:
    """What a cosine pseudo-muscle needs beside its radius, which is the muscle's width.

    Attributes
    ----------
    box : (3,) half sizes along x, y and z of the bounding box about the point of application, millimetres
    share : part of the way to the point of attraction that the point of application goes at full contraction
    factors : (3,) K of a ring along its long axis, its short axis and its outward normal; 1 draws together
        wholly, negative values push apart
    """

    box: FloatArray
    share: float
    factors: FloatArray


@dataclass(frozen=True, eq=False)
class Muscle:
    """A muscle on one side of the face.

    Attributes
    ----------
    name : without side, for example ``zygomaticus_major``
    side : ``L``, ``R`` or ``M`` for a single muscle across the midline
    title : Latin name for people
    group : ``brow``, ``eye``, ``nose``, ``cheek``, ``lip`` or ``chin``; decides the colour
    model : which model turns it into forces or displacements, a key of `facemodel.muscles.models.MODELS`
    fibres : its central fibres
    ring : the ellipse of a sphincter
    width : millimetres; omega, half width of a fibre's influence, or the radius about an insertion
    kappa : exponent of the longitudinal profile; larger pulls nearer to the attachment
    strength : force per area of skin where the influence is one, N/mm^2
    count : fibres generated in the fan between the central ones
    profiles : sigma and tau of the mouth sphincter; None takes `facemodel.muscles.mouth.PROFILES`
    cosine : bounding box and factors of a pseudo-muscle; None takes those of `facemodel.muscles.cosine`
    linked : whether the muscle of the same name on the other side is kept its mirror image
    colour : ``#rrggbb`` on the face; empty takes that of its group
    """

    name: str
    side: MuscleSide
    title: str
    group: str
    model: Model
    fibres: tuple[Fibre, ...]
    ring: Sphincter | None
    width: float
    kappa: float
    strength: float
    count: int
    profiles: Profiles | None = None
    cosine: Cosine | None = None
    linked: bool = True
    colour: str = ""

    @property
    def key(self) -> str:
        """Unique name: ``zygomaticus_major_L``; a single muscle has no suffix."""
        return self.name if self.side == "M" else f"{self.name}_{self.side}"

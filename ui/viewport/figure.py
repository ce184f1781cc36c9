"""The face as it is drawn: skin, eyes, lashes, teeth and what lies behind, all following one superposition."""

from __future__ import annotations

from collections.abc import Iterator, Sequence

from vtkmodules.vtkRenderingCore import vtkActor

from facemodel.dental_arch import is_strip
from facemodel.face import Eye, Face, Part
from facemodel.superposition import Superposition
from ui.viewport.eyes import EyesInLids
from ui.viewport.lashes import Lashes
from ui.viewport.lids import LidLine, lids_of
from ui.viewport.lip_light import LipLight
from ui.viewport.look import look_of
from ui.viewport.mouth import MouthLight
from ui.viewport.neck import neck_cap, neck_cut
from ui.viewport.parts import POCKETS, enamel, pockets, tongue
from ui.viewport.seams import seam
from ui.viewport.shading import Ghost
from ui.viewport.skin import Skin
from ui.viewport.surface import Surface, moved_by
from ui.viewport.teeth import row_of_teeth
from ui.viewport.tongue import Tongue


class Figure:
    """Everything that belongs to one face and moves with it.

    Attributes
    ----------
    posed : the superposition whose arrays are drawn
    skin : the skin
    eyes : both eyes
    lashes : of the eyes whose lids are known
    """

    def __init__(self, posed: Superposition) -> None:
        self.posed = posed
        face, display = posed.face, posed.basis.display
        self._look = look_of(face)
        cut = neck_cut(display)
        self.skin = Skin(posed, self._look, cut)
        lids = [lids_of(display, eye) for eye in face.eyes]
        self.eyes = EyesInLids(face.eyes, lids, self._look.palette.iris)
        self.lashes = Lashes(_roots(face, lids), posed.points, self._look.palette.hair)
        self._pockets = pockets(posed, self._look.palette)
        self._jaw: list[Surface] = []
        self._still: list[Surface] = []
        self._caps: list[Surface] = []
        self._tongues: list[Tongue] = []
        if cut is not None:
            self._caps.append(neck_cap(cut, display))
        for part in face.parts:
            self._place(part)
        self._seam = seam(self.skin.surface, display, self._look.palette) if self._pockets else None
        self._mouth = MouthLight(face, display, [*self._still, *self._jaw])
        self._lips = LipLight(face, display, self.skin.surface)
        self.follow()

    def ghost(self, ghost: Ghost, bones: bool = False) -> None:
        """Make the skin solid, or clear; what would hide the bones behind a clear skin goes away with it.

        ``bones`` says that a skull is drawn, which has teeth of its own.
        """
        self.skin.ghost(ghost)
        for surface in (*self._still, *self._jaw):
            surface.actor.SetVisibility(not bones)
        hiding = [surface.actor for surface in self._behind]
        for actor in (*hiding, self._seam) if self._seam else hiding:
            actor.SetVisibility(ghost is Ghost.SOLID)

    def follow(self) -> None:
        """Take over what the superposition wrote."""
        self.skin.moved()
        if self._pockets is not None:
            self._pockets.moved()
        stance = self.posed.stance
        for surface in self._jaw:
            moved_by(surface, stance.head @ stance.jaw)
        for each in self._tongues:
            each.move(stance.posture.tongue)
        self.eyes.follow(stance.eyes, self.posed.points)
        self.lashes.follow(self.posed.points)
        parted = self._mouth.parted(self.posed.points)
        self._mouth.follow(parted)
        self._lips.follow(parted)

    @property
    def actors(self) -> Iterator[vtkActor]:
        """All that is drawn; what one can look through comes last: the clear film of the eyes, and lashes over it."""
        yield self.skin.surface.actor
        if self.skin.hem is not None:
            yield self.skin.hem.actor
        if self._seam is not None:
            yield self._seam
        for surface in (*self._still, *self._jaw, *self._behind):
            yield surface.actor
        yield from self.eyes.actors
        if self.lashes.surface is not None:
            yield self.lashes.surface.actor

    @property
    def _behind(self) -> list[Surface]:
        """What lies behind the skin and in its cut."""
        return [*([self._pockets] if self._pockets else []), *self._caps]

    def _place(self, part: Part) -> None:
        """Make what draws a part."""
        if part.kind != "lashes" and part.kind not in POCKETS:
            rows = row_of_teeth if is_strip(part) else enamel
            surface = rows(part) if part.kind == "teeth" else tongue(part)
            if part.kind == "tongue":
                self._tongues.append(Tongue(self.posed.face, part, surface))
            (self._jaw if part.carrier == "jaw" else self._still).append(surface)


def _roots(face: Face, lids: Sequence[LidLine]) -> list[tuple[Eye, LidLine]]:
    """The eyes that have lashes, with the line of the lids that these grow from."""
    lashes = [part.mesh.positions[:, 0].mean() for part in face.parts if part.kind == "lashes"]
    sides = {"L" if x > 0 else "R" for x in lashes}
    return [(eye, line) for eye, line in zip(face.eyes, lids, strict=True) if line.closed and eye.side in sides]

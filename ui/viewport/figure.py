"""The face as it is drawn: skin, eyes, lashes, teeth and what lies behind, all following one superposition."""

from __future__ import annotations

from collections.abc import Iterator

from vtkmodules.vtkRenderingCore import vtkActor

from facemodel.superposition import Superposition
from ui.viewport.eyes import EyeInLids
from ui.viewport.lashes import ROOT_LIFT, Lashes
from ui.viewport.lids import lid_line
from ui.viewport.look import look_of
from ui.viewport.neck import neck_cap, neck_cut
from ui.viewport.parts import lining, moved_by, socket, tongue
from ui.viewport.seams import seam
from ui.viewport.shading import Ghost
from ui.viewport.skin import Skin
from ui.viewport.surface import Surface
from ui.viewport.teeth import row_of_teeth


class Figure:
    """Everything that belongs to one face and moves with it.

    Attributes
    ----------
    posed : the superposition whose arrays are drawn
    skin : the skin
    cut : where the neck ends
    """

    def __init__(self, posed: Superposition) -> None:
        self.posed = posed
        face, display = posed.face, posed.basis.display
        look = look_of(face)
        self.skin = Skin(posed, look)
        self.eyes = tuple(EyeInLids(eye, lid_line(display, eye, 0.0)) for eye in face.eyes)
        self.lashes: list[Lashes] = []
        self._carried: list[Surface] = []
        self._jaw: list[Surface] = []
        self._seam = seam(self.skin.surface, display, look.palette)
        self.cut = neck_cut(face)
        self.skin.surface.mapper.AddClippingPlane(self.cut.plane)
        self._cap = neck_cap(self.cut, display)
        self._still: list[Surface] = [self._cap]
        eye_of = {eye.side: eye for eye in face.eyes}
        roots = {eye.side: lid_line(display, eye, ROOT_LIFT) for eye in face.eyes}
        for part in face.parts:
            if part.kind == "lining":
                self._carried.append(lining(part, posed.parts[part.name], look.palette))
            elif part.kind == "socket":
                self._carried.append(socket(part, posed.parts[part.name], look.palette))
            elif part.kind == "lashes":
                side = "L" if part.mesh.positions[:, 0].mean() > 0 else "R"
                self.lashes.append(Lashes(eye_of[side], roots[side], posed.points, look.palette.hair))
            else:
                surface = row_of_teeth(part) if part.kind == "teeth" else tongue(part)
                (self._jaw if part.carrier == "jaw" else self._still).append(surface)
        self.follow()

    def ghost(self, ghost: Ghost) -> None:
        """Make the skin solid, or clear; what would hide the bones behind a clear skin goes away with it."""
        self.skin.ghost(ghost)
        for actor in (self._seam, self._cap.actor, *(surface.actor for surface in self._carried)):
            actor.SetVisibility(ghost is Ghost.SOLID)

    def follow(self) -> None:
        """Take over what the superposition wrote."""
        self.skin.surface.moved()
        for surface in self._carried:
            surface.moved()
        for surface in self._jaw:
            moved_by(surface, self.posed.jaw)
        for eye in self.eyes:
            eye.shade(self.posed.points)
        for lash in self.lashes:
            lash.follow(self.posed.points)

    @property
    def actors(self) -> Iterator[vtkActor]:
        """All that is drawn; the clear film of the eyes comes last."""
        yield self.skin.surface.actor
        yield self._seam
        for surface in (*self._still, *self._jaw, *self._carried):
            yield surface.actor
        for lash in self.lashes:
            yield lash.surface.actor
        for eye in self.eyes:
            yield from eye.actors

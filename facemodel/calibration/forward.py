"""From a recipe of anatomy to what every muscle does to the skin of one face, fast enough to be asked many times."""

from __future__ import annotations

from collections.abc import Collection, Mapping, Sequence
from dataclasses import dataclass, fields, replace

import numpy as np

from facemodel.actions import JawMotion
from facemodel.anatomy.muscles import make_muscles
from facemodel.anatomy.paint import Canvas, head_margins, paint
from facemodel.anatomy.recipe import Anatomy, Tissue
from facemodel.calibration.lending import Lent
from facemodel.columns import jaw_columns, muscle_action_of
from facemodel.face import Face, Layers
from facemodel.jaw.modes import JawMode, mode_shares, motion_of
from facemodel.laying.fitting import fitted_atlas
from facemodel.muscles import Muscle
from facemodel.sameness import Kept, same
from facemodel.sampling import ELEMENTS
from facemodel.system import (
    HeldFace,
    face_material,
    face_supports,
    face_surfaces,
    face_tissue,
    factorise,
    held_system,
    stiffened,
    tissue_coupling,
)
from fem import Support
from fem.types import FloatArray, IntArray

ELEMENT = "hct9"
"""The lighter element: on faces its fields differ from those of HCT-12 by less than a hundredth in the cosine."""


@dataclass(frozen=True, eq=False)
class Lender:
    """A head on which tissue is painted, and how a measured skin borrows from it.

    Attributes
    ----------
    head : whose landmarks the recipe of the tissue speaks of
    lent : between its skin and the measured one; none if the head itself is solved
    """

    head: Face
    lent: Lent | None = None


class Forward:
    """One face whose anatomy is tried out.

    Parameters
    ----------
    face : its skin, bone and landmarks hold; its layers are painted anew
    lender : where tissue is painted
    """

    def __init__(self, face: Face, lender: Lender) -> None:
        self.face, self._lender = face, lender
        self._surfaces = face_surfaces(face, ELEMENTS[ELEMENT])
        head = lender.head
        self._canvas = Canvas(head.skin, head.landmarks, head_margins(head.skin))
        self._held: Kept[tuple[Face, HeldFace]] = Kept()
        self._fields: dict[str, tuple[Muscle, FloatArray]] = {}
        self._openings: dict[JawMotion, FloatArray] = {}
        self._tissue: Tissue | None = None

    @property
    def vertices(self) -> IntArray:
        """Solved skin vertices."""
        return self._surfaces.region.vertices

    def muscle_fields(self, anatomy: Anatomy, keys: Collection[str] | None = None) -> Mapping[str, FloatArray]:
        """Displacement (N, 3) of the skin by every muscle at full contraction, by its key; some keys only if asked."""
        face, held = self._hold(anatomy.tissue)
        wanted = self.muscles(anatomy, keys)
        new = [m for m in wanted if m.key not in self._fields or not same(self._fields[m.key][0], m)]
        if new:
            solved = self._solved(held, [muscle_action_of(m, face, held) for m in new])
            self._fields |= {m.key: (m, field) for m, field in zip(new, solved, strict=True)}
        return {m.key: self._fields[m.key][1] for m in wanted}

    def muscles(self, anatomy: Anatomy, keys: Collection[str] | None = None) -> tuple[Muscle, ...]:
        """The muscles of a recipe: laid on the head that lends, and carried over by landmarks as any atlas is."""
        head = self._lender.head
        laid = make_muscles(_only(anatomy, keys), head.skin, head.skull, head.landmarks, head.eyes)
        if keys is not None:
            laid = tuple(muscle for muscle in laid if muscle.key in keys)
        return laid if self._lender.lent is None else fitted_atlas(laid, head, self.face)

    def jaw_field(self, anatomy: Anatomy, motion: JawMotion) -> FloatArray:
        """Displacement (N, 3) of the skin by a motion of the jaw."""
        face, held = self._hold(anatomy.tissue)
        if motion not in self._openings:
            shares = mode_shares(face.skull.jaw, motion_of(face.skull.jaw, motion))
            modes = [JawMode(int(number)) for number in np.flatnonzero(shares)]
            columns = jaw_columns(modes, face, held)
            total = sum(shares[mode.number] * columns[mode].coefficients for mode in modes)
            self._openings[motion] = self._of_vertices(held, np.asarray(total)[..., None])[0]
        return self._openings[motion]

    def painted(self, anatomy: Anatomy) -> Face:
        """The face with its tissue painted by a recipe."""
        return self._hold(anatomy.tissue)[0]

    def _solved(self, held: HeldFace, actions: Sequence[FloatArray]) -> list[FloatArray]:
        return self._of_vertices(held, held.system.solve(held.consistent_loads(list(actions))))

    def _of_vertices(self, held: HeldFace, coefficients: FloatArray) -> list[FloatArray]:
        values = coefficients[held.surfaces.region.assembler.dofs.value_dofs]
        moved = np.zeros((values.shape[-1], len(self.face.skin.positions), 3))
        moved[:, self.vertices] = values.transpose(2, 0, 1)
        return list(moved)

    def _hold(self, tissue: Tissue) -> tuple[Face, HeldFace]:
        if tissue != self._tissue:
            self._tissue, self._fields, self._openings = tissue, {}, {}
        return self._held.get((tissue,), lambda: self._made(tissue))

    def _made(self, tissue: Tissue) -> tuple[Face, HeldFace]:
        head = self._lender.head
        layers = paint(tissue, self._canvas, head.skin, head.solved, head.landmarks)
        if self._lender.lent is not None:
            layers = borrowed(layers, self._lender.lent, self.face.layers.supports)
        face = replace(self.face, layers=layers)
        surfaces, vertices = self._surfaces, self.vertices
        assembler = surfaces.region.assembler
        springs, supports = face_tissue(face, vertices), face_supports(face, vertices)
        stiffness = stiffened(None, assembler, face_material(face, vertices)).stiffness
        system = held_system(surfaces, supports, stiffness, tissue_coupling(springs, assembler))
        return face, HeldFace(surfaces, springs, supports, factorise(system, surfaces))


def _only(anatomy: Anatomy, keys: Collection[str] | None) -> Anatomy:
    if keys is None:
        return anatomy
    names = {key.removesuffix("_L").removesuffix("_R") for key in keys}
    return replace(
        anatomy,
        bands=tuple(band for band in anatomy.bands if band.name in names),
        rings=tuple(ring for ring in anatomy.rings if ring.name in names),
    )


def borrowed(layers: Layers, lent: Lent, supports: IntArray) -> Layers:
    """Layers of a head on the skin that borrows from it, held by supports of its own."""
    rest = {each.name: lent.values(getattr(layers, each.name)) for each in fields(Layers) if each.name != "supports"}
    return Layers(supports=supports, **rest)


def borrowed_supports(layers: Layers, lent: Lent, clamped: IntArray) -> IntArray:
    """Supports of a head on the skin that borrows from it; some vertices are clamped, and no others."""
    supports = layers.supports[lent.vertex].copy()
    supports[supports == Support.CLAMPED] = Support.FREE
    supports[clamped] = Support.CLAMPED
    return supports

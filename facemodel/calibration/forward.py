"""From a recipe of anatomy to what every muscle does to the skin of one face, fast enough to be asked many times."""

from __future__ import annotations

from collections.abc import Collection, Iterator, Mapping, Sequence
from dataclasses import dataclass, fields, replace
from itertools import groupby

import numpy as np

from facemodel.actions import JawMotion
from facemodel.anatomy.muscles import make_muscles
from facemodel.anatomy.paint import Canvas, head_margins, paint
from facemodel.anatomy.recipe import Anatomy, Tissue
from facemodel.calibration.assembled import Assembled, Source, keeping_no_volume
from facemodel.calibration.lending import Lent
from facemodel.columns import CHUNK, Told, jaw_columns, muscle_action_of
from facemodel.face import Face, Layers
from facemodel.jaw.modes import JawMode, mode_shares, motion_of
from facemodel.laying.fitting import fitted_atlas
from facemodel.muscles import Muscle
from facemodel.sameness import Kept, same
from facemodel.sampling import ELEMENTS
from facemodel.system import face_surfaces
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

    What is solved is kept as coefficients, as long as the tissue and the muscle hold.

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
        self._held: Kept[Assembled] = Kept()
        self._columns: dict[str, tuple[Muscle, FloatArray]] = {}
        self._openings: dict[JawMotion, FloatArray] = {}
        self._tissue: Tissue | None = None

    @property
    def vertices(self) -> IntArray:
        """Solved skin vertices."""
        return self._surfaces.region.vertices

    def muscle_fields(self, anatomy: Anatomy, keys: Collection[str] | None = None) -> Mapping[str, FloatArray]:
        """Displacement (N, 3) of the skin by every muscle at full contraction, by its key; some keys only if asked."""
        return {key: self._of_vertices(column)[0] for key, column in self.columns(anatomy, keys).items()}

    def columns(self, anatomy: Anatomy, keys: Collection[str] | None = None) -> Mapping[str, FloatArray]:
        """The same as coefficients (n_dofs, 3, 1)."""
        here = self.assembled(anatomy.tissue)
        wanted = self.muscles(anatomy, keys)
        new = [m for m in wanted if m.key not in self._columns or not same(self._columns[m.key][0], m)]
        if new:
            solved = _solved(here, new)
            self._columns |= {m.key: (m, solved[..., k : k + 1].copy()) for k, m in enumerate(new)}
        return {m.key: self._columns[m.key][1] for m in wanted}

    def fields_of(self, muscles: Sequence[Muscle], tissue: Tissue, told: Told) -> Iterator[FloatArray]:
        """Displacement (N, 3) of the skin by muscles, one by one, which are solved anew and not kept.

        Parameters
        ----------
        told : how many are solved and of how many, before the first and after every chunk
        """
        here = self.assembled(tissue)
        told(0, len(muscles))
        for start in range(0, len(muscles), CHUNK):
            yield from self._of_vertices(_solved(here, muscles[start : start + CHUNK]))
            told(min(start + CHUNK, len(muscles)), len(muscles))

    def muscles(self, anatomy: Anatomy, keys: Collection[str] | None = None) -> tuple[Muscle, ...]:
        """The muscles of a recipe: laid on the head that lends, and carried over by landmarks as any atlas is."""
        head = self._lender.head
        laid = make_muscles(_only(anatomy, keys), head.skin, head.skull, head.landmarks, head.eyes)
        if keys is not None:
            laid = tuple(muscle for muscle in laid if muscle.key in keys)
        return laid if self._lender.lent is None else fitted_atlas(laid, head, self.face)

    def jaw_field(self, anatomy: Anatomy, motion: JawMotion) -> FloatArray:
        """Displacement (N, 3) of the skin by a motion of the jaw."""
        return self._of_vertices(self.jaw_column(anatomy, motion))[0]

    def jaw_column(self, anatomy: Anatomy, motion: JawMotion) -> FloatArray:
        """The same as coefficients (n_dofs, 3, 1)."""
        here = self.assembled(anatomy.tissue)
        if motion not in self._openings:
            shares = self.modes(motion)
            columns = jaw_columns(tuple(shares), here.face, here.held)
            total = sum(share * columns[mode].coefficients for mode, share in shares.items())
            self._openings[motion] = np.asarray(total)[..., None]
        return self._openings[motion]

    def modes(self, motion: JawMotion) -> dict[JawMode, float]:
        """The modes of the jaw of which a motion is made."""
        jaw = self.face.skull.jaw
        shares = mode_shares(jaw, motion_of(jaw, motion))
        return {JawMode(int(number)): float(shares[number]) for number in np.flatnonzero(shares)}

    def painted(self, anatomy: Anatomy) -> Face:
        """The face with its tissue painted by a recipe."""
        return self.assembled(anatomy.tissue).face

    def changes(self, tissue: Tissue, other: Tissue, mixtures: Sequence[Mixture]) -> list[FloatArray]:
        """Displacement (N, 3) that mixtures gain by another tissue, to first order in what the tissue differs by."""
        here, face = self.assembled(tissue), self.dressed(other)
        gained: list[FloatArray] = []
        for opens, run in groupby(mixtures, lambda mixture: mixture.opens):
            now, then = (here.yielding, keeping_no_volume(face)) if opens else (here, face)
            gained += self._gained(now, then, list(run))
        return gained

    def _gained(self, here: Assembled, face: Face, mixtures: Sequence[Mixture]) -> list[FloatArray]:
        pushed = here.pushed(face, {source for mixture in mixtures for source in mixture.sources})
        loads = -here.resisted(face, np.concatenate([mixture.field for mixture in mixtures], axis=2))
        for number, mixture in enumerate(mixtures):
            for source, weight in mixture.sources.items():
                loads[..., number] += weight * pushed.get(source, 0.0)
        return self._of_vertices(here.held.system.solve(loads))

    def dressed(self, tissue: Tissue) -> Face:
        """The face with a tissue that nobody has solved yet."""
        head = self._lender.head
        layers = paint(tissue, self._canvas, head.skin, head.solved, head.landmarks)
        if self._lender.lent is not None:
            layers = borrowed(layers, self._lender.lent, self.face.layers.supports)
        return replace(self.face, layers=layers)

    def assembled(self, tissue: Tissue) -> Assembled:
        """The face with a tissue, assembled and factorised; the last one is kept."""
        if tissue != self._tissue:
            self._tissue, self._columns, self._openings = tissue, {}, {}
        return self._held.get((tissue,), lambda: Assembled.of(self.dressed(tissue), self._surfaces))

    def _of_vertices(self, coefficients: FloatArray) -> list[FloatArray]:
        values = coefficients[self._surfaces.region.assembler.dofs.value_dofs]
        moved = np.zeros((values.shape[-1], len(self.face.skin.positions), 3))
        moved[:, self.vertices] = values.transpose(2, 0, 1)
        return list(moved)


@dataclass(frozen=True, eq=False)
class Mixture:
    """A field that several sources make together.

    Attributes
    ----------
    sources : muscles and modes of the jaw with their weights
    field : (n_dofs, 3, 1) coefficients of its displacement
    """

    sources: Mapping[Source, float]
    field: FloatArray

    @property
    def opens(self) -> bool:
        """Whether the jaw moves it; no unit of the jaw has muscles beside it."""
        return any(isinstance(source, JawMode) for source in self.sources)


def _solved(here: Assembled, muscles: Sequence[Muscle]) -> FloatArray:
    actions = [muscle_action_of(muscle, here.face, here.held) for muscle in muscles]
    return here.held.system.solve(here.held.consistent_loads(actions))


def _only(anatomy: Anatomy, keys: Collection[str] | None) -> Anatomy:
    if keys is None:
        return anatomy
    names = {key.removesuffix("_L").removesuffix("_R") for key in keys}
    return replace(
        anatomy,
        bands=tuple(band for band in anatomy.bands if band.name in names),
        rings=tuple(ring for ring in anatomy.rings if ring.name in names),
        creases=tuple(crease for crease in anatomy.creases if crease.name in names),
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

"""The system of a face in its parts, so that it is felt which of them other tissue changes."""

from __future__ import annotations

from collections.abc import Collection
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from scipy.sparse import csc_array

from facemodel.columns import jaw_action, muscle_action_of
from facemodel.face import Face
from facemodel.jaw.modes import JawMode
from facemodel.muscles import Muscle
from facemodel.muscles.models import MODELS
from facemodel.sameness import same
from facemodel.system import (
    HeldFace,
    Stiffened,
    Surfaces,
    face_material,
    face_supports,
    face_tissue,
    factorise,
    held_system,
    stiffened,
)
from fem import Foundation
from fem.types import FloatArray

Source = Muscle | JawMode
"""What moves skin: a muscle, or the jaw in one of its modes."""


@dataclass(frozen=True, eq=False)
class Assembled:
    """A face whose skin and tissue are assembled and factorised.

    Attributes
    ----------
    face : of which all is
    skin : the stiffness of its skin
    springs, volume : (3 n_dofs, 3 n_dofs) of its tissue; no volume where none of it is kept
    held : the system of all of them
    """

    face: Face
    skin: Stiffened
    springs: csc_array
    volume: csc_array | None
    held: HeldFace

    @classmethod
    def of(cls, face: Face, surfaces: Surfaces) -> Assembled:
        """Assemble and factorise a face.

        Raises
        ------
        FaceError
            If its supports and springs leave part of it loose.
        """
        region = surfaces.region
        tissue, supports = face_tissue(face, region.vertices), face_supports(face, region.vertices)
        skin = stiffened(None, region.assembler, face_material(face, region.vertices))
        springs = Foundation(tissue.blocks).coupling(region.assembler)
        volume = tissue.volume.coupling(region.assembler) if tissue.keeps_volume else None
        coupling = springs if volume is None else csc_array(springs + volume)
        system = factorise(held_system(surfaces, supports, skin.stiffness, coupling), surfaces)
        return cls(face, skin, springs, volume, HeldFace(surfaces, tissue, supports, skin.stiffness, system))

    @cached_property
    def yielding(self) -> Assembled:
        """The same face whose tissue keeps no volume, as it gives way to the jaw."""
        return Assembled(keeping_no_volume(self.face), self.skin, self.springs, None, self.held.yielding)

    def resisted(self, face: Face, fields: FloatArray) -> FloatArray:
        """Loads (n_dofs, 3, M) that fields of such coefficients need beyond those of now where the tissue is another.

        Parameters
        ----------
        face : the same one with other layers
        fields : (n_dofs, 3, M) coefficients of displacements
        """
        region, count = self.held.surfaces.region, fields.shape[0]
        loads = np.zeros((3 * count, fields.shape[2]))
        skin = stiffened(self.skin, region.assembler, face_material(face, region.vertices))
        if len(skin.touched):
            other = skin.stiffness.matrix - self.skin.stiffness.matrix
            loads += (other @ fields.reshape(count, -1)).reshape(loads.shape)
        tissue, flat = face_tissue(face, region.vertices), fields.reshape(loads.shape)
        if not np.array_equal(tissue.blocks, self.held.tissue.blocks):
            loads += (Foundation(tissue.blocks).coupling(region.assembler) - self.springs) @ flat
        if not same(tissue.volume, self.held.tissue.volume):
            loads += tissue.volume.coupling(region.assembler) @ flat
            loads -= 0.0 if self.volume is None else self.volume @ flat
        return loads.reshape(fields.shape)

    def pushed(self, face: Face, sources: Collection[Source]) -> dict[Source, FloatArray]:
        """Loads (n_dofs, 3) of sources beyond those of now where the tissue is another: bone pulls by its springs.

        The jaw's are those on tissue that keeps no volume.

        The forces that lead the lips along with the jaw stay as they are, which is true to first order in the cheeks
        and chin.
        """
        now, region = self.held, self.held.surfaces.region
        there = HeldFace(now.surfaces, face_tissue(face, region.vertices), now.supports, now.skin, now.system)
        # The operator of the volume's loads is costly, and that of now does where the layer is the same.
        loading = now if same(there.tissue.volume, now.tissue.volume) else there
        return {
            source: loading.consistent_loads([_acting(source, face, there)])[..., 0]
            - now.consistent_loads([_acting(source, self.face, now)])[..., 0]
            for source in sources
            if isinstance(source, JawMode) or MODELS[source.model].inflates
        }


def keeping_no_volume(face: Face) -> Face:
    """A face whose tissue keeps none of its volume."""
    return replace(face, layers=replace(face.layers, volume=np.zeros_like(face.layers.volume)))


def _acting(source: Source, face: Face, held: HeldFace) -> FloatArray:
    if isinstance(source, JawMode):
        return jaw_action(face, source, held)
    return muscle_action_of(source, face, held)

"""The linear system of a face, step by step: surfaces, material, tissue, supports; pure functions."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, replace
from functools import cached_property

import numpy as np
from scipy.sparse import csc_array, csr_array

from facemodel.errors import FaceError
from facemodel.face import Face
from facemodel.sampling import HeadSurface, SolvedRegion, head_surface, solved_region
from facemodel.tissue import tissue_springs
from facemodel.volume import volume_layer
from fem import (
    Assembler,
    Element,
    Foundation,
    Material,
    SingularSystemError,
    SpringSet,
    Stiffness,
    Support,
    Supports,
    SurfaceSystem,
    VolumeLayer,
    element_tensors,
    load_operator,
)
from fem.types import FloatArray, IntArray


@dataclass(frozen=True, eq=False)
class Surfaces:
    """What is found once per skin and element.

    Attributes
    ----------
    head : the smooth surface of the whole skin
    region : the solved part of it
    loads : (n_dofs, n) operator from forces per area at the vertices of the region to consistent loads
    """

    head: HeadSurface
    region: SolvedRegion
    loads: csr_array


@dataclass(frozen=True, eq=False)
class Tissue:
    """The springs between the solved skin and the skull.

    Attributes
    ----------
    springs : vertices numbered as in the region
    anchors : (M, 3) the skull end of every spring, millimetres
    jawbone : (M,) the share of that end which belongs to the mandible
    blocks : (n, 3, 3) their stiffness per area at the vertices, N/mm^3
    volume : the tissue as a layer that keeps its volume
    """

    springs: SpringSet
    anchors: FloatArray
    jawbone: FloatArray
    blocks: FloatArray
    volume: VolumeLayer

    @property
    def keeps_volume(self) -> bool:
        """Whether any of it resists a change of its volume."""
        return bool(self.volume.stiffness.any())

    @property
    def stiff(self) -> tuple[FloatArray, ...]:
        """All that its stiffness depends on."""
        return (self.blocks, self.volume.stiffness, *((self.volume.thickness,) if self.keeps_volume else ()))


@dataclass(frozen=True, eq=False)
class Stiffened:
    """A stiffness matrix with what it was assembled from.

    Attributes
    ----------
    assembler : of the region
    material : of its vertices
    stiffness : the matrix and the element matrices it is the sum of
    touched : (k,) triangles that were integrated for it
    """

    assembler: Assembler
    material: Material
    stiffness: Stiffness
    touched: IntArray


@dataclass(frozen=True, eq=False)
class HeldFace:
    """The linear system of a face and what it is made of.

    Attributes
    ----------
    surfaces, tissue, supports : of the face
    skin : its stiffness
    system : of skin, tissue and supports
    """

    surfaces: Surfaces
    tissue: Tissue
    supports: Supports
    skin: Stiffness
    system: SurfaceSystem

    def consistent_loads(self, actions: Sequence[FloatArray]) -> FloatArray:
        """Loads (n_dofs, 3, M) of M actions at the vertices of the region.

        Parameters
        ----------
        actions : force per area (n, 3), N/mm^2; a fourth column is volume per area that is put under the skin,
            millimetres, and acts where the tissue keeps its volume
        """
        forces = np.array([action[:, :3] for action in actions])
        flat = forces.transpose(1, 2, 0).reshape(forces.shape[1], -1)
        loads = np.asarray(self.surfaces.loads @ flat).reshape(-1, 3, len(forces))
        for number, action in enumerate(actions):
            if action.shape[1] > 3 and self.tissue.keeps_volume:
                loads[:, :, number] += (self._volume_loads @ action[:, 3]).reshape(-1, 3)
        return loads

    @cached_property
    def yielding(self) -> HeldFace:
        """The same face whose tissue keeps no volume, factorised.

        A muscle gathers the tissue over bone that stays, and it bulges.  Over a jaw that opens by a hand's breadth
        the same tissue lies on no bone any more but on the lining of cheek and lip, which is drawn long with the
        skin, while the mouth gives it all the room it wants; and bone that turns by 30 degrees sweeps a volume that
        means nothing to first order.

        Raises
        ------
        FaceError
            If the springs alone leave part of the face loose.
        """
        if not self.tissue.keeps_volume:
            return self
        layer = self.tissue.volume
        tissue = replace(self.tissue, volume=VolumeLayer(np.zeros_like(layer.stiffness), layer.thickness))
        coupling = tissue_coupling(tissue, self.surfaces.region.assembler)
        system = factorise(held_system(self.surfaces, self.supports, self.skin, coupling), self.surfaces)
        return HeldFace(self.surfaces, tissue, self.supports, self.skin, system)

    def room(self, coefficients: FloatArray) -> FloatArray:
        """Loads (n_dofs, 3, M) that give the tissue the room by which displacements (n_dofs, 3, M) change its volume.

        Under them beside its own loads the face goes where it would if its tissue were `yielding`.
        """
        if not self.tissue.keeps_volume:
            return np.zeros_like(coefficients)
        layer = self.tissue.volume.coupling(self.surfaces.region.assembler)
        return np.asarray(layer @ coefficients.reshape(layer.shape[0], -1)).reshape(coefficients.shape)

    @cached_property
    def _volume_loads(self) -> csr_array:
        return self.tissue.volume.load_operator(self.surfaces.region.assembler)


def face_surfaces(face: Face, element: Element) -> Surfaces:
    """The smooth surface of a face, its solved region, and how forces load it."""
    head = head_surface(face, element)
    region = solved_region(face, head)
    return Surfaces(head, region, load_operator(region.assembler))


def solved_vertices(face: Face) -> IntArray:
    """Skin vertices (n,) of the solved region, in the order in which it numbers them."""
    return np.unique(face.skin.triangles[face.solved])


def face_material(face: Face, vertices: IntArray) -> Material:
    """Painted stretching and bending at some skin vertices."""
    layers = face.layers
    return Material(layers.direction[vertices], layers.stretching[vertices], layers.bending[vertices])


def face_tissue(face: Face, vertices: IntArray) -> Tissue:
    """The springs under some skin vertices."""
    springs, anchors, jawbone = tissue_springs(face, vertices)
    return Tissue(springs, anchors, jawbone, springs.blocks(len(vertices)), volume_layer(face, vertices))


def face_supports(face: Face, vertices: IntArray) -> Supports:
    """Painted supports of the solved vertices, with the rim where they join the held rest clamped.

    A vertex that slides keeps its place along the skin's normal at rest.
    """
    kinds = face.layers.supports[vertices].copy()
    kinds[np.isin(vertices, face.skin.triangles[~face.solved])] = Support.CLAMPED
    return Supports(kinds, np.where((kinds == Support.SLIDING)[:, None], face.skin.normals[vertices], 0.0))


def stiffened(kept: Stiffened | None, assembler: Assembler, material: Material) -> Stiffened:
    """The stiffness of a material; where a kept one is of the same surface, only what differs is integrated anew."""
    if kept is None or kept.assembler is not assembler:
        touched = np.arange(assembler.surface.n_triangles)
        stiffness = assembler.assemble(element_tensors(assembler.surface, material))
        return Stiffened(assembler, material, stiffness, touched)
    changed = np.zeros(assembler.surface.n_vertices, dtype=np.bool_)
    for layer in ("direction", "stretching", "bending"):
        changed |= (getattr(material, layer) != getattr(kept.material, layer)).any(axis=1)
    touched = np.flatnonzero(changed[assembler.surface.triangles].any(axis=1))
    if len(touched) == 0:
        return replace(kept, touched=touched)
    tensors = element_tensors(assembler.surface, material)
    return Stiffened(assembler, material, assembler.reassemble(kept.stiffness, tensors, touched), touched)


def tissue_coupling(tissue: Tissue, assembler: Assembler) -> csc_array:
    """The springs, and the layer that keeps its volume, as a matrix (3 n_dofs, 3 n_dofs)."""
    springs = Foundation(tissue.blocks).coupling(assembler)
    return csc_array(springs + tissue.volume.coupling(assembler)) if tissue.keeps_volume else springs


def held_system(surfaces: Surfaces, supports: Supports, stiffness: Stiffness, coupling: csc_array) -> SurfaceSystem:
    """The system of a face, not yet factorised.

    Raises
    ------
    FaceError
        If a connected part of the face has neither support nor spring.
    """
    region = surfaces.region
    try:
        return SurfaceSystem(region.assembler.dofs, stiffness.matrix, supports, coupling)
    except SingularSystemError as error:
        raise loose_face(error, region.vertices) from error


def factorise(system: SurfaceSystem, surfaces: Surfaces) -> SurfaceSystem:
    """The system, factorised now rather than at the first solve.

    Raises
    ------
    FaceError
        If the supports and springs leave part of the face loose.
    """
    try:
        system.factorise()
    except SingularSystemError as error:
        raise loose_face(error, surfaces.region.vertices) from error
    return system


def loose_face(error: SingularSystemError, vertices: IntArray) -> FaceError:
    """The error that tells a user where a face is loose."""
    place = int(vertices[error.vertices[0]]) if len(error.vertices) else 0
    return FaceError(
        f"The face is loose around skin vertex {place}: nothing holds it there. "
        "Paint tissue stiffness or a support on that region, then solve again."
    )

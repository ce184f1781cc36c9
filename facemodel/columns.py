"""What every source does to the skin alone, kept for as long as it holds."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass
from typing import Any

import numpy as np

from facemodel.displaced import MEMBRANE, displaced_columns, displaces
from facemodel.face import Face
from facemodel.jaw.leading import lead_skin
from facemodel.jaw.modes import JawMode
from facemodel.loads import bone_forces, jaw_forces
from facemodel.muscles import Muscle
from facemodel.muscles.models import MODELS, muscle_action
from facemodel.project import Project
from facemodel.sameness import Kept, same
from facemodel.sources import Source, acting
from facemodel.system import HeldFace
from facemodel.tissue import tissue_stiffness
from fem import SmoothInterpolation
from fem.types import FloatArray

CHUNK = 16
"""Loads solved between two calls of the progress: enough that the factors are streamed from memory once for many, few
enough that cancelling is felt as immediate; what was solved by then is kept."""

Told = Callable[[int, int], None]
"""Told how many columns are made and of how many; whatever it raises ends the solve."""


@dataclass(frozen=True, eq=False)
class Column:
    """What one source does to the skin alone at activation 1.

    Attributes
    ----------
    action : (n, 3) force per area at the vertices of the region, N/mm^2, and for breath in a fourth column the
        volume per area that it puts under the skin, millimetres; of a muscle that displaces, (N, 3)
        displacement of the skin's vertices, millimetres
    coefficients : (n_dofs, 3) of the displacement of the region
    """

    action: FloatArray
    coefficients: FloatArray


class Columns:
    """Columns by source, all of one factorised face; one is made anew only if its action has changed.

    Attributes
    ----------
    made : how many columns the last `update` has made
    """

    def __init__(self) -> None:
        self.made = 0
        self._columns: dict[Source, Column] = {}
        self._actions: dict[str, Kept[FloatArray]] = {}
        self._jaw: Kept[dict[Source, Column]] = Kept()
        self._smooth: Kept[SmoothInterpolation] = Kept()

    def __getitem__(self, source: Source) -> Column:
        return self._columns[source]

    def forget(self) -> None:
        """Let go of all columns: they are of a face that is held otherwise now."""
        self._columns = {}

    def update(self, project: Project, sources: Sequence[Source], held: HeldFace, told: Told) -> None:
        """Make the columns of some sources hold for a face.

        Parameters
        ----------
        project : whose muscles act
        sources : those wanted, each once
        held : the factorised face
        told : called before the first and after every chunk; columns of chunks that were done are kept
        """
        face, muscles = project.face, {muscle.key: muscle for muscle in project.muscles}
        self._columns = {s: c for s, c in self._columns.items() if s in muscles or s in sources}
        self._actions = {key: kept for key, kept in self._actions.items() if key in muscles}
        modes = tuple(source for source in sources if isinstance(source, JawMode))
        acting_now = {s: self._action(muscles[s], face, held) for s in sources if isinstance(s, str)}
        stale = [s for s, a in acting_now.items() if s not in self._columns or not same(self._columns[s].action, a)]
        shifting = [s for s in stale if displaces(muscles[s])]
        loading = [s for s in stale if not displaces(muscles[s])]
        jaw_moved = bool(modes) and not self._jaw.holds(_jaw_made_from(modes, face, held))
        total = len(stale) + (len(modes) if jaw_moved else 0)
        self.made = 0
        told(0, total)
        for start in range(0, len(loading), CHUNK):
            chunk = loading[start : start + CHUNK]
            loads = held.consistent_loads([acting_now[s] for s in chunk])
            self._keep(chunk, acting_now, held.system.solve(loads))
            told(self.made, total)
        if shifting:
            self._keep(shifting, acting_now, self._displaced(np.array([acting_now[s] for s in shifting]), held))
            told(self.made, total)
        if modes:
            made_from = _jaw_made_from(modes, face, held)
            self._columns |= self._jaw.get(made_from, lambda: jaw_columns(modes, face, held))
            self.made = total
            told(self.made, total)

    def _action(self, muscle: Muscle, face: Face, held: HeldFace) -> FloatArray:
        """The action of a muscle, kept as long as all that it depends on is the same."""
        kept = self._actions.setdefault(muscle.key, Kept())
        return kept.get((*acting(muscle, face), face.solved), lambda: muscle_action_of(muscle, face, held))

    def _displaced(self, displacements: FloatArray, held: HeldFace) -> FloatArray:
        head = held.surfaces.head.assembler
        smooth = self._smooth.get((head,), lambda: SmoothInterpolation(head, MEMBRANE))
        return displaced_columns(displacements, smooth, held.surfaces.region, held.supports)

    def _keep(self, sources: Sequence[str], actions: Mapping[str, FloatArray], coefficients: FloatArray) -> None:
        for number, source in enumerate(sources):
            self._columns[source] = Column(actions[source], np.ascontiguousarray(coefficients[..., number]))
        self.made += len(sources)


def displacing(source: Source, muscles: Mapping[str, Muscle]) -> bool:
    """Whether a source displaces the skin's vertices and needs no solve."""
    return isinstance(source, str) and displaces(muscles[source])


def muscle_action_of(muscle: Muscle, face: Face, held: HeldFace) -> FloatArray:
    """What a muscle does to the skin at activation 1, as `Column.action` has it."""
    if displaces(muscle):
        return muscle_action(muscle, face)
    pull = bone_forces(muscle, face)[held.surfaces.region.vertices]
    if MODELS[muscle.model].inflates and held.tissue.keeps_volume:
        return np.column_stack([pull, inflated(face, pull, held)])
    return pull


def inflated(face: Face, pressure: FloatArray, held: HeldFace) -> FloatArray:
    """Volume per area (n,), millimetres, that a pressure from within brings under skin whose tissue keeps its volume.

    Air moves the far side of the tissue as well, which then has nothing to keep: the volume is that by which the
    pressure would lift the skin against its springs alone.
    """
    vertices = held.surfaces.region.vertices
    outward = np.einsum("ij,ij->i", pressure, face.skin.normals[vertices])
    return np.asarray(outward / np.maximum(tissue_stiffness(face)[vertices], SOFTEST))


SOFTEST = 1e-6
"""N/mm^3; tissue that is softer lets no pressure tell how far it lifts the skin."""


def jaw_columns(modes: Sequence[JawMode], face: Face, held: HeldFace) -> dict[Source, Column]:
    """What whole modes of the jaw do to the skin: the pull of tissue, and the forces that lead lips and chin along.

    Its tissue yields to them (see `HeldFace.yielding`).
    """
    if not modes:
        return {}
    giving = held.yielding
    led = lead_skin(face, giving, modes, [jaw_action(face, mode, giving) for mode in modes])
    return {
        mode: Column(led.actions[number], np.ascontiguousarray(led.coefficients[..., number]))
        for number, mode in enumerate(modes)
    }


def jaw_action(face: Face, mode: JawMode, held: HeldFace) -> FloatArray:
    """Force per area (n, 3) with which the springs pull the skin along with a mode of the jaw."""
    tissue = held.tissue
    return jaw_forces(face, mode, tissue.springs, tissue.anchors, tissue.jawbone)


def _jaw_made_from(modes: tuple[JawMode, ...], face: Face, held: HeldFace) -> tuple[Any, ...]:
    """All that `jaw_columns` depends on; how well tissue keeps its volume is none of it."""
    tissue, skin = held.tissue, face.skin
    pulling = held.surfaces.region.assembler, held.skin.element_matrices, held.supports
    pulled = tissue.springs, tissue.anchors, tissue.jawbone
    return modes, *pulling, *pulled, face.skull.jaw, skin.positions, skin.triangles, face.landmarks

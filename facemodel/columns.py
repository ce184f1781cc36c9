"""What every source does to the skin alone, kept for as long as it holds."""

from __future__ import annotations

from collections.abc import Callable, Mapping, Sequence
from dataclasses import dataclass

import numpy as np

from facemodel.displaced import MEMBRANE, displaced_columns, displaces
from facemodel.face import Face
from facemodel.loads import bone_forces, jaw_forces
from facemodel.muscles import Muscle
from facemodel.muscles.models import muscle_action
from facemodel.project import Project
from facemodel.sameness import Kept, same
from facemodel.sources import Source, acting
from facemodel.system import HeldFace
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
    action : (n, 3) force per area at the vertices of the region, N/mm^2; of a muscle that displaces, (N, 3)
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
        actions = {source: self._action(source, muscles, face, held) for source in sources}
        stale = [s for s in sources if s not in self._columns or not same(self._columns[s].action, actions[s])]
        shifting = [s for s in stale if displacing(s, muscles)]
        loading = [s for s in stale if not displacing(s, muscles)]
        self.made = 0
        told(0, len(stale))
        for start in range(0, len(loading), CHUNK):
            chunk = loading[start : start + CHUNK]
            loads = held.consistent_loads(np.array([actions[s] for s in chunk]))
            self._keep(chunk, actions, held.system.solve(loads))
            told(self.made, len(stale))
        if shifting:
            self._keep(shifting, actions, self._displaced(np.array([actions[s] for s in shifting]), held))
            told(self.made, len(stale))

    def _action(self, source: Source, muscles: Mapping[str, Muscle], face: Face, held: HeldFace) -> FloatArray:
        """The action of a source; that of a muscle is kept as long as all that it depends on is the same."""
        if not isinstance(source, str):
            return action_of(source, muscles, face, held)
        kept = self._actions.setdefault(source, Kept())
        depends = (*acting(muscles[source], face), face.solved)
        return kept.get(depends, lambda: action_of(source, muscles, face, held))

    def _displaced(self, displacements: FloatArray, held: HeldFace) -> FloatArray:
        head = held.surfaces.head.assembler
        smooth = self._smooth.get((head,), lambda: SmoothInterpolation(head, MEMBRANE))
        return displaced_columns(displacements, smooth, held.surfaces.region, held.supports)

    def _keep(self, sources: Sequence[Source], actions: Mapping[Source, FloatArray], coefficients: FloatArray) -> None:
        for number, source in enumerate(sources):
            self._columns[source] = Column(actions[source], np.ascontiguousarray(coefficients[..., number]))
        self.made += len(sources)


def displacing(source: Source, muscles: Mapping[str, Muscle]) -> bool:
    """Whether a source displaces the skin's vertices and needs no solve."""
    return isinstance(source, str) and displaces(muscles[source])


def action_of(source: Source, muscles: Mapping[str, Muscle], face: Face, held: HeldFace) -> FloatArray:
    """What a source does to the skin at activation 1, as `Column.action` has it."""
    if not isinstance(source, str):
        return jaw_forces(face, source, held.tissue.springs, held.tissue.anchors, held.tissue.jawbone)
    if displaces(muscles[source]):
        return muscle_action(muscles[source], face)
    return bone_forces(muscles[source], face)[held.surfaces.region.vertices]

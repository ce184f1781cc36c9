"""Solved fields with their corrections on top; solving knows nothing of them, and so keeps them."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from facemodel.basis import Basis
from facemodel.face import Face
from facemodel.project import Project
from facemodel.sculpting.correction import Correction, Corrections
from facemodel.sculpting.sampler import correction_sampler
from facemodel.solution import Solution
from fem.types import Float32Array


class Corrector:
    """Puts corrections on top of solved fields, and remembers what each of them comes to on what is drawn."""

    def __init__(self) -> None:
        self._rows: dict[str, tuple[object, Correction, tuple[Float32Array, Float32Array]]] = {}

    def __call__(self, solution: Solution, project: Project) -> Solution:
        """A solution with the corrections of a project; the very same one if there are none."""
        basis = self.basis(solution.basis, project.face, project.corrections)
        return solution if basis is solution.basis else replace(solution, basis=basis)

    def basis(self, basis: Basis, face: Face, corrections: Corrections) -> Basis:
        """A basis with corrections by field; those of fields that it does not have wait for them."""
        active = {name: each for name, each in corrections.items() if name in basis.index and _does_something(each)}
        if not active:
            self._rows = {}
            return basis
        fields, slopes = basis.fields.copy(), basis.slopes.copy()
        known, self._rows = self._rows, {}
        for name, each in active.items():
            kept = known.get(name)
            if kept is None or kept[0] is not basis.display or kept[1].moved is not each.moved:
                rows = correction_sampler(face, basis.display).rows(each.vertices, each.moved)
                kept = basis.display, each, rows
            self._rows[name] = kept
            row, share = basis.index[name], np.float32(each.share)
            fields[row] += share * kept[2][0]
            slopes[row] += share * kept[2][1]
        return replace(basis, fields=fields, slopes=slopes)


def _does_something(correction: Correction) -> bool:
    return correction.share > 0 and len(correction.vertices) > 0

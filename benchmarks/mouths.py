"""Many mixes of sliders in little time: only what is drawn about the mouth is posed, hundreds of mixes at once."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import islice

import numpy as np

from facemodel.actions import Expression
from facemodel.basis import Basis
from facemodel.contact.contact import lay_mouth, live_at_rest
from facemodel.face import Face
from facemodel.jaw.motion import jaw_motion
from facemodel.kinematics import STILL, stance_of
from fem.types import Float32Array, FloatArray

AT_ONCE = 200
"""Mixes that are summed in one product of matrices."""


class PosedMouth:
    """The mouth of a face in one mix after the other; the rest of the skin stays as it is.

    Parameters
    ----------
    face, basis : what is posed

    Attributes
    ----------
    points : (P, 3) float32, the skin of which that about the mouth is posed
    parts : rows of teeth by name
    """

    def __init__(self, face: Face, basis: Basis) -> None:
        mouth = lay_mouth(face, basis.display)
        assert mouth is not None
        self._face, self._basis = face, basis
        self._rows, self._rules = mouth
        self._rest = live_at_rest(face, basis.display)[self._rows]
        self._first = sum(count for _, count in basis.display.carried)
        self._skin = int(np.searchsorted(self._rows, self._first))
        columns = (3 * self._rows[:, None] + np.arange(3)).ravel()
        arc = () if basis.arc is None else (basis.arc.fields[:, columns],)
        self._fields: Float32Array = np.concatenate([basis.fields[:, columns], *arc])
        self.points: Float32Array = basis.display.points.astype(np.float32)
        self.parts = {part.name: part.mesh.positions.astype(np.float32) for part in face.parts if part.kind == "teeth"}

    def poses(self, mixes: Iterator[Expression]) -> Iterator[Expression]:
        """Pose the mouth in every mix, and give it when it is."""
        while some := list(islice(mixes, AT_ONCE)):
            weights = np.array([[mix.get(name, 0.0) for name in self._basis.names] for mix in some], dtype=np.float32)
            sums = (self._with_bends(weights) @ self._fields).reshape(len(some), -1, 3)
            for mix, row, moved in zip(some, weights, sums, strict=True):
                self._settle(row, self._rest + moved)
                yield mix

    def _with_bends(self, weights: Float32Array) -> Float32Array:
        arc = self._basis.arc
        return weights if arc is None else np.hstack([weights, [arc.bends(row) for row in weights]]).astype(np.float32)

    def _settle(self, weights: Float32Array, here: Float32Array) -> None:
        jaw = self._jaw(weights)
        stance = stance_of(self._face, STILL.posture(self._face, {}), jaw)
        for rule in self._rules:
            rule.move(here, stance)
        self.points[self._rows[self._skin :] - self._first] = here[self._skin :]
        for part in self._face.parts:
            if part.name in self.parts and part.carrier == "jaw":
                self.parts[part.name][:] = part.mesh.positions @ jaw[:3, :3].T + jaw[:3, 3]

    def _jaw(self, weights: Float32Array) -> FloatArray:
        degrees, slide, side = (weights.astype(np.float64) @ self._basis.jaw).tolist()
        return jaw_motion(self._face.skull.jaw, degrees, slide, side)

"""The skin follows a turning jaw along its arc: what a sum of fields lacks, in modes that were solved once."""

from __future__ import annotations

from dataclasses import dataclass
from functools import cached_property

import numpy as np

from facemodel.actions import JawMotion
from facemodel.face import Jaw
from facemodel.jaw.modes import JawMode, mode_shares, motion_of
from fem.types import BoolArray, Float32Array, FloatArray, IntArray


@dataclass(frozen=True, eq=False)
class JawArc:
    """The fields of the jaw's modes, beside the fields of a basis.

    A named field holds the whole motion of its own jaw at activation 1.  For a jaw that moves by the sum p of w_k p_k
    the sum of the fields lacks g(p) - sum of w_k g(p_k), with g from a motion of the jaw to shares of the modes; since
    the tissue is linear in how far the bone moves, adding that many modes is the full solution at every angle.

    Attributes
    ----------
    hinge : of the jaw that the modes were solved for
    motions : (M, k) motion of the jaw of every field of the basis, as `facemodel.actions.JawMotion` has it
    carried : (M,) whether the tissue carries the skin along with it
    modes : K modes
    fields, slopes : (K, 3 Q), (K, 6 S) float32, one whole share of each mode, as `facemodel.basis.Basis` has them
    """

    hinge: Jaw
    motions: FloatArray
    carried: BoolArray
    modes: tuple[JawMode, ...]
    fields: Float32Array
    slopes: Float32Array

    @cached_property
    def _turning(self) -> IntArray:
        return np.flatnonzero(self.carried & self.motions.any(axis=1))

    @cached_property
    def _named(self) -> FloatArray:
        """Shares of all modes (t, 12) in the fields whose jaw is carried."""
        motions = [JawMotion(*row) for row in self.motions[self._turning].tolist()]
        shares = [mode_shares(self.hinge, motion_of(self.hinge, motion)) for motion in motions]
        return np.array(shares).reshape(-1, 12)

    def bends(self, weights: Float32Array) -> Float32Array:
        """How much (K,) of each mode is to be added to the sum of the fields with weights (M,)."""
        active = weights[self._turning].astype(np.float64)
        if not self.modes or not active.any():
            return np.zeros(len(self.modes), dtype=np.float32)
        whole = JawMotion(*(active @ self.motions[self._turning]).tolist())
        lacking = mode_shares(self.hinge, motion_of(self.hinge, whole)) - active @ self._named
        return lacking[[mode.number for mode in self.modes]].astype(np.float32)

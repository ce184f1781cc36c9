"""Pose a face in real time: u = u_init + sum of w_k u_k (design section 7), into arrays that never move."""

from __future__ import annotations

import numpy as np

from facemodel.actions import Expression
from facemodel.basis import Basis
from facemodel.contact.contact import Contact, Untouched, contact_of
from facemodel.contact.normals import normals_of
from facemodel.display import DisplaySurface
from facemodel.face import Face
from facemodel.field_sum import FieldSum, Layer, add_field, sum_fields
from facemodel.jaw.motion import jaw_motion
from facemodel.kinematics import NO_TURN, STILL, Rig, Rigid, Stance, stance_of
from facemodel.rows import put_rows
from facemodel.sculpting.sampler import DrawnChange
from facemodel.tongue import tongue_places
from fem.types import Float32Array, FloatArray

REFRESH_AFTER = 256
"""Additions after which the sum is formed anew, so that float32 rounding cannot pile up."""


class Superposition:
    """One posed face in reused float32 buffers.

    The buffer holds the carried parts, the moving skin and the held skin one behind the other, so that one
    matrix-vector product writes the very array that is drawn.  A jaw that turns adds some modes to the fields, so that
    the skin goes along its arc; then lids and lips are kept from going through what they meet.

    Attributes
    ----------
    points : (P, 3) float32, the posed skin; always the same array
    normals : (P, 3) float32, its unit normals; always the same array
    parts : posed points (n, 3) float32 of every part of the face by its name; always the same arrays
    carried : (C, 3) float32, those of all parts that the skin carries, one after the other
    rig : what the sliders do to eyes, head and tongue
    turned : how eyes and head are turned besides; seen with the next pose
    stance : how jaw, eyes and head stand; what is drawn is the head upright, to be moved by ``stance.head``
    shifts : how many shifts lie on what is posed

    Parameters
    ----------
    face, basis : what is posed
    rig : what the sliders do to eyes and head
    linear : leave it at the pure linear sum of the fields
    contact : keep lids and lips from going through what they meet, unless it is linear
    """

    def __init__(
        self, face: Face, basis: Basis, rig: Rig = STILL, *, linear: bool = False, contact: bool = True
    ) -> None:
        display = basis.display
        self.face, self.basis, self.rig, self.linear = face, basis, rig, linear
        self.turned: Rigid = NO_TURN
        rest_of = {part.name: part.mesh.positions.astype(np.float32) for part in face.parts}
        carried = [rest_of[name] for name, _ in display.carried]
        self._buffer: Float32Array = np.concatenate([*carried, display.points]).ravel()
        self._live = basis.fields.shape[1]
        self._rest = self._buffer[: self._live].copy()
        self._slopes = display.slopes.astype(np.float32).ravel()
        self._rest_slopes = self._slopes.copy()

        first_skin = sum(count for _, count in display.carried)
        self.points: Float32Array = self._buffer.reshape(-1, 3)[first_skin:]
        self.normals: Float32Array = display.normals.astype(np.float32)
        self.carried: Float32Array = self._buffer.reshape(-1, 3)[:first_skin]
        self.parts: dict[str, Float32Array] = rest_of
        start = 0
        for name, count in display.carried:
            self.parts[name] = self.carried[start : start + count]
            start += count
        self._touches = contact
        self._contact: Contact | None = contact_of(face, display) if contact and not linear else None
        self._begin()

    @property
    def slopes(self) -> Float32Array:
        """Slopes (6, S) of the moving skin as the sum of the fields has them, see `facemodel.basis.Basis`."""
        return self._slopes.reshape(6, -1)

    @property
    def jaw(self) -> FloatArray:
        """Motion (4, 4) of the mandible within the head."""
        return self.stance.jaw

    def adopt(self, face: Face, basis: Basis, rig: Rig = STILL) -> bool:
        """Go on in the same buffers with another basis on the same drawn surface, at rest; whether that is possible.

        Parameters
        ----------
        face : the same head, perhaps painted otherwise or with another jaw
        basis : its displacement fields
        rig : what the sliders do to eyes and head
        """
        if not _drawn_alike(self.basis.display, basis.display) or self._live != basis.fields.shape[1]:
            return False
        self.face, self.basis, self.rig = face, basis, rig
        self._buffer[: self._live] = self._rest
        self._slopes[:] = self._rest_slopes
        self._begin()
        return True

    def straighten(self, linear: bool) -> None:
        """Leave it at the pure linear sum from now on, or no longer."""
        self.linear = linear
        self._contact = contact_of(self.face, self.basis.display) if self._touches and not linear else None
        self._bends = self._bends_of(self._weights)
        self.settle()

    def _begin(self) -> None:
        """Be at rest."""
        self._turning = np.flatnonzero(self.basis.jaw.any(axis=1))
        self._weights = np.zeros(len(self.basis.names), dtype=np.float32)
        self._bends = self._bends_of(self._weights)
        self._increments = self.shifts = 0
        self._untouched: Untouched = ()
        self.stance: Stance = stance_of(self.face, STILL.posture(self.face, {}), np.eye(4))
        self._turn_normals()
        self._move_jaw()

    def shift(self, change: DrawnChange) -> None:
        """Move some points by more than the fields do, as a hand that sculpts asks for.

        `settle` and `adopt` let go of it, and so does a pose for which the sum of the fields is formed anew.
        """
        self.shifts += 1
        self._lift()
        self._buffer[: self._live].reshape(-1, 3)[change.rows] += change.moved
        self.slopes[:, change.points] += change.slopes
        self._finish()

    def settle(self) -> None:
        """Form the sum of the fields anew; what they were shifted by is gone without a trace."""
        self._untouched = ()
        self._sum(self._weights, self._bends)
        self._finish()

    def pose(self, expression: Expression) -> None:
        """Write the buffers for an expression; names without a field are ignored.

        Fewer changed weights than active ones cost one scaled addition of a field each, more cost a fresh sum of
        the active fields.
        """
        weights = np.zeros_like(self._weights)
        for name, weight in expression.items():
            row = self.basis.index.get(name)
            if row is not None:
                weights[row] = weight
        posture = self.rig.posture(self.face, expression, self.turned)
        if np.array_equal(weights, self._weights) and posture == self.stance.posture:
            return
        self._lift()
        if np.array_equal(weights[self._turning], self._weights[self._turning]):
            bends, jaw = self._bends, self.jaw
        else:
            bends, jaw = self._bends_of(weights), self._jaw_of(weights)
        self._add_up(weights, bends)
        before, self.stance = self.stance, stance_of(self.face, posture, jaw)
        if jaw is not before.jaw or posture.tongue != before.posture.tongue:
            self._move_jaw()
        self._finish()

    def _bends_of(self, weights: Float32Array) -> Float32Array:
        """How much of each mode of the jaw a sum of fields lacks."""
        if self.basis.arc is None or self.linear:
            return np.zeros(0, dtype=np.float32)
        return self.basis.arc.bends(weights)

    def _add_up(self, weights: Float32Array, bends: Float32Array) -> None:
        before, now = np.concatenate([self._weights, self._bends]), np.concatenate([weights, bends])
        changed, active = np.flatnonzero(now != before), int(np.count_nonzero(now))
        if active and len(changed) < max(active, 2) and self._increments + len(changed) <= REFRESH_AFTER:
            self._increments += len(changed)
            for k in changed.tolist():
                self._add(k, float(now[k] - before[k]))
        elif len(changed):
            self._sum(weights, bends)
        self._weights, self._bends = weights, bends

    def _lift(self) -> None:
        """Put what contact has moved back to where the sum of the fields has it."""
        live = self._buffer[: self._live].reshape(-1, 3)
        for rows, before in self._untouched:
            put_rows(live, rows, before)
        self._untouched = ()

    def _finish(self) -> None:
        """Turn the normals to the slopes, and keep the skin from going through what it meets."""
        self._turn_normals()
        if self._contact is not None:
            live = self._buffer[: self._live].reshape(-1, 3)
            self._untouched = self._contact.settle(live, self.normals, self.slopes, self.stance)

    def _add(self, row: int, weight: float) -> None:
        named, arc = len(self.basis.names), self.basis.arc
        if row < named or arc is None:
            fields, slopes = self.basis.fields[row], self.basis.slopes[row]
        else:
            fields, slopes = arc.fields[row - named], arc.slopes[row - named]
        add_field(self._buffer, fields, weight)
        add_field(self._slopes, slopes, weight)

    def _sum(self, weights: Float32Array, bends: Float32Array) -> None:
        self._increments = self.shifts = 0
        live, basis, arc = self._buffer[: self._live], self.basis, self.basis.arc
        parts = [(basis.fields, basis.slopes, weights)]
        if arc is not None and bends.any():
            parts.append((arc.fields, arc.slopes, bends))
        fields, slopes = (tuple(Layer(part[k], part[2]) for part in parts) for k in (0, 1))
        sum_fields((FieldSum(live, self._rest, fields), FieldSum(self._slopes, self._rest_slopes, slopes)))

    def _turn_normals(self) -> None:
        """Normals of the moving skin as the cross product of its slopes; at rest the very ones of the display."""
        if not self._weights.any():
            self.normals[:] = self.basis.display.normals
            return
        normals_of(self.slopes, self.normals)

    def _jaw_of(self, weights: Float32Array) -> FloatArray:
        degrees, slide, side = (weights.astype(np.float64) @ self.basis.jaw).tolist()
        return jaw_motion(self.face.skull.jaw, degrees, slide, side)

    def _move_jaw(self) -> None:
        for part in self.face.parts:
            if part.carrier == "jaw":
                tongue = self.stance.posture.tongue if part.kind == "tongue" else None
                rest = tongue_places(self.face, part, tongue) if tongue else part.mesh.positions
                self.parts[part.name][:] = rest @ self.jaw[:3, :3].T + self.jaw[:3, 3]


def _drawn_alike(one: DisplaySurface, other: DisplaySurface) -> bool:
    """Whether two surfaces are drawn from the same points."""
    if one is other:
        return True
    return (
        one.carried == other.carried
        and one.moving == other.moving
        and np.array_equal(one.points, other.points)
        and np.array_equal(one.triangles, other.triangles)
    )

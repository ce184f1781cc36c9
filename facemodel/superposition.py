"""Pose a face in real time: u = u_init + sum of w_k u_k (design section 7), into arrays that never move."""

from __future__ import annotations

import numpy as np
from scipy.spatial.transform import Rotation

from facemodel.actions import Expression
from facemodel.basis import Basis
from facemodel.display import DisplaySurface
from facemodel.face import Face, Jaw
from facemodel.field_sum import add_field, sum_fields
from facemodel.glide import LidGlide
from facemodel.sculpting.sampler import DrawnChange
from fem.types import Float32Array, FloatArray

REFRESH_AFTER = 256
"""Additions after which the sum is formed anew, so that float32 rounding cannot pile up."""

SMALLEST_NORMAL = np.float32(1e-12)
"""Guards the division where a surface folds onto itself and its normal vanishes."""


def jaw_motion(jaw: Jaw, degrees: float, slide: float, side: float = 0.0) -> FloatArray:
    """Rigid motion (4, 4) of the mandible: a turn about the condylar axis, a slide forward and down, a shift aside.

    Parameters
    ----------
    jaw : the hinge
    degrees : opening
    slide : how far the condyles slide along the articular eminence, millimetres
    side : how far the lower incisors go to the subject's left, millimetres
    """
    right, left = jaw.axis
    along = (left - right) / np.linalg.norm(left - right)
    turn = Rotation.from_rotvec(np.radians(degrees) * along).as_matrix()
    motion = np.eye(4)
    motion[:3, :3] = turn
    motion[:3, 3] = right - turn @ right + slide * EMINENCE
    return aside(jaw, side, slide * EMINENCE) @ motion if side else motion


def aside(jaw: Jaw, side: float, slid: FloatArray) -> FloatArray:
    """Rigid motion (4, 4) of a mandible that goes to one side: it turns about the condyle of that side.

    The other condyle slides forward, so that the incisors go forward as well as aside, some 60 degrees off the
    midline to either side: the Gothic arch that they are known to draw.

    Parameters
    ----------
    side : of the incisors to the subject's left, millimetres
    slid : (3,) how far the condyles were brought forward before
    """
    right, left = jaw.axis
    along = (left - right) / np.linalg.norm(left - right)
    reach = jaw.teeth - right - (jaw.teeth - right) @ along * along
    length = float(np.linalg.norm(reach))
    turn = Rotation.from_rotvec(side / length * np.cross(reach / length, along)).as_matrix()
    resting = (left if side > 0 else right) + slid
    motion = np.eye(4)
    motion[:3, :3] = turn
    motion[:3, 3] = resting - turn @ resting
    return motion


EMINENCE = np.array([0.0, -0.5, np.sqrt(0.75)])
"""Unit direction in which the condyle slides: forward, 30 degrees down along the articular eminence."""


class Superposition:
    """One posed face in reused float32 buffers.

    The buffer holds the carried parts, the moving skin and the held skin one behind the other, so that one
    matrix-vector product writes the very array that is drawn; the few points of the lids are then put on the eyeballs.

    Attributes
    ----------
    points : (P, 3) float32, the posed skin; always the same array
    normals : (P, 3) float32, its unit normals; always the same array
    parts : posed points (n, 3) float32 of every part of the face by its name; always the same arrays
    jaw : (4, 4) motion of the mandible
    shifts : how many shifts lie on what is posed

    Parameters
    ----------
    face, basis : what is posed
    glide : let the lids glide on the eyeballs; without it the pose is the pure linear sum
    """

    def __init__(self, face: Face, basis: Basis, *, glide: bool = True) -> None:
        self.face = face
        self.basis = basis
        display = basis.display
        rest_of = {part.name: part.mesh.positions.astype(np.float32) for part in face.parts}
        carried = [rest_of[name] for name, _ in display.carried]
        self._buffer: Float32Array = np.concatenate([*carried, display.points]).ravel()
        self._live = basis.fields.shape[1]
        self._rest = self._buffer[: self._live].copy()
        self._slopes = display.slopes.astype(np.float32).ravel()
        self._rest_slopes = self._slopes.copy()
        self._weights = np.zeros(len(basis.names), dtype=np.float32)
        self._increments = 0
        self.shifts = 0

        first_skin = sum(count for _, count in display.carried)
        self.points: Float32Array = self._buffer.reshape(-1, 3)[first_skin:]
        self.normals: Float32Array = display.normals.astype(np.float32)
        self.parts: dict[str, Float32Array] = rest_of
        start = 0
        for name, count in display.carried:
            self.parts[name] = self._buffer.reshape(-1, 3)[start : start + count]
            start += count
        self.jaw: FloatArray = np.eye(4)
        self._glide = LidGlide(face.eyes if glide else (), self._buffer[: self._live].reshape(-1, 3))
        self._lids = self._buffer.reshape(-1, 3)[self._glide.points]
        self._lid_normals = np.zeros_like(self._lids)
        # The parts come before the skin, so the lids of the skin are the last of all lids.
        self._first_lid = int(np.searchsorted(self._glide.points, first_skin))
        self._skin_lids = self._glide.points[self._first_lid :] - first_skin

    def adopt(self, face: Face, basis: Basis) -> bool:
        """Go on in the same buffers with another basis on the same drawn surface, at rest; whether that is possible.

        Parameters
        ----------
        face : the same head, perhaps painted otherwise or with another jaw
        basis : its displacement fields
        """
        if not _drawn_alike(self.basis.display, basis.display) or self._live != basis.fields.shape[1]:
            return False
        self.face, self.basis = face, basis
        self._weights = np.zeros(len(basis.names), dtype=np.float32)
        self._increments = self.shifts = 0
        self._buffer[: self._live] = self._rest
        self._slopes[:] = self._rest_slopes
        self._lids = self._rest.reshape(-1, 3)[self._glide.points]
        self._turn_normals()
        self._turn_jaw()
        return True

    def shift(self, change: DrawnChange) -> None:
        """Move some points by more than the fields do, as a hand that sculpts asks for.

        `settle` and `adopt` let go of it, and so does a pose for which the sum of the fields is formed anew.
        """
        self.shifts += 1
        live = self._buffer[: self._live].reshape(-1, 3)
        live[self._glide.points] = self._lids
        live[change.rows] += change.moved
        self._slopes.reshape(6, -1)[:, change.points] += change.slopes
        self._finish(live)

    def settle(self) -> None:
        """Form the sum of the fields anew; what they were shifted by is gone without a trace."""
        live = self._buffer[: self._live].reshape(-1, 3)
        self._sum(self._weights)
        self._finish(live)

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
        changed = np.flatnonzero(weights != self._weights)
        if len(changed) == 0:
            return
        live = self._buffer[: self._live].reshape(-1, 3)
        live[self._glide.points] = self._lids
        active = int(np.count_nonzero(weights))
        if active and len(changed) < max(active, 2) and self._increments + len(changed) <= REFRESH_AFTER:
            self._increments += len(changed)
            for k in changed.tolist():
                self._add(k, float(weights[k] - self._weights[k]))
        else:
            self._sum(weights)
        self._weights = weights
        self._turn_jaw()
        self._finish(live)

    def _finish(self, live: Float32Array) -> None:
        """Turn the normals to the slopes, and lay the lids on the eyeballs."""
        self._turn_normals()
        self._lids = live[self._glide.points]
        live[self._glide.points] = self._glided()

    def _glided(self) -> Float32Array:
        """The lid points as they lie on the eyeballs; the normals of those on the skin turn with them."""
        on_skin = self._lid_normals[self._first_lid :]
        on_skin[:] = self.normals[self._skin_lids]
        lids = self._lids.copy()
        self._glide.push(lids, self._lid_normals)
        self.normals[self._skin_lids] = on_skin
        return lids

    def _add(self, row: int, weight: float) -> None:
        add_field(self._buffer, self.basis.fields[row], weight)
        add_field(self._slopes, self.basis.slopes[row], weight)

    def _sum(self, weights: Float32Array) -> None:
        self._increments = self.shifts = 0
        sum_fields(self._buffer[: self._live], self._rest, self.basis.fields, weights)
        sum_fields(self._slopes, self._rest_slopes, self.basis.slopes, weights)

    def _turn_normals(self) -> None:
        """Normals of the moving skin as the cross product of its slopes; at rest the very ones of the display."""
        if not self._weights.any():
            self.normals[:] = self.basis.display.normals
            return
        ux, uy, uz, vx, vy, vz = self._slopes.reshape(6, -1)
        normal = np.stack([uy * vz - uz * vy, uz * vx - ux * vz, ux * vy - uy * vx])
        normal /= np.sqrt(np.einsum("ij,ij->j", normal, normal)) + SMALLEST_NORMAL
        self.normals[: normal.shape[1]] = normal.T

    def _turn_jaw(self) -> None:
        degrees, slide, side = (self._weights.astype(np.float64) @ self.basis.jaw).tolist()
        self.jaw = jaw_motion(self.face.skull.jaw, degrees, slide, side)
        for part in self.face.parts:
            if part.carrier == "jaw":
                self.parts[part.name][:] = part.mesh.positions @ self.jaw[:3, :3].T + self.jaw[:3, 3]


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

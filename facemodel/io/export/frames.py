"""Every frame of a take as the editor poses it, in one vector for all that the skin moves."""

from __future__ import annotations

import numpy as np

from facemodel.actions import Expression
from facemodel.animation.take import Take
from facemodel.basis import Basis
from facemodel.kinematics import NO_TURN, Rigid, Stance, rig_of
from facemodel.project import Project
from facemodel.superposition import Superposition
from fem.types import Float32Array

SKIN = "skin"


class PosedFrames:
    """Poses a face; what it gives are copies.

    Attributes
    ----------
    names : the meshes that bend: the skin, the parts that it carries, and the tongue, which bends within the jaw
    rest : (3 Q,) float32, their points at rest one mesh behind the other; of the skin only those that can move

    Parameters
    ----------
    project, basis : what is posed
    """

    def __init__(self, project: Project, basis: Basis) -> None:
        self._posed = Superposition(project.face, basis, rig_of(project.units))
        self._moving = basis.display.moving
        self._carried = tuple(name for name, _ in basis.display.carried)
        tongues = [part for part in project.face.parts if part.kind == "tongue" and part.carrier == "jaw"]
        self._tongues = tuple(part.name for part in tongues)
        self.names = (SKIN, *self._carried, *self._tongues)
        counts = [self._moving, *(count for _, count in basis.display.carried)]
        counts += [len(part.mesh.positions) for part in tongues]
        ends = np.cumsum(counts)
        self._places = {
            name: slice(end - count, end) for name, count, end in zip(self.names, counts, ends.tolist(), strict=True)
        }
        self.rest = self._points()
        self._rest_normals = self._posed.normals.copy()
        self._skin = len(self._posed.points)

    def moved(self, expression: Expression, rigid: Rigid = NO_TURN) -> Float32Array:
        """How far (3 Q,) everything is moved in an expression within the head, with eyes turned so, millimetres."""
        self._posed.turned = rigid
        self._posed.pose(expression)
        return np.asarray(self._points() - self.rest)

    @property
    def normals(self) -> Float32Array:
        """How the skin's normals (P, 3) differ from rest in the expression that was posed last."""
        return np.asarray(self._posed.normals - self._rest_normals)

    @property
    def stance(self) -> Stance:
        """How jaw, eyes and head stand in the expression that was posed last."""
        return self._posed.stance

    def of(self, name: str, moved: Float32Array) -> Float32Array:
        """The part of a vector (3 Q,) that belongs to one mesh, (n, 3), the held points of the skin with it."""
        rows = moved.reshape(-1, 3)[self._places[name]]
        if name != SKIN:
            return rows
        whole = np.zeros((self._skin, 3), dtype=np.float32)
        whole[: self._moving] = rows
        return whole

    def _points(self) -> Float32Array:
        posed, back = self._posed, np.linalg.inv(self._posed.jaw)
        carried = [posed.parts[name] for name in self._carried]
        tongues = [posed.parts[name] @ back[:3, :3].T + back[:3, 3] for name in self._tongues]
        return np.concatenate([posed.points[: self._moving], *carried, *tongues]).astype(np.float32).ravel()


def sample_frames(take: Take, most: int) -> list[int]:
    """At most so many frames of a take, evenly spread, the first and the last among them."""
    return [int(frame) for frame in np.unique(np.linspace(0, len(take) - 1, min(most, len(take))).round())]

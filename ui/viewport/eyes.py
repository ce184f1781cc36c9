"""The eyes: eyeballs in the shade of their lids, under a film that mirrors the lamps."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np
from vtkmodules.vtkRenderingCore import vtkActor

from facemodel.compiled import compiled
from facemodel.eyeball import IRIS_RADIUS, EyeballMesh, Fineness, Region, eyeball
from facemodel.face import Eye
from facemodel.mesh import Mesh, submesh
from facemodel.smooth import smooth
from fem.types import Float32Array, FloatArray, IntArray
from ui.viewport.complexion import Colour
from ui.viewport.eye_picture import eye_coordinates, eye_picture
from ui.viewport.joined import Shape, joined
from ui.viewport.lids import LidLine, same_line
from ui.viewport.shading import EYE, apply, glaze
from ui.viewport.surface import Surface

UPPER_SHADE, UPPER_REACH = 0.80, 2.6
LOWER_SHADE, LOWER_REACH = 0.35, 1.0
"""How much light the lids take at their margin, and over how many millimetres that fades."""
HIDDEN = 0.35
"""Radii behind its centre from which an eyeball is inside the head."""
DRAWN = Fineness(around=48, white=9, iris=6, cornea_around=28, cornea=6)
"""A picture carries the colours, the vertices only shape and shade."""
PLICA = (0.74, 0.52, 0.49)
COLOURED = f"""
  vec3 fine = mix(texture(actortexture, tcoordVCVSOutput).rgb, vec3{PLICA}, vertexColorVSOutput.r);
  albedo = fine * fine;"""
"""GLSL that reads the picture of the eye; red of a vertex is how much it belongs to the fold in the corner."""
PLICA_NEAR, PLICA_FAR = 2.6, 5.4
"""Colour of the moist fold in the inner corner of the eye, and millimetres outwards from where the lids meet at which
it fades and at which it is gone."""
CORNER_REACH = 2.5
"""Millimetres over which the corners of the eye fall into shade."""


class EyesInLids:
    """The eyes of a face with the shade of their lids on them.

    Attributes
    ----------
    balls, films : what VTK draws; none on a face without eyes
    """

    def __init__(self, eyes: Sequence[Eye], lids: Sequence[LidLine], iris: Colour) -> None:
        self.balls: Surface | None = None
        self.films: Surface | None = None
        if not eyes:
            self._each: list[_EyeInLids] = []
            return
        made = [eyeball(eye, DRAWN) for eye in eyes]
        self.balls, balls = joined([_ball(each, eye) for each, eye in zip(made, eyes, strict=True)])
        widest = max(eye.radius for eye in eyes)
        looking = [(ball.points - eye.centre) * _mirror(eye) for ball, eye in zip(balls, eyes, strict=True)]
        self.balls.wear(eye_picture(widest, iris), eye_coordinates(np.concatenate(looking), widest))
        # The shade of the lids is on the ball already.
        apply(self.balls.actor, EYE, openness=True, detail=COLOURED, shaded=False)
        self.balls.actor.ForceOpaqueOn()
        self.balls.actor.GetProperty().BackfaceCullingOn()
        self.films, films = joined([_film(each) for each in made])
        glaze(self.films.actor)
        self._each = [_EyeInLids(*both) for both in zip(eyes, lids, balls, films, strict=True)]

    @property
    def actors(self) -> tuple[vtkActor, ...]:
        """What is drawn, the clear films last."""
        return tuple(surface.actor for surface in (self.balls, self.films) if surface is not None)

    def follow(self, motions: Sequence[FloatArray], points: Float32Array) -> None:
        """Turn each eyeball by its motion (4, 4) within the head, and shade it by the lids of the posed skin (P, 3)."""
        turned = [eye.turn(motion) for eye, motion in zip(self._each, motions, strict=True)]
        shaded = [eye.shade(points) for eye in self._each]
        if self.balls is not None and self.films is not None:
            if any(turned):
                self.balls.moved()
                self.films.moved()
            if any(shaded):
                self.balls.recoloured()


class _EyeInLids:
    """One eye; its ball and its film are written to."""

    def __init__(self, eye: Eye, lids: LidLine, ball: Shape, film: Shape) -> None:
        self._ball, self._film = ball, film
        self._rest = [(shape, shape.points.copy(), shape.normals.copy()) for shape in (ball, film)]
        self._lids = lids
        self._seen: FloatArray | None = None
        self._front = np.flatnonzero(ball.points[:, 2] > eye.centre[2])
        self._at = ball.points[self._front].astype(np.float64)
        self._nose = -1.0 if eye.side == "L" else 1.0
        self._white = smooth(np.hypot(*(self._at - eye.centre)[:, :2].T), IRIS_RADIUS + 0.5, IRIS_RADIUS + 1.5)
        self._motion = np.eye(4)

    def turn(self, motion: FloatArray) -> bool:
        """Turn it by a motion (4, 4); whether that is another one than before."""
        if np.array_equal(motion, self._motion):
            return False
        self._motion, self._seen = motion, None
        for shape, points, normals in self._rest:
            shape.points[:] = points @ motion[:3, :3].T + motion[:3, 3]
            shape.normals[:] = normals @ motion[:3, :3].T
        return True

    def shade(self, points: Float32Array) -> bool:
        """Follow the lids of the posed skin (P, 3); whether they are seen elsewhere than before."""
        colours = self._ball.colours
        if not self._lids.closed or colours is None:
            return False
        margin = self._lids.places(points)
        if self._seen is not None and same_line(margin, self._seen):
            return False
        self._seen = margin
        at = self._at @ self._motion[:3, :3].T + self._motion[:3, 3]
        beside = (margin[:, 0] * self._nose).max() - at[:, 0] * self._nose
        colours[self._front, 0] = 255 * self._white * smooth(beside, PLICA_FAR, PLICA_NEAR)
        colours[self._front, 3] = np.clip(255 * lid_light(at, margin), 0, 255)
        return True


def _mirror(eye: Eye) -> FloatArray:
    """What makes a left eye of either."""
    return np.array([1.0 if eye.side == "L" else -1.0, 1.0, 1.0])


def _ball(made: EyeballMesh, eye: Eye) -> Shape:
    """What can be seen of the opaque ball, in full light and nowhere a fold."""
    mesh, index = _front(made, eye)
    points, normals = mesh.positions.astype(np.float32), made.normals[index].astype(np.float32)
    colours = np.zeros((len(points), 4), dtype=np.uint8)
    colours[:, 3] = 255
    return Shape(points, normals, mesh.triangles, colours)


def _film(made: EyeballMesh) -> Shape:
    shell, index = made.cornea
    return Shape(shell.positions.astype(np.float32), made.normals[index].astype(np.float32), shell.triangles)


def _front(made: EyeballMesh, eye: Eye) -> tuple[Mesh, IntArray]:
    """What can be seen of the opaque ball, and the index of each of its vertices in the whole."""
    behind = made.mesh.positions[:, 2] < eye.centre[2] - HIDDEN * eye.radius
    return submesh(made.mesh, (made.regions != Region.CORNEA) & ~behind[made.mesh.triangles].all(axis=1))


def lid_light(places: FloatArray, margin: FloatArray) -> FloatArray:
    """Share (n,) of the light that the lids let through to places on the front of an eyeball.

    Parameters
    ----------
    places : (n, 3)
    margin : (m, 3) the lid margin as a closed loop
    """
    inner, outer = margin[margin[:, 0].argmin()], margin[margin[:, 0].argmax()]
    share = (margin[:, 0] - inner[0]) / (outer[0] - inner[0])
    over = margin[:, 1] >= inner[1] + share * (outer[1] - inner[1])
    below = _height(margin[over], places[:, 0]) - places[:, 1]
    above = places[:, 1] - _height(margin[~over], places[:, 0])
    inside = np.minimum(places[:, 0] - inner[0], outer[0] - places[:, 0])
    return _shaded(below, above, inside)


@compiled
def _shaded(below: FloatArray, above: FloatArray, inside: FloatArray) -> FloatArray:
    """The light (n,) so many millimetres below the upper lid, above the lower one and inside of the corners."""
    light = np.empty(len(below))
    for i in range(len(below)):
        upper = 1 - UPPER_SHADE * np.exp(-((max(below[i], 0.0) / UPPER_REACH) ** 1.3))
        lower = 1 - LOWER_SHADE * np.exp(-max(above[i], 0.0) / LOWER_REACH)
        light[i] = upper * lower * (1 - 0.6 * np.exp(-max(inside[i], 0.0) / CORNER_REACH))
    return light


def _height(lid: FloatArray, x: FloatArray) -> FloatArray:
    order = np.argsort(lid[:, 0])
    return np.interp(x, lid[order, 0], lid[order, 1])

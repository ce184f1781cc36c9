"""What the pointer is over, as tools understand it: places of the face at rest, however it is posed on the screen."""

from __future__ import annotations

from collections.abc import Iterable

import numpy as np
from vtkmodules.vtkRenderingCore import vtkRenderer

from app.tools.pointer import Hit, Modifier, Pointer, Ray, skin_hit, skull_hit
from facemodel.display import DisplaySurface
from facemodel.face import Face
from facemodel.laying.places import Bone
from facemodel.painting.regions import unhidden
from fem.types import BoolArray, Float32Array, FloatArray
from ui.viewport.overlays.overlay import Drawn
from ui.viewport.overlays.supports import points_of_vertices
from ui.viewport.pick import Hit as DrawnHit
from ui.viewport.pick import first_hit, ray_through
from ui.viewport.scene import Scene

TIP = 6.0
"""Pixels that the tip of the pointer covers."""

CELL = 6
"""Pixels of a cell in the coarse picture of depths that tells what hides what; more than between two drawn points."""

SLACK = 4.0
"""Millimetres by which a vertex may lie behind what is drawn in its cell: the slope of the skin within one."""


def place_at_rest(face: Face, display: DisplaySurface, hit: DrawnHit) -> tuple[int, FloatArray]:
    """The triangle of the skin's own mesh, and the place (3,) in it, of a place on the drawn skin."""
    element = hit.triangle // display.density**2
    points = display.triangles[hit.triangle]
    vertices = face.skin.triangles[display.elements[points]]
    shares = hit.barycentric[:, None] * display.barycentric[points]
    inside = np.array([shares[vertices == corner].sum() for corner in face.skin.triangles[element]])
    return element, inside / inside.sum()


class ToolSight:
    """Sees a scene for tools.

    Parameters
    ----------
    scene : what is drawn
    """

    def __init__(self, scene: Scene) -> None:
        self._scene = scene
        self.scale = 1.0
        """Pixels of the picture in one of the window."""

    def pointer(
        self,
        x: float,
        y: float,
        modifiers: Iterable[Modifier] = (),
        pressure: float = 1.0,
        asks_skull: bool = False,
    ) -> Pointer:
        """The pointer at a point of the viewport, in pixels of the window from its upper left corner."""
        held = frozenset(modifiers)
        drawn = self._scene.drawn
        if drawn is None:
            return Pointer(x, y, modifiers=held, pressure=pressure)
        column, row = self._in_picture(x, y)
        ray = Ray(*ray_through(self._scene.renderer, column, row))
        hit = self._scene.pick(column, row)
        skin = None if hit is None else skin_hit(drawn.project.face, *self._at_rest(drawn, hit))
        skull = self._bone(drawn, ray) if asks_skull else None
        reach = TIP * self.millimetres(None if hit is None else hit.place)
        return Pointer(x, y, skin, skull, ray, reach, held, pressure)

    def millimetres(self, place: FloatArray | None = None) -> float:
        """Width of a pixel of the window at a place (3,), or at what the camera looks at."""
        camera = self._scene.renderer.GetActiveCamera()
        height = max(1, self._scene.renderer.GetSize()[1])
        if camera.GetParallelProjection():
            return float(2 * camera.GetParallelScale() / height * self.scale)
        at = np.array(camera.GetFocalPoint()) if place is None else place
        away = float((at - np.array(camera.GetPosition())) @ np.array(camera.GetDirectionOfProjection()))
        return float(2 * away * np.tan(np.radians(camera.GetViewAngle() / 2)) / height * self.scale)

    def skin_on_screen(self) -> tuple[FloatArray, BoolArray]:
        """Pixels (N, 2) of every skin vertex as it is posed, and whether (N,) it can be seen."""
        drawn = self._scene.drawn
        if drawn is None:
            return np.zeros((0, 2)), np.zeros(0, dtype=np.bool_)
        posed = drawn.figure.posed
        screen, depth = self._projected(posed.points)
        vertices = points_of_vertices(drawn.project.face, posed.basis.display)
        nearest = self._depths(screen, depth)
        seen = unhidden(screen[vertices] / CELL, depth[vertices], nearest, SLACK)
        eye = np.array(self._scene.renderer.GetActiveCamera().GetPosition())
        towards = eye - posed.points[vertices]
        facing = np.einsum("ij,ij->i", towards, posed.normals[vertices]) > 0
        return screen[vertices] / self.scale, seen & facing

    def _in_picture(self, x: float, y: float) -> tuple[float, float]:
        return x * self.scale, self._scene.renderer.GetSize()[1] - 1 - y * self.scale

    def _at_rest(self, drawn: Drawn, hit: DrawnHit) -> tuple[int, FloatArray]:
        return place_at_rest(drawn.project.face, drawn.figure.posed.basis.display, hit)

    def _bone(self, drawn: Drawn, ray: Ray) -> Hit | None:
        """The first bone that a line of sight meets; the mandible where the jaw has turned it to."""
        skull, jaw = drawn.project.face.skull, drawn.figure.posed.jaw
        back = np.linalg.inv(jaw)
        turned = back[:3, :3] @ ray.origin + back[:3, 3], back[:3, :3] @ ray.along
        lines = {"cranium": (ray.origin, ray.along), "mandible": turned}
        found: list[tuple[float, Hit]] = []
        bones: tuple[Bone, ...] = ("cranium", "mandible")
        for bone in bones:
            mesh = skull.cranium if bone == "cranium" else skull.mandible
            hit = first_hit(mesh.positions.astype(np.float32), mesh.triangles, *lines[bone])
            if hit is not None:
                away = float(np.linalg.norm(hit.place - lines[bone][0]))
                found.append((away, skull_hit(drawn.project.face, bone, hit.triangle, hit.barycentric)))
        return min(found, key=lambda each: each[0])[1] if found else None

    def _projected(self, points: Float32Array) -> tuple[FloatArray, FloatArray]:
        """Pixels (P, 2) of the picture from its upper left corner, and distances (P,) from the eye in millimetres."""
        renderer = self._scene.renderer
        camera, (width, height) = renderer.GetActiveCamera(), renderer.GetSize()
        matrix = _matrix(renderer)
        clip = np.column_stack([points, np.ones(len(points))]) @ matrix.T
        there = clip[:, :2] / clip[:, 3:]
        screen = np.column_stack([(there[:, 0] + 1) / 2 * width, (1 - there[:, 1]) / 2 * height])
        depth = (points - np.array(camera.GetPosition())) @ np.array(camera.GetDirectionOfProjection())
        return screen, depth

    def _depths(self, screen: FloatArray, depth: FloatArray) -> FloatArray:
        """The nearest drawn point (H, W) of every cell of the picture; infinite where there is none."""
        width, height = self._scene.renderer.GetSize()
        cells = np.full((height // CELL + 1, width // CELL + 1), np.inf)
        column, row = np.floor(screen / CELL).astype(np.int64).T
        inside = (column >= 0) & (column < cells.shape[1]) & (row >= 0) & (row < cells.shape[0])
        np.minimum.at(cells, (row[inside], column[inside]), depth[inside])
        return cells


def _matrix(renderer: vtkRenderer) -> FloatArray:
    """From millimetres to the cube of the picture, (4, 4)."""
    matrix = renderer.GetActiveCamera().GetCompositeProjectionTransformMatrix(renderer.GetTiledAspectRatio(), -1, 1)
    return np.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])

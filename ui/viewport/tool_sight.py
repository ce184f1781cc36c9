"""What the pointer is over, as tools understand it: places of the face at rest, however it is posed on the screen."""

from __future__ import annotations

from collections.abc import Iterable
from functools import lru_cache

import igl
import numpy as np
from vtkmodules.vtkRenderingCore import vtkRenderer

from app.tools.pointer import Hit, Modifier, Pointer, Ray, skin_hit, skull_hit
from facemodel.display import DisplaySurface
from facemodel.face import Face
from facemodel.laying.places import Bone
from facemodel.mesh import Mesh
from facemodel.skull.jaw_region import whole_skull
from facemodel.skull.placement import carried
from fem.types import BoolArray, FloatArray, IntArray
from ui.viewport.overlays.overlay import Drawn
from ui.viewport.overlays.supports import points_of_vertices
from ui.viewport.pick import Hit as DrawnHit
from ui.viewport.pick import first_hit
from ui.viewport.scene import Scene

TIP = 6.0
"""Pixels that the tip of the pointer covers."""

CLEAR = 0.3
"""Millimetres by which a line of sight begins above the skin, so that it does not end where it begins."""


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
        self._known: tuple[Drawn, igl.AABB, tuple[FloatArray, IntArray]] | None = None

    def pointer(
        self,
        x: float,
        y: float,
        modifiers: Iterable[Modifier] = (),
        pressure: float = 1.0,
        asks_skull: bool = False,
        asks_skin: bool = True,
    ) -> Pointer:
        """The pointer at a point of the viewport, in pixels of the window from its upper left corner."""
        held = frozenset(modifiers)
        drawn = self._scene.drawn
        if drawn is None:
            return Pointer(x, y, modifiers=held, pressure=pressure)
        column, row = self._in_picture(x, y)
        ray = Ray(*self._scene.ray(column, row))
        hit = (self._first(drawn, ray) or self._scene.pick(column, row)) if asks_skin else None
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
        at = np.array(camera.GetFocalPoint()) if place is None else self._scene.mount.outside(place)
        away = float((at - np.array(camera.GetPosition())) @ np.array(camera.GetDirectionOfProjection()))
        return float(2 * away * np.tan(np.radians(camera.GetViewAngle() / 2)) / height * self.scale)

    def towards(self, place: FloatArray) -> FloatArray:
        """The unit direction (3,) from a place (3,) to the eye."""
        way = self._towards_eye(place[None])[0]
        return np.asarray(way / np.linalg.norm(way))

    def skin_on_screen(self) -> tuple[FloatArray, BoolArray]:
        """Pixels (N, 2) of every skin vertex as it is posed, and whether (N,) it can be seen."""
        drawn = self._scene.drawn
        if drawn is None:
            return np.zeros((0, 2)), np.zeros(0, dtype=np.bool_)
        posed = drawn.figure.posed
        vertices = points_of_vertices(drawn.project.face, posed.basis.display)
        places = posed.points[vertices].astype(np.float64)
        normals = posed.normals[vertices].astype(np.float64)
        towards = self._towards_eye(places)
        seen = np.einsum("ij,ij->i", towards, normals) > 0
        tree, mesh = self._tree(drawn)
        lines = np.flatnonzero(seen)
        starts = places[lines] + CLEAR * normals[lines]
        met, _, _ = tree.intersect_ray_first(*mesh, starts, np.ascontiguousarray(towards[lines]))
        seen[lines] = met < 0
        return self._on_screen(places) / self.scale, seen

    def bone_on_screen(self) -> tuple[FloatArray, BoolArray]:
        """Pixels (M, 2) of every vertex of the whole skull as it is drawn, and whether (M,) no bone hides it."""
        drawn = self._scene.drawn
        if drawn is None:
            return np.zeros((0, 2)), np.zeros(0, dtype=np.bool_)
        whole = whole_skull(drawn.project.face.skull)
        lone = whole.jaw & ~whole.shared
        jaw = self._scene.skull.jaw(drawn)
        places = np.where(lone[:, None], carried(whole.mesh.positions, jaw), whole.mesh.positions)
        posed = whole.mesh.moved(places)
        towards = self._towards_eye(places)
        seen = np.einsum("ij,ij->i", towards, posed.normals) > 0
        tree = igl.AABB()
        tree.init(posed.positions, posed.triangles)
        lines = np.flatnonzero(seen)
        starts = places[lines] + CLEAR * posed.normals[lines]
        met, _, _ = tree.intersect_ray_first(
            posed.positions, posed.triangles, starts, np.ascontiguousarray(towards[lines])
        )
        seen[lines] = np.asarray(met) < 0
        return self._on_screen(places) / self.scale, seen

    def _tree(self, drawn: Drawn) -> tuple[igl.AABB, tuple[FloatArray, IntArray]]:
        """The skin as it is posed now, ready to be met by lines of sight; made once for every pose."""
        if self._known is None or self._known[0] is not drawn:
            mesh = drawn.figure.posed.points.astype(np.float64), drawn.figure.posed.basis.display.triangles
            tree = igl.AABB()
            tree.init(*mesh)
            self._known = drawn, tree, mesh
        return self._known[1], self._known[2]

    def _first(self, drawn: Drawn, ray: Ray) -> DrawnHit | None:
        """What a line of sight meets first, if it meets it from outside."""
        tree, mesh = self._tree(drawn)
        return _met(tree, *mesh, ray.origin, ray.along)

    def _in_picture(self, x: float, y: float) -> tuple[float, float]:
        return x * self.scale, self._scene.renderer.GetSize()[1] - 1 - y * self.scale

    def _at_rest(self, drawn: Drawn, hit: DrawnHit) -> tuple[int, FloatArray]:
        return place_at_rest(drawn.project.face, drawn.figure.posed.basis.display, hit)

    def _bone(self, drawn: Drawn, ray: Ray) -> Hit | None:
        """The first bone that a line of sight meets; the mandible where the jaw has turned it to."""
        skull, jaw = drawn.project.face.skull, self._scene.skull.jaw(drawn)
        back = np.linalg.inv(jaw)
        turned = back[:3, :3] @ ray.origin + back[:3, 3], back[:3, :3] @ ray.along
        lines = {"cranium": (ray.origin, ray.along), "mandible": turned}
        found: list[tuple[float, Hit]] = []
        bones: tuple[Bone, ...] = ("cranium", "mandible")
        for bone in bones:
            mesh = skull.cranium if bone == "cranium" else skull.mandible
            hit = _first_of(mesh, *lines[bone])
            if hit is not None:
                away = float(np.linalg.norm(hit.place - lines[bone][0]))
                found.append((away, skull_hit(drawn.project.face, bone, hit.triangle, hit.barycentric)))
        return min(found, key=lambda each: each[0])[1] if found else None

    def _towards_eye(self, places: FloatArray) -> FloatArray:
        """Ways (N, 3) from places to the eye, however long."""
        camera = self._scene.renderer.GetActiveCamera()
        if camera.GetParallelProjection():
            away = -np.array(camera.GetDirectionOfProjection())
            return np.broadcast_to(self._scene.mount.inwards(away), places.shape)
        return self._scene.mount.inside(np.array(camera.GetPosition())) - places

    def _on_screen(self, places: FloatArray) -> FloatArray:
        """Pixels (N, 2) of the picture from its upper left corner."""
        renderer = self._scene.renderer
        width, height = renderer.GetSize()
        clip = np.column_stack([self._scene.mount.outside(places), np.ones(len(places))]) @ _matrix(renderer).T
        there = clip[:, :2] / clip[:, 3:]
        return np.column_stack([(there[:, 0] + 1) / 2 * width, (1 - there[:, 1]) / 2 * height])


def _met(
    tree: igl.AABB, points: FloatArray, triangles: IntArray, origin: FloatArray, along: FloatArray
) -> DrawnHit | None:
    """What a line of sight meets first, if it meets it from outside."""
    met, _, shares = tree.intersect_ray_first(points, triangles, origin[None], along[None])
    triangle = int(met[0])
    if triangle < 0:
        return None
    a, b, c = points[triangles[triangle]]
    if np.cross(b - a, c - a) @ along >= 0:
        return None
    share = np.array([1 - shares[0, 0] - shares[0, 1], shares[0, 0], shares[0, 1]])
    return DrawnHit(triangle, share, share @ np.array([a, b, c]), int(triangles[triangle, share.argmax()]))


def _first_of(mesh: Mesh, origin: FloatArray, along: FloatArray) -> DrawnHit | None:
    """The first place of a bone from outside; where a line begins within it or meets an open edge, of all triangles."""
    if not len(mesh.triangles):
        return None
    hit = _met(_bone_tree(mesh), mesh.positions, mesh.triangles, origin, along)
    return hit or first_hit(mesh.positions.astype(np.float32), mesh.triangles, origin, along)


@lru_cache(maxsize=4)
def _bone_tree(mesh: Mesh) -> igl.AABB:
    tree = igl.AABB()
    tree.init(mesh.positions, mesh.triangles)
    return tree


def _matrix(renderer: vtkRenderer) -> FloatArray:
    """From millimetres to the cube of the picture, (4, 4)."""
    matrix = renderer.GetActiveCamera().GetCompositeProjectionTransformMatrix(renderer.GetTiledAspectRatio(), -1, 1)
    return np.array([[matrix.GetElement(i, j) for j in range(4)] for i in range(4)])

"""The skin: drawn straight out of the arrays that the superposition writes."""

from __future__ import annotations

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import VTK_FLOAT, vtkDataArray
from vtkmodules.vtkCommonDataModel import vtkDataObject

from facemodel.display import DisplaySurface
from facemodel.superposition import Superposition
from fem.types import Float32Array, FloatArray
from ui.viewport.complexion import Palette
from ui.viewport.folding import FOLDS, Folding
from ui.viewport.look import Look, at_points, bytes_of
from ui.viewport.neck import NeckCut
from ui.viewport.shading import SKIN, Ghost, apply
from ui.viewport.surface import ByteArray, Surface, shared

PAINT = "paint"

DEEP = 0.8
"""Millimetres that a furrow is deep in a face that folds as far as it can."""
SHADED = 0.45
"""Share of the light that the bottom of such a furrow lacks."""
SEEN = 0.01
"""Millimetres by which the rim of the neck has to move to be drawn anew; it stands nearly still in most poses."""


class Skin:
    """The skin of a posed face.

    Attributes
    ----------
    surface : what VTK draws; its points and normals are those of the superposition
    triangles : (t, 3) those of the drawn skin that lie above the cut of the neck
    hem : the strip along the cut, if there is one
    """

    def __init__(self, posed: Superposition, look: Look, cut: NeckCut | None) -> None:
        face, display = posed.face, posed.basis.display
        colours = bytes_of(
            np.column_stack([at_points(face, display, look.colours), at_points(face, display, look.open)])
        )
        self.triangles = display.triangles if cut is None else display.triangles[cut.kept]
        self.surface = Surface(posed.points, posed.normals, self.triangles, colours)
        self._detail = "" if look.detail is None else _detail_of(look.palette)
        if look.detail is not None:
            self.surface.wear(look.detail.image, at_points(face, display, look.detail.coordinates))
        self._folding = None if look.furrows is None else Folding(posed, look.furrows)
        if self._folding is not None:
            _give(self.surface, "fold", FOLDS, shared(self._folding.depth, VTK_FLOAT))
        self.hem = None if cut is None else _hem(cut, display, colours)
        self._cut = cut
        self._ghost = Ghost.SOLID
        self._painted = False
        self._dress()

    def moved(self) -> None:
        """Tell VTK that points and normals were written; the strip along the cut goes along."""
        if self._folding is not None and self._folding.follow():
            self.surface.data.GetPointData().GetArray(FOLDS).Modified()
        self.surface.moved()
        if self.hem is None or self._cut is None:
            return
        places = self._cut.of(self.surface.points)
        if np.abs(places - self.hem.points).max() > SEEN:
            self.hem.points[:] = places
            self.hem.normals[:] = self._cut.of(self.surface.normals)
            self.hem.moved()

    def paint(self, colours: Float32Array | None) -> None:
        """Lay colours (P, 4) over the skin, sRGB and how much of it they cover, 0..1; None takes them off."""
        if colours is None and not self._painted:
            return
        fresh = (colours is not None) != self._painted
        self._painted = colours is not None
        _lay(self.surface, colours)
        if self.hem is not None and self._cut is not None:
            _lay(self.hem, None if colours is None else self._cut.of(colours))
        if fresh:
            self._dress()

    def ghost(self, ghost: Ghost) -> None:
        """Make the skin solid, or let what lies behind it shine through."""
        if ghost is not self._ghost:
            self._ghost = ghost
            self._dress()

    def _dress(self) -> None:
        solid = self._ghost is Ghost.SOLID
        over = "\n  albedo = mix(albedo, paintVSOutput.rgb * paintVSOutput.rgb, paintVSOutput.a);"
        paint = ("paint",) if self._painted else ()
        fold = () if self._folding is None else ("fold",)
        for surface, detail, carried in ((self.surface, self._detail, (*paint, *fold)), (self.hem, "", paint)):
            if surface is None:
                continue
            surface.actor.SetForceOpaque(solid)
            surface.actor.SetForceTranslucent(not solid)
            surface.actor.GetProperty().BackfaceCullingOn()
            glsl = detail + over if self._painted else detail
            apply(surface.actor, SKIN, openness=True, detail=glsl, ghost=self._ghost, carried=carried)


def _hem(cut: NeckCut, display: DisplaySurface, colours: ByteArray) -> Surface:
    """The strip along the cut of the neck."""
    return Surface(
        cut.of(display.points).astype(np.float32),
        cut.of(display.normals).astype(np.float32),
        cut.strip,
        np.ascontiguousarray(cut.of(colours), dtype=np.uint8),
    )


def _lay(surface: Surface, colours: FloatArray | Float32Array | None) -> None:
    """Give a surface colours (n, 4) as the vertex attribute that painted materials read, or take them away."""
    surface.data.GetPointData().RemoveArray(PAINT)
    surface.mapper.RemoveVertexAttributeMapping("paintMC")
    if colours is not None:
        layer = np.ascontiguousarray(colours, dtype=np.float32)
        _give(surface, "paint", PAINT, numpy_to_vtk(layer, deep=True, array_type=VTK_FLOAT))
    surface.data.Modified()


def _give(surface: Surface, attribute: str, name: str, array: vtkDataArray) -> None:
    """Give the points of a surface values as a vertex attribute, under a name."""
    array.SetName(name)
    surface.data.GetPointData().AddArray(array)
    surface.mapper.MapDataArrayToVertexAttribute(f"{attribute}MC", name, vtkDataObject.FIELD_ASSOCIATION_POINTS, -1)


def _detail_of(palette: Palette) -> str:
    """GLSL that reads the picture which `ui.viewport.detail` paints."""
    red, green, blue = (c * c for c in palette.hair)
    return f"""
  vec4 fine = texture(actortexture, tcoordVCVSOutput);
  albedo *= 0.5 + fine.g;
  gloss = (0.4 + 1.2 * fine.b) * (1.0 - 0.8 * fine.r);
  albedo = mix(albedo, vec3({red:.4f}, {green:.4f}, {blue:.4f}), fine.r);
  float furrow = fine.a * foldVSOutput;
  float pixel = max(dFdx(vertexVC.x), 1e-6);
  n = normalize(n + vec3(dFdx(furrow), dFdy(furrow), 0.0) * ({DEEP:.3f} / pixel));
  open *= 1.0 - {SHADED:.3f} * furrow;"""

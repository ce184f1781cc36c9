"""The skin: drawn straight out of the arrays that the superposition writes."""

from __future__ import annotations

import numpy as np
from vtkmodules.util.numpy_support import numpy_to_vtk
from vtkmodules.vtkCommonCore import VTK_FLOAT
from vtkmodules.vtkCommonDataModel import vtkDataObject

from facemodel.superposition import Superposition
from fem.types import Float32Array
from ui.viewport.complexion import Palette
from ui.viewport.look import Look, at_points, bytes_of
from ui.viewport.shading import SKIN, Ghost, apply
from ui.viewport.surface import Surface

PAINT = "paint"


class Skin:
    """The skin of a posed face.

    Attributes
    ----------
    surface : what VTK draws; its points and normals are those of the superposition
    """

    def __init__(self, posed: Superposition, look: Look) -> None:
        face, display = posed.face, posed.basis.display
        colours = np.column_stack([at_points(face, display, look.colours), at_points(face, display, look.open)])
        self.surface = Surface(posed.points, posed.normals, display.triangles, bytes_of(colours))
        self._detail = "" if look.detail is None else _detail_of(look.palette)
        if look.detail is not None:
            self.surface.wear(look.detail.image, at_points(face, display, look.detail.coordinates))
        self._ghost = Ghost.SOLID
        self._paint: Float32Array | None = None
        self._dress()

    def paint(self, colours: Float32Array | None) -> None:
        """Lay colours (P, 4) over the skin, sRGB and how much of it they cover, 0..1; None takes them off."""
        data, mapper = self.surface.data.GetPointData(), self.surface.mapper
        fresh = (colours is None) != (self._paint is None)
        self._paint = colours
        data.RemoveArray(PAINT)
        if colours is not None:
            layer = numpy_to_vtk(np.ascontiguousarray(colours, dtype=np.float32), deep=True, array_type=VTK_FLOAT)
            layer.SetName(PAINT)
            data.AddArray(layer)
        if fresh:
            mapper.RemoveAllVertexAttributeMappings()
            if colours is not None:
                points = vtkDataObject.FIELD_ASSOCIATION_POINTS
                mapper.MapDataArrayToVertexAttribute("paintMC", PAINT, points, -1)
            self._dress()
        self.surface.data.Modified()

    def ghost(self, ghost: Ghost) -> None:
        """Make the skin solid, or let what lies behind it shine through."""
        if ghost is not self._ghost:
            self._ghost = ghost
            self._dress()

    def _dress(self) -> None:
        actor = self.surface.actor
        solid = self._ghost is Ghost.SOLID
        actor.SetForceOpaque(solid)
        actor.SetForceTranslucent(not solid)
        actor.GetProperty().SetBackfaceCulling(not solid)
        detail = self._detail
        if self._paint is not None:
            detail += "\n  albedo = mix(albedo, paintVSOutput.rgb * paintVSOutput.rgb, paintVSOutput.a);"
        apply(actor, SKIN, openness=True, detail=detail, ghost=self._ghost, painted=self._paint is not None)


def _detail_of(palette: Palette) -> str:
    """GLSL that reads the picture which `ui.viewport.detail` paints."""
    red, green, blue = (c * c for c in palette.hair)
    return f"""
  vec3 fine = texture(actortexture, tcoordVCVSOutput).rgb;
  albedo *= 0.5 + fine.g;
  gloss = (0.4 + 1.2 * fine.b) * (1.0 - 0.8 * fine.r);
  albedo = mix(albedo, vec3({red:.4f}, {green:.4f}, {blue:.4f}), fine.r);"""

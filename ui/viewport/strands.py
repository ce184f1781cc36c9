"""Hairs as ribbons that face the camera and cover of a pixel no more than their own width.

A hair is thinner than a pixel from most places.  Drawn as a solid ribbon it would meet the middle of some pixels by
chance and fill these, which is seen as dots wherever there is one sample per pixel.  Here the ribbon has a margin of
about a pixel on either side, and each pixel is covered by as much of the hair as lies in it.
"""

from __future__ import annotations

from vtkmodules.vtkCommonCore import VTK_FLOAT
from vtkmodules.vtkCommonDataModel import vtkDataObject

from fem.types import Float32Array
from ui.viewport.shading import Ghost, Material, apply
from ui.viewport.surface import Surface, shared

STRAND = "strand"
"""Name of the array of points that says where a hair leads and how wide it is."""

MARGIN = 0.0006
"""Beside a hair, in its distance from the camera: about a pixel of a picture that is a thousand pixels high."""

UNSCALED = 0
"""VTK's vtkOpenGLVertexBufferObject::DISABLE_SHIFT_SCALE, which its Python does not name."""

DECLARED = """//VTK::PositionVC::Dec
in vec4 strandMC;
out vec2 strandVSOutput;"""

SPREAD = f"""//VTK::PositionVC::Impl
  float strandHalf = abs(strandMC.w);
  float strandReach = sign(strandMC.w) * (strandHalf + {MARGIN} * length(vertexVCVSOutput.xyz));
  mat3 strandTurn = mat3(MCVCMatrix);
  vec3 strandAside = cross(strandTurn * strandMC.xyz, vertexVCVSOutput.xyz);
  vec3 strandStep = strandReach * strandAside / max(length(strandAside), 1e-9);
  vertexVCVSOutput.xyz += strandStep;
  gl_Position += MCDCMatrix * vec4(transpose(strandTurn) * strandStep, 0.0);
  strandVSOutput = vec2(strandReach, strandHalf);"""

COVERED = """
in vec2 strandVSOutput;
float strandCover()
{
  float off = abs(strandVSOutput.x), half_ = strandVSOutput.y;
  float pixel = max(length(vec2(dFdx(strandVSOutput.x), dFdy(strandVSOutput.x))), 1e-9);
  return clamp((min(half_, off + 0.5 * pixel) - max(-half_, off - 0.5 * pixel)) / pixel, 0.0, 1.0);
}
"""


def spread(surface: Surface, strands: Float32Array, material: Material) -> None:
    """Draw a surface as hairs.

    Parameters
    ----------
    surface : whose points lie on the middles of hairs, two at each place, joined to ribbons
    strands : (n, 4) where the hair leads at each point, a unit vector, and half its width, negative at one of the two
        points of a place; it is shared: write into it, then call ``surface.moved``
    material : how hair takes light
    """
    array = shared(strands, VTK_FLOAT)
    array.SetName(STRAND)
    surface.data.GetPointData().AddArray(array)
    surface.mapper.MapDataArrayToVertexAttribute("strandMC", STRAND, vtkDataObject.FIELD_ASSOCIATION_POINTS, -1)
    # Millimetres stay millimetres in the shader; VTK would stretch what is larger than some three centimetres.
    surface.mapper.SetVBOShiftScaleMethod(UNSCALED)
    surface.actor.ForceTranslucentOn()
    apply(surface.actor, material, ghost=Ghost.STRAND)
    shader = surface.actor.GetShaderProperty()
    shader.AddVertexShaderReplacement("//VTK::PositionVC::Dec", True, DECLARED, False)
    shader.AddVertexShaderReplacement("//VTK::PositionVC::Impl", True, SPREAD, False)
    shader.AddFragmentShaderReplacement("//VTK::Normal::Dec", True, "//VTK::Normal::Dec\n" + COVERED, False)

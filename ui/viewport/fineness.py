"""What each quality of drawing means to VTK: samples per pixel, pixels per point of the screen, shade where skin is
near to skin.
"""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

from vtkmodules.vtkRenderingCore import vtkFXAAOptions, vtkRenderer, vtkRenderPass
from vtkmodules.vtkRenderingOpenGL2 import (
    vtkCameraPass,
    vtkLightsPass,
    vtkOpaquePass,
    vtkOpenGLFXAAPass,
    vtkOverlayPass,
    vtkRenderPassCollection,
    vtkSequencePass,
    vtkSSAOPass,
    vtkTranslucentPass,
)

from app.quality import Level

SAMPLES = 4
"""Samples per pixel that smooth the edges; more are not seen on skin."""

REACH = 12.0
"""Millimetres around a place within which the occlusion pass looks for what keeps light away: a nose, a lip, a lid."""
LIFT = 0.7
"""Millimetres by which something has to stand before a place to count, so that a curved skin does not shade itself."""
STRENGTH = 0.6
"""Share of that shade which is laid over the picture: the skin has its resting shade already."""
PROBES = 32
"""Places that are looked at around each pixel; with fewer the shade is blotchy."""


@dataclass(frozen=True)
class Fineness:
    """How finely a picture is drawn.

    Attributes
    ----------
    samples : per pixel at the edges of surfaces
    share : pixels that are drawn over those that are shown, per side
    occlusion : whether what is near to each other shades each other as it is posed
    """

    samples: int
    share: float
    occlusion: bool


FINENESS: Mapping[Level, Fineness] = {
    "fast": Fineness(samples=0, share=0.7, occlusion=False),
    "balanced": Fineness(samples=SAMPLES, share=1.0, occlusion=False),
    "full": Fineness(samples=0, share=1.0, occlusion=True),
}
"""The occlusion pass draws into pictures of its own, of one sample per pixel: there edges are smoothed after."""


def fineness_of(level: Level, thin_lines: bool) -> Fineness:
    """How finely a picture is drawn at a level, with lines of a pixel's width in it or without.

    Such lines need samples, which is why they are drawn without occlusion: smoothed after, they fall into dashes.
    """
    fineness = FINENESS[level]
    return FINENESS["balanced"] if thin_lines and fineness.occlusion else fineness


class Occlusion:
    """Ambient occlusion in the picture: the shade that the pose makes, over that which is baked into the resting skin.

    Parameters
    ----------
    renderer : whose picture it is
    """

    def __init__(self, renderer: vtkRenderer) -> None:
        self._renderer = renderer
        self._used = False
        shade = vtkSSAOPass()
        shade.SetRadius(REACH)
        shade.SetBias(LIFT)
        shade.SetKernelSize(PROBES)
        shade.SetIntensityScale(STRENGTH)
        shade.BlurOn()
        solid = vtkCameraPass()
        solid.SetDelegatePass(_one_by_one(vtkLightsPass(), vtkOpaquePass()))
        shade.SetDelegatePass(solid)
        # Lashes and tears are drawn over the shaded face: as part of it they would throw shade from their whole width.
        self._pass = vtkOpenGLFXAAPass()
        self._pass.SetFXAAOptions(_along_edges_alone())
        self._pass.SetDelegatePass(_one_by_one(shade, vtkTranslucentPass(), vtkOverlayPass()))

    def switch(self, on: bool) -> None:
        """Draw with it from now on, or without."""
        wanted = self._pass if on else None
        if self._renderer.GetPass() is not wanted:
            self._renderer.SetPass(wanted)
            self._used = True

    def release(self) -> None:
        """Give back what it has on the graphics card, while the window of the renderer is still there."""
        if self._used:
            self.switch(False)
            window = self._renderer.GetRenderWindow()
            window.MakeCurrent()
            self._pass.ReleaseGraphicsResources(window)


def _along_edges_alone() -> vtkFXAAOptions:
    """Smooth the steps of long edges and nothing else: hairs are smooth already, and blurred ones become blots."""
    options = vtkFXAAOptions()
    options.SetSubpixelBlendLimit(0.0)
    return options


def _one_by_one(*passes: vtkRenderPass) -> vtkSequencePass:
    collection = vtkRenderPassCollection()
    for each in passes:
        collection.AddItem(each)
    made = vtkSequencePass()
    made.SetPasses(collection)
    return made

"""The neutral backdrop, a little lighter in the middle."""

from __future__ import annotations

from dataclasses import dataclass

from vtkmodules.vtkRenderingCore import vtkRenderer, vtkViewport


@dataclass(frozen=True)
class Backdrop:
    """Colours 0..1 of the middle and of the corners."""

    middle: tuple[float, float, float]
    edge: tuple[float, float, float]


STUDIO = Backdrop((0.325, 0.335, 0.350), (0.125, 0.130, 0.140))
DAYLIGHT = Backdrop((0.900, 0.905, 0.912), (0.735, 0.745, 0.760))
BACKDROPS = {"dark": STUDIO, "light": DAYLIGHT}


def hang(renderer: vtkRenderer, backdrop: Backdrop) -> None:
    """Put the backdrop behind everything."""
    renderer.SetBackground(*backdrop.middle)
    renderer.SetBackground2(*backdrop.edge)
    renderer.GradientBackgroundOn()
    renderer.SetGradientMode(vtkViewport.GradientModes.VTK_GRADIENT_RADIAL_VIEWPORT_FARTHEST_CORNER)
    renderer.DitherGradientOn()

"""The neutral backdrop, a little lighter in the middle."""

from __future__ import annotations

from dataclasses import dataclass

from vtkmodules.vtkRenderingCore import vtkRenderer, vtkViewport

from ui.viewport.complexion import Colour


@dataclass(frozen=True)
class Shade:
    """Colours 0..1 of the middle and of the corners."""

    middle: Colour
    edge: Colour


SHADES = {
    "dark": Shade((0.325, 0.335, 0.350), (0.125, 0.130, 0.140)),
    "light": Shade((0.900, 0.905, 0.912), (0.735, 0.745, 0.760)),
}


def hang(renderer: vtkRenderer, theme: str) -> None:
    """Put the backdrop of a theme, ``dark`` or ``light``, behind everything; dithered, so that no bands show."""
    shade = SHADES[theme]
    renderer.SetBackground(*shade.middle)
    renderer.SetBackground2(*shade.edge)
    renderer.GradientBackgroundOn()
    renderer.SetGradientMode(vtkViewport.GradientModes.VTK_GRADIENT_RADIAL_VIEWPORT_FARTHEST_CORNER)
    renderer.DitherGradientOn()

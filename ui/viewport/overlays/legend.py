"""A legend: colour bar, title and unit in a corner of the picture."""

from __future__ import annotations

import numpy as np
import vtkmodules.vtkRenderingFreeType  # noqa: F401 - without it VTK draws no text
from vtkmodules.vtkCommonCore import vtkLookupTable
from vtkmodules.vtkRenderingAnnotation import vtkScalarBarActor

from ui.viewport.colour_map import cividis

STEPS = 128
INK = (0.90, 0.91, 0.92)


def legend(title: str, top: float, ink: tuple[float, float, float] = INK) -> vtkScalarBarActor:
    """A vertical bar from zero to ``top``; ``title`` names the quantity and its unit."""
    table = vtkLookupTable()
    table.SetNumberOfTableValues(STEPS)
    table.SetTableRange(0.0, top)
    for k, colour in enumerate(cividis(np.linspace(0, 1, STEPS))):
        table.SetTableValue(k, *colour, 1.0)
    bar = vtkScalarBarActor()
    bar.SetLookupTable(table)
    bar.SetTitle(title)
    bar.SetNumberOfLabels(3)
    bar.UnconstrainedFontSizeOn()
    bar.SetLabelFormat("{:.1f}")
    for text, size in ((bar.GetTitleTextProperty(), 13), (bar.GetLabelTextProperty(), 12)):
        text.SetFontSize(size)
        text.SetColor(*ink)
        text.ItalicOff()
        text.BoldOff()
        text.ShadowOff()
        text.SetFontFamilyToArial()
    bar.SetPosition(0.03, 0.06)
    bar.SetWidth(0.055)
    bar.SetHeight(0.30)
    bar.SetVerticalTitleSeparation(8)
    return bar

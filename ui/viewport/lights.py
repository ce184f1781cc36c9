"""The lamps: key, fill and rim, fixed to the camera so that a face is well lit from wherever it is seen."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np
from vtkmodules.vtkRenderingCore import vtkLight, vtkRenderer

Colour = tuple[float, float, float]


@dataclass(frozen=True)
class Lamp:
    """A lamp far away.

    Attributes
    ----------
    name : what it is for
    towards : direction from the face to the lamp as the camera sees it: x right, y up, z to the viewer
    colour : linear light; its brightness is in it
    """

    name: str
    towards: Colour
    colour: Colour

    @property
    def direction(self) -> Colour:
        """Unit vector from the face to the lamp."""
        x, y, z = np.asarray(self.towards) / np.linalg.norm(self.towards)
        return float(x), float(y), float(z)


KEY = Lamp("key", (-0.55, 0.62, 0.75), (1.26, 1.18, 1.08))
FILL = Lamp("fill", (0.85, 0.10, 0.60), (0.20, 0.225, 0.265))
RIM = Lamp("rim", (0.70, 1.50, -0.75), (0.80, 0.82, 0.88))
"""High enough that nothing lights up under the jaw, where the neck would be in its way: no lamp here casts a shadow."""
LAMPS = (KEY, FILL, RIM)

SKY: Colour = (0.27, 0.28, 0.30)
GROUND: Colour = (0.170, 0.117, 0.094)
"""Light from all around, from above and from below, where it comes off shoulders and chest; linear."""


def light(renderer: vtkRenderer) -> None:
    """Replace the renderer's lights by the lamps; materials of our own read the table, the others these lights."""
    renderer.RemoveAllLights()
    renderer.AutomaticLightCreationOff()
    for lamp in LAMPS:
        source = vtkLight()
        source.SetLightTypeToCameraLight()
        source.SetPosition(*lamp.direction)
        source.SetFocalPoint(0.0, 0.0, 0.0)
        source.SetColor(*(min(1.0, c) for c in lamp.colour))
        renderer.AddLight(source)

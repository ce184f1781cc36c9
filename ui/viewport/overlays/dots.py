"""Round dots with a rim, as smooth as print at any size, seen through everything: what a hand can take hold of."""

from __future__ import annotations

from vtkmodules.vtkRenderingCore import vtkActor

from ui.viewport.overlays.marks import Colour, Marks

RIM = 2.0
"""Pixels of the dark rim, by which a dot is seen on any ground."""

DISC = """
  float away = SIZE * length(gl_PointCoord - vec2(0.5));
  float within = 1.0 - smoothstep(SIZE / 2.0 - 1.2, SIZE / 2.0, away);
  float inner = 1.0 - smoothstep(SIZE / 2.0 - RIM - 1.0, SIZE / 2.0 - RIM, away);
  if (within <= 0.0) discard;
  fragOutput0 = vec4(mix(vec3(0.09, 0.10, 0.11), diffuseColor, inner), within);
"""
"""A disc in the square that a point is drawn as."""


class Dots(Marks):
    """Dots in one colour with a dark rim.

    Parameters
    ----------
    colour : of the dots
    size : pixels from rim to rim
    rank : what has a larger one lies before what has a smaller one
    """

    def __init__(self, colour: Colour, size: float, rank: int = 0) -> None:
        super().__init__(colour, size, rank=rank)
        _rounded(self.actor, size)


def _rounded(actor: vtkActor, size: float) -> None:
    """Draw the points of an actor as discs; in the opaque pass, so that no skin is drawn over them."""
    actor.GetProperty().SetRenderPointsAsSpheres(False)
    actor.ForceOpaqueOn()
    disc = DISC.replace("SIZE", f"{size:.1f}").replace("RIM", f"{RIM:.1f}")
    actor.GetShaderProperty().AddFragmentShaderReplacement("//VTK::Light::Impl", True, disc, False)

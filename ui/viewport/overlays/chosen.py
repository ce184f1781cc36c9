"""The overlays of a scene by name, and which of them are on."""

from __future__ import annotations

from collections.abc import Collection

from vtkmodules.vtkRenderingCore import vtkRenderer

from ui.viewport.overlays.forces import ForcesOverlay
from ui.viewport.overlays.influence import InfluenceOverlay
from ui.viewport.overlays.muscles import MusclesOverlay
from ui.viewport.overlays.overlay import Drawn, Overlay
from ui.viewport.overlays.skull import SkullOverlay
from ui.viewport.overlays.supports import SupportsOverlay
from ui.viewport.overlays.wireframe import WireframeOverlay


class ChosenOverlays:
    """All that can be drawn with the skin, each of it on or off.

    Parameters
    ----------
    renderer : where they draw

    Attributes
    ----------
    skull : the bone, which can be carried and dyed
    by_name : each under the name that a view state has for it
    """

    def __init__(self, renderer: vtkRenderer) -> None:
        self.skull = SkullOverlay(renderer)
        self.by_name: dict[str, Overlay] = {
            "skull": self.skull,
            "muscles": MusclesOverlay(renderer),
            "forces": ForcesOverlay(renderer),
            "supports": SupportsOverlay(renderer),
            "wireframe": WireframeOverlay(renderer),
            "influence": InfluenceOverlay(renderer),
        }

    @property
    def names(self) -> Collection[str]:
        """The names of all of them."""
        return self.by_name.keys()

    def choose(self, drawn: Drawn, wanted: Collection[str], anew: Collection[str] = ()) -> None:
        """Switch those on that are wanted and all others off; what is on and to be made anew is."""
        for name, overlay in self.by_name.items():
            if name in wanted and (name in anew or not overlay.shown):
                overlay.show(drawn)
            elif name not in wanted and overlay.shown:
                overlay.hide()

    def follow(self, drawn: Drawn) -> None:
        """Let those that are on take over what is drawn now."""
        for overlay in self.by_name.values():
            if overlay.shown:
                overlay.follow(drawn)

    def rescale(self, drawn: Drawn) -> None:
        """Let those that have a size on the screen take over the scale of the picture."""
        if self.by_name["forces"].shown:
            self.by_name["forces"].follow(drawn)

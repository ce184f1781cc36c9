"""The force field of the expression in hand, or of the action unit that is worked on: thin arrows on the skin."""

from __future__ import annotations

import numpy as np

from ui.viewport.muscle_fields import FieldForces
from ui.viewport.overlays.arrows import ArrowField
from ui.viewport.overlays.overlay import Drawn, Overlay
from ui.viewport.overlays.supports import points_of_vertices

WEAKEST = 0.05
"""Share of the largest force below which no arrow is drawn."""
MOST = 700
"""Arrows drawn at most; of more, the strongest."""
LIFT = 0.4
"""Millimetres above the skin."""
COLOUR = (0.95, 0.52, 0.36)


class ForcesOverlay(Overlay):
    """Arrows along the force on every skin vertex."""

    def build(self, drawn: Drawn) -> None:
        """Make room for the arrows."""
        self._at = points_of_vertices(drawn.project.face, drawn.figure.posed.basis.display)
        self._forces = FieldForces(drawn.project)
        self._arrows = ArrowField(COLOUR, MOST)
        self.add(self._arrows.actor)

    def follow(self, drawn: Drawn) -> None:
        """Draw the forces on the posed skin."""
        force = self._forces.of(drawn.pulling)
        size = np.linalg.norm(force, axis=1)
        chosen = np.flatnonzero(size > WEAKEST * float(size.max(initial=0.0)))
        posed = drawn.figure.posed
        places = posed.points[self._at[chosen]] + LIFT * posed.normals[self._at[chosen]]
        self._arrows.show(places, force[chosen], 2 * drawn.half_height)

"""A face at rest, which can be drawn before anything is solved."""

from __future__ import annotations

from functools import lru_cache

import numpy as np

from facemodel.basis import Basis
from facemodel.project import Project
from facemodel.sampling import ELEMENTS, display_surface, head_surface


@lru_cache(maxsize=2)
def neutral_basis(project: Project) -> Basis:
    """A basis without fields, on which the neutral face can be drawn before anything is solved; remembered."""
    face, settings = project.face, project.settings
    display = display_surface(face, head_surface(face, ELEMENTS[settings.element]), settings.density)
    carried = sum(count for _, count in display.carried)
    return Basis(
        names=(),
        display=display,
        fields=np.zeros((0, 3 * (carried + display.moving)), dtype=np.float32),
        slopes=np.zeros((0, 6 * display.moving), dtype=np.float32),
        jaw=np.zeros((0, 3)),
    )

"""What a sculpting brush works on: the posed skin, and the fields of the unit in hand as far as they are in it."""

from __future__ import annotations

from collections.abc import Mapping

import numpy as np

from facemodel.actions import ActionUnit, Expression
from facemodel.basis import Basis
from facemodel.face import Face
from facemodel.painting.surface import PaintSurface
from facemodel.project import Project
from facemodel.sampling import points_of_vertices
from facemodel.sculpting.correction import NOTHING, Correction, correction_of, mirrored, movable, side_shares
from facemodel.sculpting.stroke import Layer, Sculpted
from fem.types import FloatArray, IntArray


def active_fields(unit: ActionUnit, expression: Expression) -> tuple[str, ...]:
    """The fields of a unit that weigh something in an expression."""
    return tuple(name for name in unit.fields if expression.get(name, 0.0) > 0)


def sculpt_work(
    project: Project,
    unit: ActionUnit,
    solved: Basis | None,
    expression: Expression,
    surface: PaintSurface,
    partners: IntArray | None = None,
) -> Sculpted:
    """What a stroke works on.

    Where both sides of a unit are seen, each takes what is sculpted on its own half of the face; a side that is seen
    alone takes all of it.

    Parameters
    ----------
    solved : fields without what is sculpted; a field that it does not have is taken for still
    expression : what is seen; some field of the unit weighs something in it
    surface : the skin at rest
    partners : (N,) vertex across the midline or -1, to sculpt both sides alike
    """
    face = project.face
    active = active_fields(unit, expression)
    whole = np.ones(len(face.skin.positions))
    shares = side_shares(unit, face.skin) if len(active) == len(unit.fields) else dict.fromkeys(active, whole)
    seen = {name: weight for name, weight in expression.items() if weight}
    fields = _at_vertices(face, solved, {*seen, *active})
    layers = {
        name: Layer(project.corrections.get(name, NOTHING), fields[name], expression[name], shares[name])
        for name in active
    }
    posed = face.skin.positions.copy()
    for name, weight in seen.items():
        posed += weight * fields[name]
        correction = project.corrections.get(name)
        if correction is not None:
            posed[correction.vertices] += weight * correction.share * correction.moved
    return Sculpted(surface, posed, layers, movable(face), partners)


def with_image(before: Correction, after: Correction, other: Correction, partners: IntArray) -> Correction:
    """The correction of the other side of a unit with the mirror image of what a stroke did to one side."""
    count = len(partners)
    done = correction_of(after.everywhere(count) - before.everywhere(count))
    return correction_of(other.everywhere(count) + mirrored(done, partners).everywhere(count), other)


def _at_vertices(face: Face, basis: Basis | None, names: set[str]) -> Mapping[str, FloatArray]:
    """Fields (N, 3) at the vertices of the skin, millimetres at activation 1."""
    still = np.zeros_like(face.skin.positions)
    if basis is None:
        return dict.fromkeys(names, still)
    at = points_of_vertices(face, basis.display)
    moving = at < basis.display.moving
    found = dict.fromkeys(names, still)
    for name in names & basis.index.keys():
        found[name] = still.copy()
        found[name][moving] = basis.moving_field(name)[at[moving]]
    return found

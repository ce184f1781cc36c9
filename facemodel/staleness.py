"""Which displacement fields a change of the project has made stale, found without solving anything."""

from __future__ import annotations

from typing import Any

from facemodel.actions import skin_fields
from facemodel.errors import FaceError
from facemodel.face import Face
from facemodel.jaw.modes import JawMode
from facemodel.project import Project
from facemodel.sameness import same
from facemodel.skull.spring_checks import spring_faults
from facemodel.sources import acting, recipes
from facemodel.system import face_material, face_supports, solved_vertices


def stale_fields(solved: Project, project: Project) -> frozenset[str]:
    """Fields of a project that a solution of another state of it does not hold for.

    Painting outside the solved region, renaming a muscle or giving a unit a note makes nothing stale.

    Parameters
    ----------
    solved : what the solution was solved from
    project : the project now; all of its fields are stale if it cannot be solved as it is
    """
    names = frozenset(skin_fields(project.units))
    held_alike = project.face is solved.face and project.settings == solved.settings
    if held_alike and project.muscles == solved.muscles and project.units == solved.units:
        return frozenset()
    if not held_alike and not (same(_common(solved), _common(project)) and _same_springs(solved.face, project.face)):
        return names
    try:
        before, after = _fields(solved), _fields(project)
    except FaceError:
        return names
    return frozenset(name for name in names if name not in before or not same(before[name], after[name]))


def _common(project: Project) -> tuple[Any, ...]:
    """What all fields depend on: the held face and how it is sampled."""
    face, skull = project.face, project.face.skull
    vertices = solved_vertices(face)
    carried = tuple((p.name, p.anchors, p.shares, p.mesh) for p in face.parts if p.carrier == "skin")
    skin = (face.skin.positions, face.skin.triangles, face.chart, face.solved)
    held = (
        face_material(face, vertices),
        face_supports(face, vertices),
        face.layers.stiffness[vertices],
        face.layers.thickness[vertices],
        face.layers.sliding[vertices],
        face.layers.volume[vertices],
        skull.anchors,
    )
    return project.settings, skin, held, carried


def _same_springs(one: Face, other: Face) -> bool:
    """Whether two faces of one skin and the same feet have the same springs left out, whatever their bones are."""
    bones = ((face.skull.cranium, face.skull.mandible) for face in (one, other))
    if same(*bones):
        return True
    left_out = (spring_faults(face, solved_vertices(face)).left_out for face in (one, other))
    return same(*left_out)


def _fields(project: Project) -> dict[str, tuple[Any, ...]]:
    """What each field depends on alone."""
    muscles = {muscle.key: muscle for muscle in project.muscles}
    hinge = (project.face.skull.jaw, project.face.skull.jawbone)
    jaws = {name: unit.jaw_of(name) for unit in project.units for name in unit.fields}

    def depends(source: str | JawMode) -> tuple[Any, ...]:
        return acting(muscles[source], project.face) if isinstance(source, str) else (source, hinge)

    return {
        name: (jaws[name], *((weight, depends(source)) for source, weight in recipe))
        for name, recipe in recipes(project).items()
    }

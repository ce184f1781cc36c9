"""New projects from the shipped faces."""

from __future__ import annotations

from facemodel.atlas import read_atlas
from facemodel.faces import DEFAULT_FACE, load_face
from facemodel.facs import action_units, emotions
from facemodel.project import Project
from resources import resource


def new_project(face_key: str = DEFAULT_FACE) -> Project:
    """A project on one of the shipped faces, with its muscles, all action units and the emotions, at rest.

    Raises
    ------
    UnknownNameError
        If there is no such face.
    """
    face = load_face(face_key)
    atlas = read_atlas(resource("atlas", f"{face_key}.json"))
    units = tuple(atlas.scaled(unit) for unit in action_units())
    return Project(face, atlas.muscles, units, emotions())

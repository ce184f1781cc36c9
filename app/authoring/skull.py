"""The skull of a project: moved, brought back; muscles, hinge and springs go with it."""

from __future__ import annotations

from dataclasses import replace

from facemodel.errors import SkullError
from facemodel.face import Pose, Skull
from facemodel.faces import face_keys, load_face
from facemodel.project import Project
from facemodel.sameness import same
from facemodel.skull.origins import with_origins_carried, with_origins_settled
from facemodel.skull.placement import placed, way_between


def with_pose(project: Project, pose: Pose, origins: bool = True) -> Project:
    """A project whose skull lies in another pose.

    Parameters
    ----------
    pose : where it lies, against where it was made
    origins : whether muscles go along with the bone that they come from; else they stay where they are

    Raises
    ------
    SkullError
        If it cannot lie there.
    """
    face = project.face
    if pose == face.skull.placement.pose:
        return project
    skull = placed(face, pose)
    muscles = project.muscles
    if origins:
        muscles = with_origins_carried(muscles, face, way_between(face.skull, pose))
    return replace(project, face=replace(face, skull=skull), muscles=muscles)


def with_skull(project: Project, skull: Skull, origins: bool = True) -> Project:
    """A project with another skull; where muscles are to follow, their origins come to lie on it."""
    after = replace(project.face, skull=skull)
    muscles = with_origins_settled(project.muscles, project.face, after) if origins else project.muscles
    return replace(project, face=after, muscles=muscles)


def at_template(project: Project, origins: bool = True) -> Project:
    """A project with the skull that its face is shipped with.

    Raises
    ------
    SkullError
        If its face is none of those, or its skin was cut otherwise.
    """
    skull = template_of(project)
    if same(skull, project.face.skull):
        return project
    back = with_pose(project, Pose(), origins)
    if same(skull.cranium.triangles, project.face.skull.cranium.triangles):
        # The same bone, only moved: what comes from it is back already, but for rounding.
        return replace(back, face=replace(back.face, skull=skull))
    return with_skull(back, skull, origins)


def template_of(project: Project) -> Skull:
    """The skull that the face of a project is shipped with; raises as `at_template` does."""
    face = project.face
    if face.key not in face_keys():
        raise SkullError(f"The face “{face.title}” is none of the shipped ones, so there is no skull to go back to.")
    skull = load_face(face.key).skull
    if len(skull.anchors) != len(face.skin.positions):
        raise SkullError(f"The skin of “{face.title}” is no longer the shipped one, so its skull would not fit.")
    return skull

"""The skull of a project: moved, snapped, brought back, replaced; muscles, hinge and springs go with it."""

from __future__ import annotations

from dataclasses import replace
from functools import lru_cache

from facemodel.errors import SkullError
from facemodel.face import Pose, Skull
from facemodel.faces import face_keys, load_face
from facemodel.mesh import Mesh
from facemodel.project import Project
from facemodel.sameness import same
from facemodel.skull.importing import skull_of
from facemodel.skull.jaw_proposal import proposed_jaw
from facemodel.skull.jaw_region import whole_skull, with_jaw
from facemodel.skull.origins import with_origins_carried, with_origins_settled
from facemodel.skull.placement import carried, placed, way_between
from facemodel.skull.snapping import snapped
from fem.types import BoolArray


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


def snapped_to_depths(project: Project, scales: bool = True, origins: bool = True) -> Project:
    """A project whose skull lies as deep under the landmarks as tables of tissue depth say, as nearly as it can.

    Raises
    ------
    SkullError
        If its face has too few landmarks, or the skull would have to leave the head.
    """
    return with_pose(project, snapped(project.face, scales), origins)


def with_jaw_region(project: Project, region: BoolArray) -> Project:
    """A project whose jaw is a region (M,) of its skull's vertices; raises as `facemodel.skull.jaw_region.with_jaw`."""
    return replace(project, face=with_jaw(project.face, region))


def with_bone(project: Project, bone: Mesh, origins: bool = True) -> Project:
    """A project whose skull is made of bone that lies in its head, one closed mesh in millimetres.

    Raises
    ------
    SkullError
        If the bone does not lie in the head.
    """
    return with_skull(project, skull_of(project.face, bone, known_skull(project)), origins)


def proposed_region(project: Project) -> BoolArray:
    """Vertices (M,) of the skull that may be its jaw, numbered as by `facemodel.skull.jaw_region.whole_skull`."""
    skull = project.face.skull
    bone, back = whole_skull(skull).mesh, way_between(skull, Pose())
    return proposed_jaw(bone.moved(carried(bone.positions, back)), known_skull(project))


def known_skull(project: Project) -> Skull:
    """A skull of the same head whose jaw, hinge and springs are known: the shipped one, else its own at rest."""
    try:
        return template_of(project)
    except SkullError:
        return placed(project.face, Pose())


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


def has_template(project: Project) -> bool:
    """Whether there is a skull to go back to, and the project has another one."""
    try:
        return not same(template_of(project), project.face.skull)
    except SkullError:
        return False


@lru_cache(maxsize=1)
def _shipped_skull(key: str) -> Skull:
    """Kept, because menus ask again and again whether there is one to go back to."""
    return load_face(key).skull


def template_of(project: Project) -> Skull:
    """The skull that the face of a project is shipped with; raises as `at_template` does."""
    face = project.face
    if face.key not in face_keys():
        raise SkullError(f"The face “{face.title}” is none of the shipped ones, so there is no skull to go back to.")
    skull = _shipped_skull(face.key)
    if len(skull.anchors) != len(face.skin.positions):
        raise SkullError(f"The skin of “{face.title}” is no longer the shipped one, so its skull would not fit.")
    return skull

"""Where one looks from: named views with a long portrait lens that frame the head whatever the window's shape."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass

import numpy as np
from scipy.spatial.transform import Rotation
from vtkmodules.vtkRenderingCore import vtkCamera, vtkRenderer

from facemodel.face import Face
from fem.types import FloatArray
from ui.viewport.complexion import has_features

LENS = 22.0
"""Vertical field in degrees: a long lens, as portraits are taken with."""
MARGIN = 1.12
"""The picture's height over that of the head."""
CHEEK_DEPTH = 35.0
"""Millimetres behind the eyes that a small picture still shows."""
CHIN_ROOM = 14.0
"""Millimetres under the chin, where it goes when the jaw opens."""
AROUND = 1.6
"""Half the diagonal of a head within which, about its middle, all lies that is drawn with it, however it is held."""
UP = np.array([0.0, 1.0, 0.0])
CENTRING = 4
"""Rounds in which the picture's middle is found; perspective makes each depend on the last."""
POLE = 88.0
"""Degrees above or below the horizon at which the orbit stops, so that the head never rolls."""

DIRECTIONS: Mapping[str, tuple[float, float]] = {
    "front": (0.0, 0.0),
    "left": (90.0, 0.0),
    "right": (-90.0, 0.0),
    "three-quarter": (35.0, 4.0),
    "top": (0.0, POLE),
}
"""Azimuth (towards the subject's left) and elevation in degrees from which each view looks."""


@dataclass(frozen=True, eq=False)
class Frame:
    """What a view has to hold.

    Attributes
    ----------
    centre : (3,) the point the camera turns about
    places : (n, 3) all that is to be seen
    """

    centre: FloatArray
    places: FloatArray


def head_frame(face: Face) -> Frame:
    """The whole head of a face."""
    places = face.skin.positions
    return Frame((places.min(axis=0) + places.max(axis=0)) / 2, places)


def face_frame(face: Face) -> Frame:
    """The face without crown and neck, for small pictures; the whole head where its features are unknown."""
    if not has_features(face):
        return head_frame(face)
    place = {name: face.skin.positions[vertex] for name, vertex in face.landmarks.items()}
    low, high = place["menton"][1] - CHIN_ROOM, place["frontal_eminence_L"][1]
    wide, back = abs(float(place["zygion_L"][0])), float(place["eye_outer_L"][2]) - CHEEK_DEPTH
    corners = np.array([[x, y, z] for x in (-wide, wide) for y in (low, high) for z in (back, place["nose_tip"][2])])
    return Frame(corners.mean(axis=0), corners)


def reach(renderer: vtkRenderer, box: FloatArray) -> None:
    """Let the camera see from before to behind all that is drawn with a head that fills a box (2, 3) at rest.

    Otherwise that would be found from every point anew whenever one moves.
    """
    low, high = box
    middle, far = (low + high) / 2, AROUND * float(np.linalg.norm(high - low)) / 2
    renderer.ResetCameraClippingRange([float(side) for at in middle for side in (at - far, at + far)])


def draw_all(renderer: vtkRenderer) -> None:
    """Leave out nothing that is not in the picture: to find out what would take longer than to draw it."""
    renderer.GetCullers().RemoveAllItems()


def direction(azimuth: float, elevation: float) -> FloatArray:
    """Unit vector from the head to the camera."""
    a, e = np.radians([azimuth, elevation])
    return np.array([np.sin(a) * np.cos(e), np.sin(e), np.cos(a) * np.cos(e)])


def look_from(camera: vtkCamera, frame: Frame, view: str, aspect: float) -> None:
    """Set the camera to a named view of a frame.

    Parameters
    ----------
    camera : the camera to set
    frame : what is to be seen
    view : one of `DIRECTIONS`
    aspect : width of the picture over its height

    Raises
    ------
    KeyError
        if there is no such view
    """
    look_along(camera, frame, *DIRECTIONS[view], aspect)


def level(facing: FloatArray) -> FloatArray:
    """A direction (3,) to look from as a unit vector, not too steep for the head to stay upright."""
    flat = float(np.hypot(facing[0], facing[2]))
    high = float(np.clip(facing[1], -flat, flat)) if flat > 0 else 0.0
    made = np.array([facing[0], high, facing[2]]) if flat > 0 else np.array([0.0, 0.0, 1.0])
    return np.asarray(made / np.linalg.norm(made))


def look_closely(renderer: vtkRenderer, centre: FloatArray, towards: FloatArray, half: float) -> None:
    """Look at a place (3,) from a unit direction (3,), with so many millimetres of it above and below."""
    camera = renderer.GetActiveCamera()
    distance = half / np.tan(np.radians(camera.GetViewAngle() / 2))
    camera.SetFocalPoint(*centre)
    camera.SetPosition(*(centre + distance * towards))
    camera.SetViewUp(*UP)
    camera.SetParallelScale(half)
    renderer.ResetCameraClippingRange()


def look_along(camera: vtkCamera, frame: Frame, azimuth: float, elevation: float, aspect: float) -> None:
    """Set the camera to a direction and as near as the frame allows."""
    towards = direction(azimuth, elevation)
    right = np.cross(UP, towards)
    right /= np.linalg.norm(right)
    up = np.cross(towards, right)
    tangent = np.tan(np.radians(LENS / 2)) / MARGIN
    focus = frame.centre
    for _ in range(CENTRING):
        offset = frame.places - focus
        near, across, along = offset @ towards, offset @ right, offset @ up
        distance = max((near + np.abs(along) / tangent).max(), (near + np.abs(across) / (tangent * aspect)).max())
        depth = distance - near
        focus = focus + distance / 2 * (_middle(across / depth) * right + _middle(along / depth) * up)
    camera.SetViewAngle(LENS)
    camera.SetFocalPoint(*focus)
    camera.SetPosition(*(focus + distance * towards))
    camera.SetViewUp(*UP)
    camera.SetParallelScale(max(np.abs(along).max(), np.abs(across).max() / aspect) * MARGIN)


def _middle(values: FloatArray) -> float:
    return float(values.min() + values.max())


def project_in_parallel(camera: vtkCamera, parallel: bool) -> None:
    """Switch between parallel and perspective projection with the picture's size kept."""
    if parallel == bool(camera.GetParallelProjection()):
        return
    half = np.tan(np.radians(camera.GetViewAngle() / 2))
    if parallel:
        camera.SetParallelScale(camera.GetDistance() * half)
    else:
        towards = -np.array(camera.GetDirectionOfProjection())
        distance = camera.GetParallelScale() / half
        camera.SetPosition(*(np.array(camera.GetFocalPoint()) + distance * towards))
    camera.SetParallelProjection(parallel)


def angles(camera: vtkCamera) -> tuple[float, float]:
    """Azimuth and elevation of the camera in degrees."""
    x, y, z = -np.array(camera.GetDirectionOfProjection())
    return float(np.degrees(np.arctan2(x, z))), float(np.degrees(np.arcsin(np.clip(y, -1.0, 1.0))))


def orbit(camera: vtkCamera, pivot: FloatArray, azimuth: float, elevation: float) -> None:
    """Turn about a point by degrees, upright for ever; the picture of the point stays where it is."""
    _, now = angles(camera)
    elevation = float(np.clip(now + elevation, -POLE, POLE) - now)
    position, focus = np.array(camera.GetPosition()), np.array(camera.GetFocalPoint())
    sideways = np.cross(np.array(camera.GetDirectionOfProjection()), UP)
    sideways /= np.linalg.norm(sideways)
    turn = Rotation.from_rotvec(np.radians(azimuth) * UP) * Rotation.from_rotvec(-np.radians(elevation) * sideways)
    camera.SetPosition(*(pivot + turn.apply(position - pivot)))
    camera.SetFocalPoint(*(pivot + turn.apply(focus - pivot)))
    camera.SetViewUp(*UP)


def pan(camera: vtkCamera, right: float, up: float) -> None:
    """Shift the picture by shares of its height."""
    towards = np.array(camera.GetDirectionOfProjection())
    sideways = np.cross(towards, np.array(camera.GetViewUp()))
    sideways /= np.linalg.norm(sideways)
    height = 2 * picture_scale(camera)
    move = -height * (right * sideways + up * np.cross(sideways, towards))
    camera.SetPosition(*(np.array(camera.GetPosition()) + move))
    camera.SetFocalPoint(*(np.array(camera.GetFocalPoint()) + move))


def picture_scale(camera: vtkCamera) -> float:
    """Half the height of the picture at the focal point, millimetres."""
    if camera.GetParallelProjection():
        return float(camera.GetParallelScale())
    return float(camera.GetDistance() * np.tan(np.radians(camera.GetViewAngle() / 2)))


def zoom(camera: vtkCamera, factor: float, right: float = 0.0, up: float = 0.0) -> None:
    """Bring the face nearer by a factor, towards a point of the picture.

    Parameters
    ----------
    factor : larger than one brings it nearer
    right, up : the point that stays in place, from the picture's centre in shares of its height
    """
    pan(camera, -right, -up)
    if camera.GetParallelProjection():
        camera.SetParallelScale(camera.GetParallelScale() / factor)
    else:
        focus, position = np.array(camera.GetFocalPoint()), np.array(camera.GetPosition())
        camera.SetPosition(*(focus + (position - focus) / factor))
    pan(camera, right, up)


def aspect_of(renderer: vtkRenderer) -> float:
    """Width over height of what a renderer draws into."""
    width, height = renderer.GetSize()
    return width / height if height else 1.0

"""The individuals that ship with Risorius."""

from __future__ import annotations

from facemodel.errors import UnknownNameError
from facemodel.face import Face
from facemodel.io.face_file import read_face
from resources import resource

DEFAULT_FACE = "ada"


def face_keys() -> tuple[str, ...]:
    """Keys of the shipped faces, the default one first."""
    keys = sorted(path.stem for path in resource("faces").glob("*.face"))
    return tuple(sorted(keys, key=lambda key: (key != DEFAULT_FACE, key)))


def load_face(key: str) -> Face:
    """One of the shipped faces.

    Raises
    ------
    UnknownNameError
        If there is no such face.
    """
    if key not in face_keys():
        raise UnknownNameError(f"There is no face “{key}”; choose one of {', '.join(face_keys())}.")
    return read_face(resource("faces", f"{key}.face"))

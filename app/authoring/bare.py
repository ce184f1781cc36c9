"""A bare copy of a face, to begin from nothing: no muscle, no paint, no action unit."""

from __future__ import annotations

from dataclasses import replace

import numpy as np

from facemodel.face import Face
from facemodel.painting.layers import PAINT_LAYERS
from facemodel.project import Project
from facemodel.projects import new_project


def bare_project(face_key: str) -> Project:
    """A project with the skin and the skull of a shipped face and nothing else.

    Raises
    ------
    UnknownNameError
        If there is no such face.
    """
    full = new_project(face_key)
    return replace(full, face=unpainted(full.face), muscles=(), units=(), emotions=(), expression={})


def unpainted(face: Face) -> Face:
    """The face with every layer at its default: even skin over even tissue, held nowhere but at its rim."""
    everywhere = np.arange(len(face.skin.positions))
    for layer in PAINT_LAYERS:
        delta = layer.delta(face, everywhere, layer.unpainted(face))
        face = replace(face, layers=delta.done(face.layers))
    return face

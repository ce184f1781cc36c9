"""A smile on a cheek that was painted stiff: what the tissue is made of decides what a muscle does."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
from pathlib import Path

import numpy as np
from scipy.spatial import cKDTree

from facemodel.actions import expand
from facemodel.animation.clip import Animation
from facemodel.animation.idle import Idle
from facemodel.animation.library import find_expression, placed
from facemodel.face import Face
from facemodel.painting.brush import falloff
from facemodel.painting.layers import LAYER, PaintLayer
from facemodel.project import Project
from facemodel.projects import new_project
from fem.types import FloatArray

SCAR = ("nasolabial_L", "cheek_L", "mid_masseter_L")
"""Landmarks of the line along which the cheek is stiff."""

PAINTED = (("stiffness", 0.03), ("stretching-along", 1.2), ("stretching-across", 1.2))
"""What is painted along it: tissue almost as firm as cartilage, under skin eight times as stiff as the rest."""

REACH, FIRM = 16.0, 6.0
"""Millimetres from that line within which anything is painted, and within which all of it is."""

SMILE = {"12": 1.0, "6": 0.6, "25": 0.4}


def smile_project(_folder: Path) -> Project:
    """A face whose left cheek follows its smile only half."""
    project = new_project()
    face = project.face
    for layer, value in PAINTED:
        face = _painted(face, LAYER[layer], value)
    animation = Animation(end=5.0, idle=Idle(seed=5))
    animation, _ = placed(animation, find_expression("happiness"), 0.6, project.units)
    return replace(project, face=face, expression=expand(SMILE, project.units), animation=animation)


def _painted(face: Face, layer: PaintLayer, value: float) -> Face:
    """A face with a value along the scar that fades to what was there."""
    distance = _from_scar(face)
    near = np.flatnonzero(distance < REACH)
    share = falloff(distance[near], REACH, FIRM / REACH)
    before = layer.values(face)[near]
    return replace(face, layers=layer.delta(face, near, before + share * (value - before)).done(face.layers))


def _from_scar(face: Face) -> FloatArray:
    """Distance (N,) of every skin vertex from the line of the scar, millimetres."""
    corners = face.skin.positions[[face.landmarks[name] for name in SCAR]]
    line = np.concatenate([start + np.linspace(0, 1, 40)[:, None] * (end - start) for start, end in pairwise(corners)])
    return np.asarray(cKDTree(line).query(face.skin.positions)[0])

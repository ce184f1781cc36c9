"""The tissue between skin and skull as springs (design section 4)."""

from __future__ import annotations

import numpy as np

from facemodel.face import Face
from facemodel.skull.spring_checks import spring_ends, spring_faults
from fem import SpringSet
from fem.types import FloatArray, IntArray

SLIDING = 12.0
"""How much stiffer tissue that nobody painted is along the normal than along the surface: skin slides over bone, and
70 to 95 % of the measured motion of scanned faces is along the surface."""

LEAST_SLANT = 0.02
"""Least tangential share of the struts that is scaled up; flatter struts carry nothing along the surface."""


def bone_depth(face: Face) -> FloatArray:
    """How far (N,) the bone lies below every vertex of the skin along its main spring, millimetres."""
    return np.asarray(np.linalg.norm(face.skull.anchors - face.skin.positions, axis=1))


def tissue_thickness(face: Face) -> FloatArray:
    """How thick (N,) the tissue is, millimetres: as painted, or as deep as the bone lies."""
    painted = face.layers.thickness > 0
    return np.where(painted, face.layers.thickness, bone_depth(face))


def tissue_stiffness(face: Face) -> FloatArray:
    """Stiffness (N,) of the main springs per area of skin, N/mm^3.

    The painted stiffness is that of tissue as thick as the bone is deep, modulus over depth.  Where another thickness
    is painted the modulus stays, and the spring is modulus over thickness (design section 4: 1/c = sum of l_h / c_h
    over l, for one tissue).
    """
    painted = face.layers.thickness > 0
    share = bone_depth(face) / np.where(painted, face.layers.thickness, 1.0)
    return np.where(painted, share, 1.0) * face.layers.stiffness


def tissue_springs(face: Face, vertices: IntArray) -> tuple[SpringSet, FloatArray, FloatArray]:
    """Main springs and struts of some skin vertices, with stiffness per area of skin.

    Every vertex has a main spring to its own point of the skull and struts to its neighbours' points.  The
    struts are scaled so that the tissue is as many times softer along the surface than along the main spring as its
    painted sliding says, whatever the density of the mesh.  Springs of no length and those that go through bone (see
    `facemodel.skull.spring_checks`) have no stiffness, and the struts that are left make up for those that are not.

    Parameters
    ----------
    face : whose skin, skull and painted stiffness are used
    vertices : (n,) skin vertices, in the order in which they are numbered in the result

    Returns
    -------
    springs : vertices numbered 0..n-1, stiffness in N/mm^3
    anchors : (M, 3) the skull end of every spring, millimetres
    jawbone : (M,) the share of that end which belongs to the mandible
    """
    head, foot = spring_ends(face.skin, vertices)
    kept = ~spring_faults(face, vertices).left_out
    strut_from = head[len(vertices) :]
    reach = face.skull.anchors[foot] - face.skin.positions[vertices[head]]
    length = np.linalg.norm(reach, axis=1, keepdims=True)
    directions = np.where(length > 0, reach / np.maximum(length, 1e-9), -face.skin.normals[vertices[head]])

    main = directions[: len(vertices)]
    struts = directions[len(vertices) :]
    slant = 1 - np.einsum("ij,ij->i", struts, main[strut_from]) ** 2
    tangential = np.bincount(strut_from, slant * kept[len(vertices) :], len(vertices)) / 2
    scale = 1 / (face.layers.sliding[vertices] * np.maximum(tangential, LEAST_SLANT))
    stiffness = tissue_stiffness(face)[vertices]
    share = np.concatenate([stiffness, (stiffness * scale)[strut_from]])
    return SpringSet(head, directions, share * kept), face.skull.anchors[foot], face.skull.jawbone[foot]

